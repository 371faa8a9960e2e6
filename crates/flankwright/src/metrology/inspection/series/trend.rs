//! The straight course of a characteristic over the number of the part.

use crate::metrology::inspection::Line;
use crate::numerics::student_two_sided;

/// Least squares over part numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trend {
    /// Change from part to part.
    pub slope: f64,
    /// Its standard error.
    pub standard_error: f64,
    /// Probability of such a slope by chance (t, n - 2); `None` if all values are equal.
    pub probability: Option<f64>,
}

impl Trend {
    /// Of at least three values.
    pub(super) fn of(values: &[f64]) -> Option<Self> {
        if values.len() < 3 {
            return None;
        }
        let freedom = (values.len() - 2) as f64;
        let parts: Vec<f64> = (1..=values.len()).map(|part| part as f64).collect();
        let line = Line::through(&parts, values);
        let squares: f64 =
            parts.iter().zip(values).map(|(part, value)| (value - line.at(*part)).powi(2)).sum();
        let standard_error = (squares / freedom).sqrt() / line.spread;
        let t = line.gradient / standard_error;
        let probability = (!t.is_nan()).then(|| student_two_sided(t, freedom));
        Some(Self { slope: line.gradient, standard_error, probability })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_course_is_no_chance() {
        let exact = Trend::of(&[0.0, 2.0, 4.0]).unwrap();
        assert_eq!((exact.slope, exact.standard_error, exact.probability), (2.0, 0.0, Some(0.0)));
        // Three values: the t of one degree of freedom, p = 2/pi atan(1/t).
        let rough = Trend::of(&[0.0, 3.0, 4.0]).unwrap();
        assert!(
            (rough.slope - 2.0).abs() < 1e-15 && (rough.standard_error - (1.0 / 3f64).sqrt()).abs() < 1e-15
        );
        let t = 2.0 * 3f64.sqrt();
        let p = 2.0 / std::f64::consts::PI * (1.0 / t).atan();
        assert!((rough.probability.unwrap() - p).abs() < 1e-13);
        assert!(Trend::of(&[1.0, 2.0]).is_none());
    }
}
