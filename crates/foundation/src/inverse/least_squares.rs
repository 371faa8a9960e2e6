//! Weighted linear least squares by singular values, with a report of the rank.

use nalgebra::{DMatrix, DVector};

/// Singular values and what of them was used.
#[derive(Clone, Debug, PartialEq)]
pub struct RankReport {
    /// Singular values, descending.
    pub singular_values: Vec<f64>,
    /// How many were kept.
    pub rank: usize,
}

/// Solution of a linear least-squares problem.
#[derive(Clone, Debug, PartialEq)]
pub struct LeastSquares {
    /// Minimum-norm solution.
    pub x: DVector<f64>,
    /// Residual A x - b, unweighted.
    pub residual: DVector<f64>,
    /// Rank of the weighted matrix.
    pub rank: RankReport,
}

/// Minimises |W (A x - b)| with the diagonal weights `weights` (all 1 when `None`); singular values below
/// `cut` times the largest are dropped (minimum-norm solution in their directions). `None` if a number is not finite.
pub fn weighted_least_squares(
    a: &DMatrix<f64>,
    b: &DVector<f64>,
    weights: Option<&[f64]>,
    cut: f64,
) -> Option<LeastSquares> {
    let mut wa = a.clone();
    let mut wb = b.clone();
    if let Some(weights) = weights {
        for (i, &w) in weights.iter().enumerate() {
            wa.row_mut(i).scale_mut(w);
            wb[i] *= w;
        }
    }
    if wa.iter().chain(wb.iter()).any(|x| !x.is_finite()) {
        return None;
    }
    let svd = wa.svd(true, true);
    let largest = svd.singular_values.max();
    let limit = cut * largest;
    let rank = svd.singular_values.iter().filter(|&&s| s > limit && s > 0.0).count();
    let x = svd.solve(&wb, limit.max(f64::MIN_POSITIVE)).ok()?;
    let residual = a * &x - b;
    let mut singular_values: Vec<f64> = svd.singular_values.iter().copied().collect();
    singular_values.sort_by(|p, q| q.total_cmp(p));
    Some(LeastSquares { x, residual, rank: RankReport { singular_values, rank } })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rank_deficient_problem_takes_the_minimum_norm() {
        let a = DMatrix::from_row_slice(3, 2, &[1.0, 1.0, 2.0, 2.0, 3.0, 3.0]);
        let b = DVector::from_row_slice(&[2.0, 4.0, 6.0]);
        let solved = weighted_least_squares(&a, &b, None, 1e-11).unwrap();
        assert_eq!(solved.rank.rank, 1);
        assert!((solved.x[0] - 1.0).abs() < 1e-14 && (solved.x[1] - 1.0).abs() < 1e-14);
        assert!(solved.residual.norm() < 1e-13);
    }

    #[test]
    fn weights_decide_between_rows_that_disagree() {
        let a = DMatrix::from_row_slice(2, 1, &[1.0, 1.0]);
        let b = DVector::from_row_slice(&[0.0, 1.0]);
        let solved = weighted_least_squares(&a, &b, Some(&[1.0, 3.0]), 1e-11).unwrap();
        assert!((solved.x[0] - 0.9).abs() < 1e-14);
        assert!(weighted_least_squares(&a, &DVector::from_row_slice(&[f64::NAN, 1.0]), None, 0.0).is_none());
    }
}
