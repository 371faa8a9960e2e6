//! Gauss-Newton for overdetermined systems with weights, by singular values.

use super::least_squares::{RankReport, weighted_least_squares};
use nalgebra::{DMatrix, DVector};

/// How long and how far to iterate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GaussNewton {
    /// Converged when a step is shorter than this.
    pub step_tolerance: f64,
    /// Longest step.
    pub longest_step: f64,
    /// Relative singular value below which directions are left alone.
    pub cut: f64,
    /// Most iterations.
    pub iterations: usize,
}

impl Default for GaussNewton {
    fn default() -> Self {
        Self { step_tolerance: 1e-9, longest_step: 3.0, cut: 1e-12, iterations: 50 }
    }
}

/// How an iteration went.
#[derive(Clone, Debug, PartialEq)]
pub struct GaussNewtonReport {
    /// The minimiser.
    pub x: DVector<f64>,
    /// Residual there, unweighted.
    pub residual: DVector<f64>,
    /// Rank of the last Jacobian.
    pub rank: RankReport,
    /// Whether the steps fell below the tolerance.
    pub converged: bool,
    /// Iterations used.
    pub iterations: usize,
}

/// Minimises |W R(x)| from `x`. `rows` returns residual and Jacobian, or `None` outside their domain (the step is then
/// halved). Returns `None` if the rows cannot be evaluated at the start or along any halved step.
pub fn gauss_newton(
    mut x: DVector<f64>,
    weights: Option<&[f64]>,
    options: &GaussNewton,
    mut rows: impl FnMut(&DVector<f64>) -> Option<(DVector<f64>, DMatrix<f64>)>,
) -> Option<GaussNewtonReport> {
    let (mut residual, mut jacobian) = rows(&x)?;
    for iteration in 1..=options.iterations {
        let solved = weighted_least_squares(&jacobian, &-&residual, weights, options.cut)?;
        let mut step = solved.x;
        let length = step.norm();
        if length > options.longest_step {
            step *= options.longest_step / length;
        }
        let mut evaluated = rows(&(&x + &step));
        for _ in 0..20 {
            if evaluated.is_some() {
                break;
            }
            step *= 0.5;
            evaluated = rows(&(&x + &step));
        }
        x += &step;
        (residual, jacobian) = evaluated?;
        if length < options.step_tolerance || iteration == options.iterations {
            let converged = length < options.step_tolerance;
            return Some(GaussNewtonReport {
                x,
                residual,
                rank: solved.rank,
                converged,
                iterations: iteration,
            });
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fits_an_exponential() {
        let t = [0.0, 0.5, 1.0, 1.5, 2.0];
        let rows = |x: &DVector<f64>| {
            let r = DVector::from_fn(5, |i, _| x[0] * (x[1] * t[i]).exp() - 2.0 * (-0.7 * t[i]).exp());
            let j = DMatrix::from_fn(5, 2, |i, k| {
                let e = (x[1] * t[i]).exp();
                if k == 0 { e } else { x[0] * t[i] * e }
            });
            Some((r, j))
        };
        let report =
            gauss_newton(DVector::from_row_slice(&[1.0, 0.0]), None, &GaussNewton::default(), rows).unwrap();
        assert!(report.converged && report.rank.rank == 2);
        assert!((report.x[0] - 2.0).abs() < 1e-10 && (report.x[1] + 0.7).abs() < 1e-10);
    }
}
