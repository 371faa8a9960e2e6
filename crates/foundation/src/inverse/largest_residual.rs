//! Linear fits that make the largest residual least: a linear programme over the samples that count, by interior points.
//! Knows no gears.

use super::MinimumNorm;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, NonnegativeConeT, SolverStatus};

/// A fit whose largest residual is least.
#[derive(Clone, Debug, PartialEq)]
pub struct LargestResidual {
    /// Solution.
    pub x: Vec<f64>,
    /// Largest |b - A x| over all rows.
    pub largest: f64,
    /// No x has a smaller largest residual than this (to the accuracy of the interior points): the optimum of the rows
    /// that were looked at last.
    pub bound: f64,
}

/// Problems with at most this many rows are solved at once.
const WHOLE: usize = 3000;
/// Rows added in a round.
const ADDED: usize = 400;
/// Rounds at most; the rows that count are found in fewer than ten.
const ROUNDS: usize = 40;
/// Rows may exceed the optimum of the others by this share of it.
const EXCESS: f64 = 1e-7;
/// Accuracy asked of the interior points, of a problem scaled to residuals of 1.
const ACCURACY: f64 = 1e-9;
/// A start whose residuals are below this share of the right side is exact to rounding: nothing to make smaller.
const EXACT: f64 = 1e-13;

/// Fills a list with the entries (column, value) of a row and returns its right side.
type Row<'a> = &'a mut dyn FnMut(usize, &mut Vec<(usize, f64)>) -> f64;

/// Minimises the largest |b_i - A_i x|, starting from a least-squares solution and along its steps: x stays free of what
/// A does not see. `row` clears the list, fills it with the entries (column, value) of row i and returns b_i. `None` if the
/// interior points do not converge.
pub fn minimise_largest_residual(start: &MinimumNorm, rows: usize, row: Row<'_>) -> Option<LargestResidual> {
    let steps = start.steps(rows);
    let size = largest(&residuals(&vec![0.0; start.x.len()], rows, row));
    let first = residuals(&start.x, rows, row);
    let mut best = LargestResidual { x: start.x.clone(), largest: largest(&first), bound: 0.0 };
    let unit = best.largest;
    if !unit.is_finite() {
        return None;
    }
    if unit <= EXACT * size {
        return Some(best);
    }
    let mut active = first_rows(&first);
    for _ in 0..ROUNDS {
        let (lengths, optimum) = solve(&steps, &active, unit, &first, row)?;
        let mut x = start.x.clone();
        for (step, length) in steps.iter().zip(&lengths) {
            for (x, d) in x.iter_mut().zip(step) {
                *x += d * length * unit;
            }
        }
        let now = residuals(&x, rows, row);
        best.bound = best.bound.max(optimum * unit);
        let reached = largest(&now);
        if reached < best.largest {
            best.x = x;
            best.largest = reached;
        }
        let limit = (optimum * (1.0 + EXCESS) + 10.0 * ACCURACY) * unit;
        let before = active.len();
        add_violated(&mut active, &now, limit);
        if active.len() == before {
            best.bound = best.bound.min(best.largest);
            return Some(best);
        }
    }
    None
}

/// b - A x.
fn residuals(x: &[f64], rows: usize, row: Row<'_>) -> Vec<f64> {
    let mut entries = Vec::new();
    (0..rows).map(|i| row(i, &mut entries) - entries.iter().map(|&(j, a)| a * x[j]).sum::<f64>()).collect()
}

fn largest(values: &[f64]) -> f64 {
    // Written so that a NaN comes through.
    values.iter().fold(0.0, |m: f64, x| if x.abs() <= m { m } else { x.abs() })
}

/// Rows to begin with: all, or every n-th and the worst of every stretch.
fn first_rows(residuals: &[f64]) -> Vec<usize> {
    let rows = residuals.len();
    if rows <= WHOLE {
        return (0..rows).collect();
    }
    let mut active: Vec<usize> = (0..rows).step_by(rows.div_ceil(WHOLE / 2)).collect();
    add_violated(&mut active, residuals, 0.0);
    active
}

/// Adds the worst row of every stretch whose worst exceeds the limit and is not among the rows yet.
fn add_violated(active: &mut Vec<usize>, residuals: &[f64], limit: f64) {
    let stretch = residuals.len().div_ceil(ADDED);
    let worst = |(k, part): (usize, &[f64])| {
        let (i, r) = part.iter().map(|r| r.abs()).enumerate().max_by(|a, b| a.1.total_cmp(&b.1))?;
        (r > limit).then_some(k * stretch + i)
    };
    active.extend(residuals.chunks(stretch.max(1)).enumerate().filter_map(worst));
    active.sort_unstable();
    active.dedup();
}

