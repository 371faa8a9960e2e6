//! A polynomial in powers of one variable.

/// Value and two derivatives of c_0 + c_1 x + c_2 x^2 + ...
pub fn power_series(coefficients: &[f64], x: f64) -> [f64; 3] {
    coefficients.iter().rev().fold([0.0; 3], |[f, d, dd], c| [f * x + c, d * x + f, dd * x + 2.0 * d])
}
