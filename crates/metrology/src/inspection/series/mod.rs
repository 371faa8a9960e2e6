//! One characteristic over a series of parts: statistics, capability, trend (`docs/mathematics/inspection.md#series`). The unit is that of
//! the values.

mod capability;
mod control_chart;
mod parts;
mod run_rules;
mod trend;

pub use capability::{Capability, SpecificationLimits};
pub use control_chart::ControlLimits;
pub use parts::{CharacteristicSeries, SeriesPart, SeriesValue, evaluate_parts, ordered};
pub use run_rules::{RuleFinding, RunRule};
pub use trend::Trend;

use super::error::usable;
use super::{InspectionError, InspectionWarning};
use foundation::numerics::{chi_square_quantile, extremes, student_quantile};

/// Parts below which a capability says little.
const FEW: usize = 25;

/// Larger numbers are no measurement, and their squares no numbers.
const LARGEST: f64 = 1e12;

/// Below this probability by chance a trend is taken to be one.
const SIGNIFICANT: f64 = 0.01;

/// A characteristic over parts in the order of their making.
#[derive(Clone, Debug, PartialEq)]
pub struct SeriesEvaluation {
    /// Parts.
    pub parts: usize,
    /// Mean.
    pub mean: f64,
    /// With 95 percent certainty the mean of the process lies between these (t, n - 1).
    pub mean_interval_95: [f64; 2],
    /// s: standard deviation, of n - 1.
    pub deviation: f64,
    /// With 95 percent certainty the standard deviation of the process lies between these (chi-square, n - 1).
    pub deviation_interval_95: [f64; 2],
    /// Least value.
    pub least: f64,
    /// Greatest value.
    pub greatest: f64,
    /// Chart of individual values and moving ranges.
    pub control: ControlLimits,
    /// Numbers from 0 of parts farther than 3 sigma_MR from the mean.
    pub outside: Vec<usize>,
    /// What the rules for special causes find, by rule, then by part.
    pub findings: Vec<RuleFinding>,
    /// Capability against the limits, by s of all parts.
    pub capability: Capability,
    /// Capability by sigma_MR: what the process could do without drifts and jumps.
    pub short_term: Capability,
    /// Trend; `None` for fewer than three parts.
    pub trend: Option<Trend>,
    /// What to know about the figures.
    pub warnings: Vec<InspectionWarning>,
}

impl SeriesEvaluation {
    /// Greatest less least.
    pub fn range(&self) -> f64 {
        self.greatest - self.least
    }
}

/// Evaluates the values of all parts of a series in the order of their making.
///
/// # Errors
/// [`InspectionError::TooFewParts`] for fewer than two parts, [`InspectionError::InvalidNumber`].
pub fn evaluate_series(
    values: &[f64],
    limits: &SpecificationLimits,
) -> Result<SeriesEvaluation, InspectionError> {
    let numbers: Vec<f64> = (1..=values.len()).map(|part| part as f64).collect();
    evaluate_numbered(&numbers, values, limits)
}

/// As [`evaluate_series`], of parts with these numbers, ascending: others may lie between them.
fn evaluate_numbered(
    numbers: &[f64],
    values: &[f64],
    limits: &SpecificationLimits,
) -> Result<SeriesEvaluation, InspectionError> {
    let parts = values.len();
    if parts < 2 {
        return Err(InspectionError::TooFewParts { found: parts, needed: 2 });
    }
    for &value in values {
        usable("value of a part", value, value.abs() < LARGEST, "a number between -1e12 and 1e12")?;
    }
    let n = parts as f64;
    let [least, greatest] = extremes(values.iter().copied());
    // Equal values have no deviation, not even one of rounding.
    let mean = if least == greatest { least } else { values.iter().sum::<f64>() / n };
    let deviation = (values.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (n - 1.0)).sqrt();
    let beside = student_quantile(0.95, n - 1.0) * deviation / n.sqrt();
    let control = ControlLimits::of(values, mean);
    let far = |value: f64| (value - mean).abs() > 3.0 * control.sigma;
    let outside = values.iter().enumerate().filter(|(_, value)| far(**value)).map(|(part, _)| part).collect();
    let trend = Trend::of(numbers, values);
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
        mean_interval_95: [mean - beside, mean + beside],
        deviation,
        deviation_interval_95: [0.975, 0.025]
            .map(|probability| deviation * ((n - 1.0) / chi_square_quantile(probability, n - 1.0)).sqrt()),
        least,
        greatest,
        control,
        outside,
        findings: run_rules::findings(values, &control),
        capability: Capability::of(parts, [mean, deviation], limits),
        short_term: Capability::of(parts, [mean, control.sigma], limits).without_bounds(),
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
        assert!((series.control.sigma - 2.067_863).abs() < 1e-6);
        // t of three degrees of freedom at 95 percent: 3.182446; chi-square: 0.215795 and 9.348404.
        let half = 3.182_446_305 * (14f64 / 3.0).sqrt() / 2.0;
        assert!((series.mean_interval_95[1] - 3.0 - half).abs() < 1e-8, "{series:?}");
        for (found, chi) in series.deviation_interval_95.into_iter().zip([9.348_404, 0.215_795]) {
            assert!((found / (14f64 / chi).sqrt() - 1.0).abs() < 3e-6, "{series:?}");
        }
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
        let series = of(&[0.1; 30]);
        assert_eq!((series.deviation, series.capability.cp, series.capability.cpk), (0.0, None, None));
        assert_eq!((series.trend.unwrap().slope, series.trend.unwrap().probability), (0.0, None));
        assert!(series.outside.is_empty() && series.warnings.is_empty() && series.findings.is_empty());
        assert_eq!((series.mean_interval_95, series.deviation_interval_95), ([0.1; 2], [0.0; 2]));
    }

    #[test]
    fn bad_series_are_refused() {
        let code =
            |values: &[f64]| evaluate_series(values, &SpecificationLimits::default()).unwrap_err().code();
        assert_eq!(code(&[]), "too-few-parts");
        assert_eq!(code(&[1.0]), "too-few-parts");
        assert_eq!(code(&[1.0, f64::NAN]), "invalid-number");
        assert_eq!(code(&[1.0, 1e300]), "invalid-number");
        assert!(of(&[1.0, 2.0]).trend.is_none());
    }
}
