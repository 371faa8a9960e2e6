//! The straight course of a characteristic over the number of the part.

use crate::inspection::Line;
use foundation::numerics::{student_quantile, student_two_sided};

/// Least squares over part numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trend {
    /// Change from part to part.
    pub slope: f64,
    /// Its standard error.
    pub standard_error: f64,
    /// With 95 percent certainty the change lies between these (t, n - 2).
    pub slope_interval_95: [f64; 2],
    /// Value of the line at part number 0.
    pub start: f64,
    /// Probability of such a slope by chance (t, n - 2); `None` if all values are equal.
    pub probability: Option<f64>,
}

impl Trend {
    /// Of at least three values of parts with these numbers.
    pub(super) fn of(parts: &[f64], values: &[f64]) -> Option<Self> {
        if values.len() < 3 || parts.len() != values.len() {
            return None;
        }
        if values.iter().all(|value| *value == values[0]) {
            let (slope_interval_95, start) = ([0.0; 2], values[0]);
            return Some(Self {
                slope: 0.0,
                standard_error: 0.0,
                slope_interval_95,
                start,
                probability: None,
            });
        }
        let freedom = (values.len() - 2) as f64;
        let line = Line::through(parts, values);
        let squares: f64 =
            parts.iter().zip(values).map(|(part, value)| (value - line.at(*part)).powi(2)).sum();
        let standard_error = (squares / freedom).sqrt() / line.spread;
        let t = line.gradient / standard_error;
        let probability = (!t.is_nan()).then(|| student_two_sided(t, freedom));
        let beside = student_quantile(0.95, freedom) * standard_error;
        Some(Self {
            slope: line.gradient,
            standard_error,
            slope_interval_95: [line.gradient - beside, line.gradient + beside],
            start: line.at(0.0),
            probability,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_course_is_no_chance() {
        let exact = Trend::of(&[1.0, 2.0, 3.0], &[0.0, 2.0, 4.0]).unwrap();
        assert_eq!((exact.slope, exact.standard_error, exact.probability), (2.0, 0.0, Some(0.0)));
        // Three values: the t of one degree of freedom, p = 2/pi atan(1/t).
        let rough = Trend::of(&[1.0, 2.0, 3.0], &[0.0, 3.0, 4.0]).unwrap();
        assert!(
            (rough.slope - 2.0).abs() < 1e-15 && (rough.standard_error - (1.0 / 3f64).sqrt()).abs() < 1e-15
        );
        let t = 2.0 * 3f64.sqrt();
        let p = 2.0 / std::f64::consts::PI * (1.0 / t).atan();
        assert!((rough.probability.unwrap() - p).abs() < 1e-13);
        // t of one degree of freedom at 95 percent: 12.7062 in tables.
        let [low, high] = rough.slope_interval_95;
        assert!((high - 2.0 - 12.706_204_736 / 3f64.sqrt()).abs() < 1e-8 && (low + high - 4.0).abs() < 1e-12);
        // A part between that has no value does not bend the line.
        let gap = Trend::of(&[1.0, 2.0, 4.0], &[0.0, 2.0, 6.0]).unwrap();
        assert!(
            (gap.slope - 2.0).abs() < 1e-15 && (gap.start + 2.0).abs() < 1e-14 && gap.standard_error < 1e-14
        );
        assert!(Trend::of(&[1.0, 2.0], &[1.0, 2.0]).is_none());
    }
}
