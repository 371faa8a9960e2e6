//! The areal fit of a whole grid by polynomials that are orthogonal on its lines: the same fit in as many steps as there are points. Knows
//! no geometry.

use super::{ArealDegree, ArealError};
use nalgebra::DMatrix;

/// Coefficients of the Legendre products and (A^T A)^-1.
pub(super) struct TensorFit {
    pub coefficients: Vec<f64>,
    pub covariance: DMatrix<f64>,
}

/// Polynomials orthogonal on some points: values there, squares of their norms, coefficients in Legendre polynomials.
struct Orthogonal {
    values: Vec<Vec<f64>>,
    squares: Vec<f64>,
    legendre: Vec<Vec<f64>>,
}

/// Squares of norms below this share of the first count as zero: fewer different points than polynomials.
const DEGENERATE: f64 = 1e-20;

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// x times a sum of Legendre polynomials: x P_m = ((m + 1) P_(m+1) + m P_(m-1))/(2 m + 1).
fn times_x(series: &[f64]) -> Vec<f64> {
    let mut product = vec![0.0; series.len()];
    for (m, a) in series.iter().enumerate() {
        let n = m as f64;
        if let Some(above) = product.get_mut(m + 1) {
            *above += a * (n + 1.0) / (2.0 * n + 1.0);
        }
        if m > 0 {
            product[m - 1] += a * n / (2.0 * n + 1.0);
        }
    }
    product
}

impl Orthogonal {
    /// By the three-term recurrence p_(k+1) = (x - alpha_k) p_k - beta_k p_(k-1).
    fn new(x: &[f64], order: usize) -> Result<Self, ArealError> {
        let count = order + 1;
        let mut unit = vec![0.0; count];
        unit[0] = 1.0;
        let (mut values, mut squares) = (vec![vec![1.0; x.len()]], vec![x.len() as f64]);
        let mut legendre = vec![unit];
        for k in 0..order {
            let alpha = x.iter().zip(&values[k]).map(|(x, p)| x * p * p).sum::<f64>() / squares[k];
            let beta = if k > 0 { squares[k] / squares[k - 1] } else { 0.0 };
            let before = |list: &[Vec<f64>], i: usize| if k > 0 { list[k - 1][i] } else { 0.0 };
            let next: Vec<f64> =
                (0..x.len()).map(|i| (x[i] - alpha) * values[k][i] - beta * before(&values, i)).collect();
            let raised = times_x(&legendre[k]);
            let series = (0..count)
                .map(|m| raised[m] - alpha * legendre[k][m] - beta * before(&legendre, m))
                .collect();
            let square = dot(&next, &next);
            let share = square / squares[0];
            if share.is_nan() || share < DEGENERATE {
                return Err(ArealError::DegenerateField { share: share.sqrt() });
            }
            values.push(next);
            squares.push(square);
            legendre.push(series);
        }
        Ok(Self { values, squares, legendre })
    }
}

impl TensorFit {
    /// Of values `f` at all (u, v), those over v side by side.
    pub fn new(u: &[f64], v: &[f64], f: &[f64], degree: ArealDegree) -> Result<Self, ArealError> {
        let terms = degree.terms();
        if f.len() < terms.len() {
            return Err(ArealError::TooFewPoints { points: f.len(), terms: terms.len() });
        }
        let (along_u, along_v) = (Orthogonal::new(u, degree.order())?, Orthogonal::new(v, degree.order())?);
        // Moments over v first: one pass over the points for each polynomial.
        let over_v: Vec<Vec<f64>> =
            along_v.values.iter().map(|q| f.chunks(v.len()).map(|row| dot(row, q)).collect()).collect();
        // Row by row the orthogonal products as Legendre products.
        let mixed = DMatrix::from_fn(terms.len(), terms.len(), |k, m| {
            along_u.legendre[terms[k].p][terms[m].p] * along_v.legendre[terms[k].q][terms[m].q]
        });
        let squares = |k: usize| along_u.squares[terms[k].p] * along_v.squares[terms[k].q];
        let coefficients = (0..terms.len())
            .map(|m| {
                (0..terms.len())
                    .map(|k| {
                        mixed[(k, m)] * dot(&along_u.values[terms[k].p], &over_v[terms[k].q]) / squares(k)
                    })
                    .sum()
            })
            .collect();
        let scaled = DMatrix::from_fn(terms.len(), terms.len(), |k, m| mixed[(k, m)] / squares(k).sqrt());
        Ok(Self { coefficients, covariance: scaled.transpose() * scaled })
    }
}
