//! Equidistant numbers.

/// Equidistant numbers from `from` to `to`, both included and exact; `n` >= 2.
pub fn equidistant([from, to]: [f64; 2], n: usize) -> Vec<f64> {
    let share = |i: usize| i as f64 / (n - 1) as f64;
    (0..n).map(|i| from * (1.0 - share(i)) + to * share(i)).collect()
}
