//! One characteristic over a series of parts: statistics, capability, trend (spec 85 section 10). The unit is that of the values.

mod capability;
mod trend;

pub use capability::{Capability, SpecificationLimits};
pub use trend::Trend;

use super::error::usable;
use super::{InspectionError, InspectionWarning};
use crate::numerics::extremes;

/// Parts below which a capability says little.
const FEW: usize = 25;

/// Mean of the distance of two normal numbers, in standard deviations (1.128379 in tables).
const MEAN_MOVING_RANGE: f64 = std::f64::consts::FRAC_2_SQRT_PI;

/// Below this probability by chance a trend is taken to be one.
const SIGNIFICANT: f64 = 0.01;

/// A characteristic over parts in the order of their making.
#[derive(Clone, Debug, PartialEq)]
pub struct SeriesEvaluation {
    /// Parts.
    pub parts: usize,
    /// Mean.
    pub mean: f64,
    /// s: standard deviation, of n - 1.
    pub deviation: f64,
    /// Least value.
    pub least: f64,
    /// Greatest value.
    pub greatest: f64,
    /// sigma_MR: standard deviation by the distances of neighbouring parts, which a slow drift does not enlarge.
    pub moving_range_deviation: f64,
    /// Numbers from 0 of parts farther than 3 sigma_MR from the mean.
    pub outside: Vec<usize>,
    /// Capability against the limits.
    pub capability: Capability,
    /// Trend; `None` for fewer than three parts.
    pub trend: Option<Trend>,
    /// What to know about the figures.
    pub warnings: Vec<InspectionWarning>,
}

/// Evaluates the values of the parts of a series.
///
/// # Errors
/// [`InspectionError::TooFewParts`] for fewer than two parts, [`InspectionError::InvalidNumber`].
pub fn evaluate_series(
    values: &[f64],
    limits: &SpecificationLimits,
) -> Result<SeriesEvaluation, InspectionError> {
    let parts = values.len();
    if parts < 2 {
        return Err(InspectionError::TooFewParts { found: parts, needed: 2 });
    }
    for &value in values {
        usable("value of a part", value, true, "a finite number")?;
    }
    let n = parts as f64;
    let mean = values.iter().sum::<f64>() / n;
    let deviation = (values.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (n - 1.0)).sqrt();
    let steps: f64 = values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum();
    let moving_range_deviation = steps / (n - 1.0) / MEAN_MOVING_RANGE;
    let far = |value: f64| (value - mean).abs() > 3.0 * moving_range_deviation;
    let outside = values.iter().enumerate().filter(|(_, value)| far(**value)).map(|(part, _)| part).collect();
    let [least, greatest] = extremes(values.iter().copied());
    let trend = Trend::of(values);
    let mut warnings = Vec::new();
    if parts < FEW {
        warnings.push(InspectionWarning::FewParts { parts });
    }
    if let Some(Trend { slope, probability: Some(probability), .. }) = trend
        && probability < SIGNIFICANT
    {
        warnings.push(InspectionWarning::TrendSignificant { slope, probability });
    }
    Ok(SeriesEvaluation {
        parts,
        mean,
        deviation,
        least,
        greatest,
        moving_range_deviation,
        outside,
        capability: Capability::of(parts, [mean, deviation], limits),
        trend,
        warnings,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(values: &[f64]) -> SeriesEvaluation {
        evaluate_series(values, &SpecificationLimits::new(Some(-2.0), Some(2.0)).unwrap()).unwrap()
    }

    #[test]
    fn statistics_of_a_few_parts() {
        let series = of(&[1.0, 3.0, 2.0, 6.0]);
        assert_eq!((series.mean, series.least, series.greatest), (3.0, 1.0, 6.0));
        assert!((series.deviation - (14f64 / 3.0).sqrt()).abs() < 1e-15);
        assert!((series.moving_range_deviation - 2.067_863).abs() < 1e-6);
        assert_eq!(series.warnings, [InspectionWarning::FewParts { parts: 4 }]);
    }

    #[test]
    fn an_outlier_and_a_drift_are_found() {
        let noise = |k: i32| f64::from((k * 3) % 11 - 5) / 50.0;
        let mut values: Vec<f64> = (0..40).map(noise).collect();
        assert_eq!((of(&values).outside.len(), of(&values).warnings.len()), (0, 0));
        values[17] = 1.5;
        assert_eq!(of(&values).outside, [17]);
        let drift: Vec<f64> = (0..40).map(|k| noise(k) + 0.02 * f64::from(k)).collect();
        assert_eq!(
            of(&drift).warnings.iter().map(InspectionWarning::code).collect::<Vec<_>>(),
            ["trend-significant"]
        );
    }

    #[test]
    fn equal_parts_have_neither_capability_nor_trend() {
        let series = of(&[0.5; 30]);
        assert_eq!((series.deviation, series.capability.cp, series.capability.cpk), (0.0, None, None));
        assert_eq!((series.trend.unwrap().slope, series.trend.unwrap().probability), (0.0, None));
        assert!(series.outside.is_empty() && series.warnings.is_empty());
    }

    #[test]
    fn bad_series_are_refused() {
        let code =
            |values: &[f64]| evaluate_series(values, &SpecificationLimits::default()).unwrap_err().code();
        assert_eq!(code(&[]), "too-few-parts");
        assert_eq!(code(&[1.0]), "too-few-parts");
        assert_eq!(code(&[1.0, f64::NAN]), "invalid-number");
        assert!(of(&[1.0, 2.0]).trend.is_none());
    }
}
