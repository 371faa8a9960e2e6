//! Largest values over intervals: what the guaranteed bounds of the surfaces are made of.

use std::f64::consts::{FRAC_PI_2, PI};

/// Largest magnitude in an interval.
#[inline]
pub(crate) fn largest(range: [f64; 2]) -> f64 {
    range[0].abs().max(range[1].abs())
}

/// Smallest magnitude in an interval.
#[inline]
pub(crate) fn smallest(range: [f64; 2]) -> f64 {
    if range[0] <= 0.0 && range[1] >= 0.0 { 0.0 } else { range[0].abs().min(range[1].abs()) }
}

/// How far a smooth vector is off its linear part at the middle of a box at most, from upper bounds of its second derivatives there
/// (by height twice, by both, by length twice): Taylor's remainder.
pub(crate) fn remainder([aa, ab, bb]: [f64; 3], heights: [f64; 2], lengths: [f64; 2]) -> f64 {
    let [a, b] = [heights, lengths].map(|[from, to]| 0.5 * (to - from).abs());
    0.5 * (aa * a * a + bb * b * b) + ab * a * b
}

/// Largest |sin| over an interval of angles.
pub(crate) fn largest_sine([from, to]: [f64; 2]) -> f64 {
    // The first peak of |sin| at or above the lower end.
    let peak = ((from - FRAC_PI_2) / PI).ceil() * PI + FRAC_PI_2;
    if peak <= to { 1.0 } else { from.sin().abs().max(to.sin().abs()) }
}

/// Largest |cos| over an interval of angles.
pub(crate) fn largest_cosine([from, to]: [f64; 2]) -> f64 {
    largest_sine([from + FRAC_PI_2, to + FRAC_PI_2])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peaks_inside_an_interval_are_seen() {
        assert_eq!(largest_sine([1.0, 2.0]), 1.0);
        assert_eq!(largest_sine([-2.0, -1.0]), 1.0);
        assert_eq!(largest_sine([0.2, 0.4]), 0.4f64.sin());
        assert_eq!(largest_sine([-0.4, 0.2]), 0.4f64.sin());
        assert_eq!(largest_cosine([-0.1, 0.3]), 1.0);
        assert!((largest_cosine([0.1, 0.3]) - 0.1f64.cos()).abs() < 1e-15);
        assert_eq!((largest([-3.0, 2.0]), smallest([-3.0, 2.0]), smallest([-3.0, -2.0])), (3.0, 0.0, 2.0));
    }
}
