//! The interpolating cubic spline in one variable: C2, not-a-knot at both ends.

use super::bernstein::{bernstein, derivative, shifted};
use super::knots::{Knots, SplineError};

/// Piecewise cubic through given values with continuous second derivative, whose first two and last two pieces
/// are one polynomial each (not-a-knot): it reproduces every cubic exactly. Outside the knots the border
/// polynomial continues.
#[derive(Clone, Debug, PartialEq)]
pub struct CubicSpline {
    knots: Knots,
    /// Per interval, ascending powers of the distance from its first knot.
    pieces: Vec<[f64; 4]>,
}

impl CubicSpline {
    /// Interpolates `values` at ascending `knots` (at least four).
    ///
    /// # Errors
    /// [`SplineError`] for fewer than four knots, knots out of order, numbers that are not finite and lists of
    /// different lengths.
    pub fn new(knots: &[f64], values: &[f64]) -> Result<Self, SplineError> {
        let knots = Knots::new(knots, 4, 0)?;
        if values.len() != knots.values().len() {
            return Err(SplineError::ShapeMismatch { expected: knots.values().len(), found: values.len() });
        }
        let pieces = interpolate(knots.values(), values);
        match pieces.iter().position(|piece| piece.iter().any(|c| !c.is_finite())) {
            Some(index) => Err(SplineError::ValueNotFinite { index }),
            None => Ok(Self { knots, pieces }),
        }
    }

    /// First and last knot.
    pub fn domain(&self) -> [f64; 2] {
        let knots = self.knots.values();
        [knots[0], knots[knots.len() - 1]]
    }

    /// Value at `x`.
    #[inline]
    pub fn value(&self, x: f64) -> f64 {
        let (index, t) = self.knots.locate(x);
        let [a, b, c, d] = self.pieces[index];
        a + t * (b + t * (c + t * d))
    }

    /// Value and first, second and third derivative at `x` (the third is constant in each interval).
    #[inline]
    pub fn derivatives(&self, x: f64) -> [f64; 4] {
        let (index, t) = self.knots.locate(x);
        let [a, b, c, d] = self.pieces[index];
        [a + t * (b + t * (c + t * d)), b + t * (2.0 * c + t * 3.0 * d), 2.0 * c + 6.0 * d * t, 6.0 * d]
    }

    /// Ranges that value and first, second and third derivative do not leave between two arguments (ascending).
    pub fn ranges(&self, interval: [f64; 2]) -> [[f64; 2]; 4] {
        let mut ranges = [[f64::INFINITY, f64::NEG_INFINITY]; 4];
        for (index, [from, to]) in self.knots.parts(interval) {
            let mut piece = shifted(self.pieces[index], from);
            for range in &mut ranges {
                for coefficient in bernstein(piece, to - from) {
                    *range = [range[0].min(coefficient), range[1].max(coefficient)];
                }
                piece = derivative(piece);
            }
        }
        ranges
    }
}

/// The pieces of the not-a-knot spline through `y` at checked knots `x`.
///
/// The unknowns are the slopes s at the knots. Continuity of the second derivative at the inner knots gives
/// h_i s_(i-1) + 2 (h_(i-1) + h_i) s_i + h_(i-1) s_(i+1) = 3 (h_i m_(i-1) + h_(i-1) m_i), m = chord slopes;
/// equal third derivatives across the second knot, with s_2 eliminated by the first inner equation, give the
/// first row (the last row likewise). The system is tridiagonal and its pivots stay positive.
pub(super) fn interpolate(x: &[f64], y: &[f64]) -> Vec<[f64; 4]> {
    let n = x.len();
    let h: Vec<f64> = x.windows(2).map(|p| p[1] - p[0]).collect();
    let m: Vec<f64> = (0..n - 1).map(|i| (y[i + 1] - y[i]) / h[i]).collect();

    let mut upper = vec![0.0; n];
    let mut slope = vec![0.0; n];
    let first = h[0] + h[1];
    upper[0] = first / h[1];
    slope[0] = ((h[0] + 2.0 * first) * h[1] * m[0] + h[0] * h[0] * m[1]) / (first * h[1]);
    for i in 1..n - 1 {
        let pivot = 2.0 * (h[i - 1] + h[i]) - h[i] * upper[i - 1];
        upper[i] = h[i - 1] / pivot;
        slope[i] = (3.0 * (h[i] * m[i - 1] + h[i - 1] * m[i]) - h[i] * slope[i - 1]) / pivot;
    }
    let (a, b) = (h[n - 3], h[n - 2]);
    let last = a + b;
    let right = (b * b * m[n - 3] + (2.0 * last + b) * a * m[n - 2]) / last;
    slope[n - 1] = (right - last * slope[n - 2]) / (a - last * upper[n - 2]);
    for i in (0..n - 1).rev() {
        slope[i] -= upper[i] * slope[i + 1];
    }

    (0..n - 1)
        .map(|i| {
            let excess = (slope[i] + slope[i + 1] - 2.0 * m[i]) / h[i];
            [y[i], slope[i], (m[i] - slope[i]) / h[i] - excess, excess / h[i]]
        })
        .collect()
}