/// min e with |r_i - A_i sum_k q_k step_k| <= e over the active rows, r scaled by `unit`; q and e.
fn solve(
    steps: &[Vec<f64>],
    active: &[usize],
    unit: f64,
    residuals: &[f64],
    row: Row<'_>,
) -> Option<(Vec<f64>, f64)> {
    let (count, columns) = (active.len(), steps.len());
    let mut by_column = vec![vec![0.0; count]; columns];
    let mut entries = Vec::new();
    for (k, &i) in active.iter().enumerate() {
        row(i, &mut entries);
        for (column, step) in by_column.iter_mut().zip(steps) {
            column[k] = entries.iter().map(|&(j, a)| a * step[j]).sum();
        }
    }
    let mut right: Vec<f64> = active.iter().map(|&i| residuals[i] / unit).collect();
    right.extend_from_within(..);
    right[count..].iter_mut().for_each(|r| *r = -*r);
    // A q - e <= r and -A q - e <= -r.
    let (mut starts, mut index, mut values) = (vec![0], Vec::new(), Vec::new());
    for column in &by_column {
        index.extend(0..2 * count);
        values.extend(column.iter().copied());
        values.extend(column.iter().map(|a| -a));
        starts.push(index.len());
    }
    index.extend(0..2 * count);
    values.extend(std::iter::repeat_n(-1.0, 2 * count));
    starts.push(index.len());
    let a = CscMatrix::new(2 * count, columns + 1, starts, index, values);
    let mut cost = vec![0.0; columns + 1];
    cost[columns] = 1.0;
    let settings = DefaultSettings {
        verbose: false,
        max_threads: 1,
        direct_solve_method: "qdldl".into(),
        tol_gap_abs: ACCURACY,
        tol_gap_rel: ACCURACY,
        tol_feas: ACCURACY,
        ..DefaultSettings::default()
    };
    let none = CscMatrix::zeros((columns + 1, columns + 1));
    let cones = [NonnegativeConeT(2 * count)];
    let mut solver = DefaultSolver::new(&none, &cost, &a, &right, &cones, settings).ok()?;
    solver.solve();
    let solution = &solver.solution;
    let good = matches!(solution.status, SolverStatus::Solved | SolverStatus::AlmostSolved);
    let finite = solution.x.iter().all(|x| x.is_finite());
    (good && finite).then(|| (solution.x[..columns].to_vec(), solution.obj_val_dual.max(0.0)))
}

#[cfg(test)]
mod tests {
    use super::super::RowReduction;
    use super::*;

    /// A straight line through samples of a function on [-1, 1]; the third column repeats the first.
    fn line(count: usize, f: impl Fn(f64) -> f64) -> LargestResidual {
        let mut row = |i: usize, entries: &mut Vec<(usize, f64)>| {
            let x = 2.0 * i as f64 / (count - 1) as f64 - 1.0;
            entries.clear();
            entries.extend([(0, 1.0), (1, x), (2, 1.0)]);
            f(x)
        };
        let mut reduction = RowReduction::new(3, count);
        let mut entries = Vec::new();
        for i in 0..count {
            let right = row(i, &mut entries);
            reduction.push(&entries, right);
        }
        minimise_largest_residual(&reduction.solve(1e-11).unwrap(), count, &mut row).unwrap()
    }

    #[test]
    fn parabola_by_a_line_is_known() {
        // x^2 by a + b x: a = 1/2, b = 0, largest error 1/2, reached at -1, 0, 1.
        for count in [3, 101, 20_001] {
            let fit = line(count, |x| 1e-3 * x * x);
            assert!((fit.x[0] + fit.x[2] - 0.5e-3).abs() < 1e-10, "{fit:?}");
            assert!(fit.x[1].abs() < 1e-10);
            assert!((fit.largest - 0.5e-3).abs() < 1e-10);
            assert!(fit.bound <= fit.largest && fit.largest - fit.bound < 1e-10);
        }
    }

    #[test]
    fn many_rows_are_solved_by_the_few_that_count() {
        let fit = line(50_001, |x| x.exp());
        // The line that meets exp on [-1, 1] best has slope sinh 1 and its error at -1, ln(slope) and 1, with alternating signs.
        let slope = 1f64.sinh();
        let inner = slope.ln();
        let error = 0.5 * (1f64.exp() - slope - (inner.exp() - slope * inner));
        assert!((fit.x[1] - slope).abs() < 1e-6 && (fit.largest - error).abs() < 1e-7, "{fit:?} {error}");
    }

    #[test]
    fn exact_starts_stay() {
        let fit = line(11, |_| 0.0);
        assert_eq!((fit.x, fit.largest, fit.bound), (vec![0.0; 3], 0.0, 0.0));
    }
}
