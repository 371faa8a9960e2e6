//! Where rows lie on a column: equal parameters, equal arcs, or equal scallops (`docs/mathematics/milling.md`).

use super::{ColumnPlane, MillingError, Section};
use foundation::numerics::{Chebyshev, monotone_root};

/// The law by which rows are spaced between root and tip.
#[derive(Clone, Copy)]
pub enum RowSpacing<'a> {
    /// Equal steps of the height parameter.
    Parameter,
    /// Equal arcs of the column.
    Arc,
    /// Equal integrals of a weight over the arc: with the root of the effective curvature, equal scallops.
    Weighted(&'a (dyn Fn(&ColumnPlane, &Section) -> Result<f64, MillingError> + Sync)),
}

/// Nodes over a column, doubled until the last quarter of the coefficients is below this share of the whole.
const NODES: [usize; 5] = [9, 17, 33, 65, 129];
const TAIL: f64 = 1e-12;
/// Share with which the weight is known at least.
const ROUGHLY: f64 = 1e-2;

/// Heights of `count` rows (>= 2) from root to tip on one column, and the whole integral of the law's weight: mm for arcs.
///
/// # Errors
/// Those of the sections; [`MillingError::SpacingNotSmooth`] if the weight cannot be integrated.
pub fn row_heights(
    plane: &ColumnPlane,
    count: usize,
    law: RowSpacing,
) -> Result<(Vec<f64>, f64), MillingError> {
    let [root, tip] = plane.heights()?;
    let share = |row: usize| row as f64 / (count - 1) as f64;
    // Both ends exactly, whatever the rounding in between.
    let between = |p: f64| if p == 1.0 { tip } else { root + p * (tip - root) };
    if matches!(law, RowSpacing::Parameter) {
        return Ok(((0..count).map(|row| between(share(row))).collect(), (tip - root).abs()));
    }
    let mut start = plane.lead().u;
    let mut weight = |p: f64| -> Result<f64, MillingError> {
        let section = plane.section(between(p), start)?;
        start = section.length;
        let speed = plane.speed(&section) * (tip - root).abs();
        Ok(match law {
            RowSpacing::Weighted(of) => speed * of(plane, &section)?,
            _ => speed,
        })
    };
    let not_smooth = |tail| MillingError::SpacingNotSmooth { u: plane.lead().u, tail };
    let mut worst = f64::INFINITY;
    let mut series = None;
    for nodes in NODES {
        let fitted = Chebyshev::fit(0.0, 1.0, nodes, &mut weight)?;
        worst = fitted.tail() / fitted.coefficients()[0].abs();
        let settled = worst < TAIL;
        series = Some(fitted);
        if settled {
            break;
        }
    }
    // The weight of a scallop has roots in it and settles more slowly, and at the edge of a relief it leaps; its integral, by which the rows stand,
    // is known a hundred times as well.
    let series = series.filter(|_| worst < ROUGHLY).ok_or_else(|| not_smooth(worst))?;
    let integral = series.integral();
    let whole = integral.value(1.0);
    let mut heights = Vec::with_capacity(count);
    for row in 0..count {
        let p = match row {
            0 => 0.0,
            _ if row + 1 == count => 1.0,
            _ => {
                let wanted = share(row) * whole;
                let near = share(row);
                near + monotone_root(|step| (integral.value(near + step) - wanted, series.value(near + step)))
            }
        };
        if !(0.0..=1.0).contains(&p) {
            return Err(not_smooth(worst));
        }
        heights.push(between(p));
    }
    Ok((heights, whole))
}
