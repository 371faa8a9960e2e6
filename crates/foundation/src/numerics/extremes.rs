//! The range of some numbers.

/// [least, greatest]; [inf, -inf] of nothing.
pub fn extremes(numbers: impl IntoIterator<Item = f64>) -> [f64; 2] {
    numbers.into_iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)])
}
