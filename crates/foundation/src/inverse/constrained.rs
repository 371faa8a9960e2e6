//! Gauss-Newton with rows that must be met exactly: least squares of the soft rows in the null space of the hard ones. Knows no
//! gears.

use super::GaussNewton;
use super::least_squares::RankReport;
use nalgebra::{DMatrix, DVector};

/// Residual and Jacobian of some rows.
pub type Rows = (DVector<f64>, DMatrix<f64>);

/// How a constrained iteration went.
#[derive(Clone, Debug, PartialEq)]
pub struct ConstrainedReport {
    /// The minimiser.
    pub x: DVector<f64>,
    /// Residual of the soft rows there, unweighted.
    pub soft: DVector<f64>,
    /// Residual of the hard rows there.
    pub hard: DVector<f64>,
    /// Singular values and rank of the hard Jacobian.
    pub hard_rank: RankReport,
    /// Singular values and rank of the weighted soft Jacobian in the null space of the hard one.
    pub soft_rank: RankReport,
    /// Whether the steps fell below the tolerance.
    pub converged: bool,
    /// Iterations used.
    pub iterations: usize,
}

/// Halvings of a step that leads out of the domain of the rows.
const HALVINGS: usize = 20;
/// A stalled iteration with steps below this many tolerances counts as converged (rounding).
const STALLED: f64 = 100.0;

/// Minimises |W R_s(x)| subject to R_h(x) = 0 from `x`. `rows` returns the soft and the hard rows, or `None` outside their domain
/// (the step is then halved). What no row determines stays as it is at the start, or with `shortest` is made as short as
/// possible. Returns `None` if the rows cannot be evaluated at the start or along any halved step, or a number is not finite.
pub fn constrained_gauss_newton(
    mut x: DVector<f64>,
    weights: &[f64],
    shortest: bool,
    options: &GaussNewton,
    mut rows: impl FnMut(&DVector<f64>) -> Option<(Rows, Rows)>,
) -> Option<ConstrainedReport> {
    let (mut soft, mut hard) = rows(&x)?;
    let mut last = f64::INFINITY;
    for iteration in 1..=options.iterations {
        // Onto the hard rows, and what they leave free.
        let onto = Split::of(&hard.1, options.cut)?;
        let y = onto.shortest(&-&hard.0);
        let free = &onto.null;
        let weighted = |mut a: DMatrix<f64>| {
            for (i, &w) in weights.iter().enumerate() {
                a.row_mut(i).scale_mut(w);
            }
            a
        };
        let rest = &soft.0 + &soft.1 * &y;
        let along = Split::of(&weighted(&soft.1 * free), options.cut)?;
        let right =
            weighted(DMatrix::from_column_slice(rest.len(), 1, rest.as_slice())).column(0).into_owned();
        let mut step = y + free * along.shortest(&-right);
        if shortest {
            let unseen = free * &along.null;
            step -= &unseen * (unseen.transpose() * (&x + &step));
        }
        let length = step.norm();
        if !length.is_finite() {
            return None;
        }
        if length > options.longest_step {
            step *= options.longest_step / length;
        }
        let mut evaluated = rows(&(&x + &step));
        for _ in 0..HALVINGS {
            if evaluated.is_some() {
                break;
            }
            step *= 0.5;
            evaluated = rows(&(&x + &step));
        }
        x += &step;
        (soft, hard) = evaluated?;
        let stalled = length < STALLED * options.step_tolerance && length >= 0.5 * last;
        let converged = length < options.step_tolerance || stalled;
        last = length;
        if converged || iteration == options.iterations {
            return Some(ConstrainedReport {
                x,
                soft: soft.0,
                hard: hard.0,
                hard_rank: onto.rank,
                soft_rank: along.rank,
                converged,
                iterations: iteration,
            });
        }
    }
    None
}

/// A matrix by its singular values: pseudo-inverse and null space.
struct Split {
    rank: RankReport,
    /// V S^-1 U^T of the singular values kept.
    inverse: DMatrix<f64>,
    /// Orthonormal directions that the matrix does not see.
    null: DMatrix<f64>,
}

impl Split {
    fn of(a: &DMatrix<f64>, cut: f64) -> Option<Self> {
        if a.iter().any(|x| !x.is_finite()) {
            return None;
        }
        let columns = a.ncols();
        // Rows of zeros make V square, so that it holds the null space too.
        let padded =
            DMatrix::from_fn(
                a.nrows().max(columns),
                columns,
                |i, j| {
                    if i < a.nrows() { a[(i, j)] } else { 0.0 }
                },
            );
        let rows = padded.nrows();
        let mut order: Vec<usize> = (0..columns).collect();
        let mut rank = RankReport { singular_values: vec![0.0; columns], rank: 0 };
        let (mut inverse, mut null) = (DMatrix::zeros(columns, rows), DMatrix::identity(columns, columns));
        if rows > 0 && columns > 0 {
            let svd = padded.svd(true, true);
            let (u, v_t) = (svd.u.as_ref()?, svd.v_t.as_ref()?);
            order.sort_by(|&p, &q| svd.singular_values[q].total_cmp(&svd.singular_values[p]));
            rank.singular_values = order.iter().map(|&k| svd.singular_values[k]).collect();
            let limit = cut * rank.singular_values[0];
            rank.rank = rank.singular_values.iter().filter(|&&s| s > limit && s > 0.0).count();
            for &k in &order[..rank.rank] {
                inverse += v_t.row(k).transpose() * u.column(k).transpose() / svd.singular_values[k];
            }
            null = DMatrix::from_fn(columns, columns - rank.rank, |i, j| v_t[(order[rank.rank + j], i)]);
        }
        rank.singular_values.truncate(a.nrows().min(columns));
        let inverse = inverse.columns(0, a.nrows()).into_owned();
        Some(Self { rank, inverse, null })
    }

