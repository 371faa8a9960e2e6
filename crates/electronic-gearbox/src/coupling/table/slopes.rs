//! Slopes of the spline with continuous second derivative: one tridiagonal system, at load time.

use super::{EndRule, bad, check_finite, check_knots};
use crate::{Error, TableFault};

/// Fills `slopes` with the slopes at the knots, dy/dx, for [`super::CubicTable::new`]. `workspace` is room for at least twice as many
/// numbers as `values` has; its content is of no use afterwards.
///
/// # Errors
/// [`Error::BadTable`] for values or distances that make no table, for storage of the wrong length, and where a slope is not finite.
pub fn solve_slopes(
    values: &[f64],
    spacing: f64,
    ends: EndRule,
    slopes: &mut [f64],
    workspace: &mut [f64],
) -> Result<(), Error> {
    check_knots(values, spacing, ends)?;
    if slopes.len() != values.len() {
        return Err(bad(TableFault::Storage { values: values.len(), slopes: slopes.len() }));
    }
    let needed = values.len().saturating_mul(2);
    let Some((factors, corner)) =
        workspace.get_mut(..needed).and_then(|room| room.split_at_mut_checked(values.len()))
    else {
        return Err(bad(TableFault::Workspace { needed, given: workspace.len() }));
    };
    match ends {
        EndRule::Natural => natural(values, spacing, slopes, factors),
        EndRule::Periodic => periodic(values, spacing, slopes, factors, corner),
    }
    check_finite(slopes)
}

/// 2 m_0 + m_1 = 3 (y_1 - y_0)/h;  m_(i-1) + 4 m_i + m_(i+1) = 3 (y_(i+1) - y_(i-1))/h;  and at the end as at the beginning.
fn natural(values: &[f64], spacing: f64, slopes: &mut [f64], factors: &mut [f64]) {
    differences(values, spacing, slopes);
    if let (&[first, second, ..], Some(right)) = (values, slopes.first_mut()) {
        *right = 3.0 * (second - first) / spacing;
    }
    if let (&[.., before, last], Some(right)) = (values, slopes.last_mut()) {
        *right = 3.0 * (last - before) / spacing;
    }
    factorise(factors, 2.0, 2.0);
    solve(factors, slopes);
}

/// The same with 4 on the whole diagonal and the corners closed, m_N = m_0: the system without corners and a correction of rank one
/// (Sherman and Morrison), with u = (-4, 0, .., 0, 1) and v = (1, 0, .., 0, -1/4).
fn periodic(values: &[f64], spacing: f64, slopes: &mut [f64], factors: &mut [f64], corner: &mut [f64]) {
    differences(values, spacing, slopes);
    // One period has N unknowns.
    let period = values.len().saturating_sub(1);
    if let (Some(&second), Some(&before)) = (values.get(1), values.get(period.saturating_sub(1)))
        && let Some(right) = slopes.first_mut()
    {
        *right = 3.0 * (second - before) / spacing;
    }
    if let (Some(unknowns), Some(factors), Some(corner)) =
        (slopes.get_mut(..period), factors.get_mut(..period), corner.get_mut(..period))
    {
        if period < 3 {
            // Every right-hand side is a difference over the whole period, 0.
            unknowns.fill(0.0);
        } else {
            factorise(factors, 8.0, 4.25);
            solve(factors, unknowns);
            corner.fill(0.0);
            if let [first, .., last] = corner {
                (*first, *last) = (-4.0, 1.0);
            }
            solve(factors, corner);
            let share = closing(unknowns) / (1.0 + closing(corner));
            for (slope, part) in unknowns.iter_mut().zip(corner) {
                *slope -= share * *part;
            }
        }
    }
    if let [first, .., last] = slopes {
        *last = *first;
    }
}

/// v times a vector.
fn closing(list: &[f64]) -> f64 {
    match list {
        &[first, .., last] => first - last / 4.0,
        _ => 0.0,
    }
}

/// Right-hand sides of the inner knots.
fn differences(values: &[f64], spacing: f64, right: &mut [f64]) {
    for (neighbours, right) in values.windows(3).zip(right.iter_mut().skip(1)) {
        if let &[before, _, after] = neighbours {
            *right = 3.0 * (after - before) / spacing;
        }
    }
}

/// Reciprocal pivots of the matrix with 1 beside the diagonal, 4 on it, and other numbers at its ends. All pivots are above 1.
fn factorise(factors: &mut [f64], first: f64, last: f64) {
    let count = factors.len();
    let mut before = 0.0;
    for (row, factor) in factors.iter_mut().enumerate() {
        let diagonal = match row {
            0 => first,
            _ if row + 1 == count => last,
            _ => 4.0,
        };
        *factor = 1.0 / (diagonal - before);
        before = *factor;
    }
}

/// Forward and backward substitution (Thomas).
fn solve(factors: &[f64], right: &mut [f64]) {
    let mut before = 0.0;
    for (factor, right) in factors.iter().zip(right.iter_mut()) {
        *right = (*right - before) * factor;
        before = *right;
    }
    let mut after = 0.0;
    for (factor, right) in factors.iter().zip(right.iter_mut()).rev() {
        *right -= after * factor;
        after = *right;
    }
}
