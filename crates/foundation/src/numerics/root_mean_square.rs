//! The root mean square of some numbers.

/// sqrt(mean of squares); 0 of nothing.
pub fn root_mean_square(numbers: &[f64]) -> f64 {
    (numbers.iter().map(|x| x * x).sum::<f64>() / numbers.len().max(1) as f64).sqrt()
}