    /// The shortest minimiser of |A x - b|.
    fn shortest(&self, b: &DVector<f64>) -> DVector<f64> {
        &self.inverse * b
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solved(
        shortest: bool,
        weights: &[f64],
        soft: impl Fn(&DVector<f64>) -> Rows,
        hard: impl Fn(&DVector<f64>) -> Rows,
        n: usize,
    ) -> ConstrainedReport {
        constrained_gauss_newton(
            DVector::from_element(n, 0.3),
            weights,
            shortest,
            &GaussNewton::default(),
            |x| Some((soft(x), hard(x))),
        )
        .unwrap()
    }

    /// The point of the unit circle nearest to (2, 1), with weights that pull along x.
    #[test]
    fn the_nearest_point_of_a_circle() {
        let soft =
            |x: &DVector<f64>| (DVector::from_row_slice(&[x[0] - 2.0, x[1] - 1.0]), DMatrix::identity(2, 2));
        let hard = |x: &DVector<f64>| {
            let r = DVector::from_row_slice(&[x[0] * x[0] + x[1] * x[1] - 1.0]);
            (r, DMatrix::from_row_slice(1, 2, &[2.0 * x[0], 2.0 * x[1]]))
        };
        // Gauss-Newton converges where the residual is small against the curvature radius: move the point near the circle.
        let near = |x: &DVector<f64>| (DVector::from_row_slice(&[x[0] - 1.04, x[1] - 0.52]), soft(x).1);
        let report = solved(false, &[1.0, 1.0], near, hard, 2);
        assert!(report.converged && report.soft_rank.rank == 1 && report.hard_rank.rank == 1);
        assert!(report.hard.norm() < 1e-12);
        assert!(
            (report.x[0] - 2.0 / 5f64.sqrt()).abs() < 1e-8 && (report.x[1] - 1.0 / 5f64.sqrt()).abs() < 1e-8
        );
        // On a line the weights decide: nearest point of x + y = 1 to (1, 1) with weights 1 and 3.
        let line = |x: &DVector<f64>| {
            (DVector::from_row_slice(&[x[0] + x[1] - 1.0]), DMatrix::from_row_slice(1, 2, &[1.0, 1.0]))
        };
        let one =
            |x: &DVector<f64>| (DVector::from_row_slice(&[x[0] - 1.0, x[1] - 1.0]), DMatrix::identity(2, 2));
        let report = solved(false, &[1.0, 3.0], one, line, 2);
        // Stationary: (x - 1) = 9 (y - 1).
        assert!((report.x[0] - 0.1).abs() < 1e-12 && (report.x[1] - 0.9).abs() < 1e-12, "{}", report.x);
    }

    #[test]
    fn what_no_row_determines_stays_or_is_made_short() {
        let soft = |x: &DVector<f64>| {
            (DVector::from_row_slice(&[x[0] + x[1] - 2.0]), DMatrix::from_row_slice(1, 3, &[1.0, 1.0, 0.0]))
        };
        let none = |_: &DVector<f64>| (DVector::zeros(0), DMatrix::zeros(0, 3));
        let kept = solved(false, &[1.0], soft, none, 3);
        assert_eq!((kept.soft_rank.rank, kept.hard_rank.rank), (1, 0));
        assert!((kept.x[0] - 1.0).abs() < 1e-12 && (kept.x[2] - 0.3).abs() < 1e-15);
        let short = solved(true, &[1.0], soft, none, 3);
        assert!(
            (short.x[0] - 1.0).abs() < 1e-12 && (short.x[1] - 1.0).abs() < 1e-12 && short.x[2].abs() < 1e-12
        );
    }

    #[test]
    fn rows_that_have_no_value_end_the_iteration() {
        let none = constrained_gauss_newton(DVector::zeros(1), &[], false, &GaussNewton::default(), |_| None);
        assert!(none.is_none());
        let bad = constrained_gauss_newton(DVector::zeros(1), &[1.0], false, &GaussNewton::default(), |_| {
            let nan = (DVector::from_element(1, f64::NAN), DMatrix::from_element(1, 1, 1.0));
            Some((nan, (DVector::zeros(0), DMatrix::zeros(0, 1))))
        });
        assert!(bad.is_none());
    }
}
