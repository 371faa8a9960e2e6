//! Least-squares fits into the class of polynomials that motion, dresser and lines carry (`docs/mathematics/planning.md`). Knows points and
//! values only: no target, no plan.

use foundation::numerics::Polynomial2;
use nalgebra::{DMatrix, DVector};

/// Exponents of the class used for fits: u^i y^j with i + j <= 3, and u^4, u^5.
const CLASS: [(usize, usize); 12] =
    [(0, 0), (0, 1), (0, 2), (0, 3), (1, 0), (1, 1), (1, 2), (2, 0), (2, 1), (3, 0), (4, 0), (5, 0)];

/// Exponents without mixed terms: all that a radial plan may correct
/// (`docs/mathematics/generating-contact.md#what-the-grinding-motion-leaves-to-first-order`).
const PURE: [(usize, usize); 9] = [(0, 0), (0, 1), (0, 2), (0, 3), (1, 0), (2, 0), (3, 0), (4, 0), (5, 0)];

/// All exponents of a polynomial of third degree.
const CUBIC: [(usize, usize); 10] =
    [(0, 0), (0, 1), (0, 2), (0, 3), (1, 0), (1, 1), (1, 2), (2, 0), (2, 1), (3, 0)];

/// Least-squares fit into the class on fixed points; the matrix is inverted once.
#[derive(Clone, Debug)]
pub struct ClassFit {
    operator: DMatrix<f64>,
    exponents: &'static [(usize, usize)],
    scales: Vec<f64>,
}

impl ClassFit {
    /// Into the whole class, for points (u, y) that determine it (>= 6 x 4 different ones).
    pub fn new(points: &[(f64, f64)]) -> Self {
        Self::with_exponents(points, &CLASS)
    }

    /// Into the terms pure in u or in y only.
    pub fn without_mixed_terms(points: &[(f64, f64)]) -> Self {
        Self::with_exponents(points, &PURE)
    }

    /// Into the polynomials of third degree.
    pub fn cubic(points: &[(f64, f64)]) -> Self {
        Self::with_exponents(points, &CUBIC)
    }

    fn with_exponents(points: &[(f64, f64)], exponents: &'static [(usize, usize)]) -> Self {
        let extent =
            |pick: fn(&(f64, f64)) -> f64| points.iter().map(|p| pick(p).abs()).fold(1e-12, f64::max);
        let (eu, ey) = (extent(|p| p.0), extent(|p| p.1));
        let scales: Vec<f64> =
            exponents.iter().map(|&(i, j)| eu.powi(i as i32) * ey.powi(j as i32)).collect();
        let matrix = DMatrix::from_fn(points.len(), exponents.len(), |row, k| {
            let (i, j) = exponents[k];
            points[row].0.powi(i as i32) * points[row].1.powi(j as i32) / scales[k]
        });
        // Scaled columns have entries up to 1, so 1e-12 of sqrt(rows) is far below any singular value that matters.
        let cut = 1e-12 * (points.len() as f64).sqrt();
        let operator =
            matrix.pseudo_inverse(cut).unwrap_or_else(|_| DMatrix::zeros(exponents.len(), points.len()));
        Self { operator, exponents, scales }
    }

    /// The polynomial nearest to `values` at the points.
    pub fn fit(&self, values: &[f64]) -> Polynomial2 {
        let x = &self.operator * DVector::from_column_slice(values);
        let terms = self.exponents.iter().zip(x.iter().zip(&self.scales));
        Polynomial2::from_terms(terms.map(|(&(i, j), (x, s))| (i, j, x / s)))
    }
}
