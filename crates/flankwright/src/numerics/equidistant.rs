//! Equidistant numbers.

/// Equidistant numbers from `from` to `to`, both included; `n` >= 2.
pub fn equidistant([from, to]: [f64; 2], n: usize) -> Vec<f64> {
    (0..n).map(|i| from + (to - from) * i as f64 / (n - 1) as f64).collect()
}
