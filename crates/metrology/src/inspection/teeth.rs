//! One characteristic over the measured teeth: mean and range, exact and as a measuring machine prints them
//! (`docs/mathematics/inspection.md#one-trace`).

use super::InspectionError;
use super::error::usable;
use super::rounding::round_to;
use foundation::numerics::extremes;

/// What the values of several teeth come to, in their unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TeethSummary {
    /// Teeth.
    pub teeth: usize,
    /// Mean of the values with their signs.
    pub mean: f64,
    /// Least value.
    pub least: f64,
    /// Greatest value.
    pub greatest: f64,
}

impl TeethSummary {
    /// Of the values of at least one tooth.
    ///
    /// # Errors
    /// [`InspectionError::TooFewTeeth`], [`InspectionError::InvalidNumber`].
    pub fn of(values: &[f64]) -> Result<Self, InspectionError> {
        if values.is_empty() {
            return Err(InspectionError::TooFewTeeth { found: 0, needed: 1 });
        }
        for &value in values {
            usable("value of a tooth", value, true, "a finite number")?;
        }
        let [least, greatest] = extremes(values.iter().copied());
        Ok(Self {
            teeth: values.len(),
            mean: values.iter().sum::<f64>() / values.len() as f64,
            least,
            greatest,
        })
    }

    /// Greatest less least.
    pub fn range(&self) -> f64 {
        self.greatest - self.least
    }

    /// The range as a sheet prints it: of values that are rounded already.
    pub fn printed_range(&self, quantum: f64) -> f64 {
        round_to(round_to(self.greatest, quantum) - round_to(self.least, quantum), quantum)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_printed_range_is_that_of_printed_values() {
        let summary = TeethSummary::of(&[0.96, -0.84, 0.2]).unwrap();
        assert!((summary.mean - 0.32 / 3.0).abs() < 1e-15 && (summary.range() - 1.8).abs() < 1e-15);
        let summary = TeethSummary::of(&[0.96, -0.86]).unwrap();
        assert!((summary.range() - 1.82).abs() < 1e-15 && (summary.printed_range(0.1) - 1.9).abs() < 1e-15);
        assert_eq!(TeethSummary::of(&[]).unwrap_err().code(), "too-few-teeth");
        assert_eq!(TeethSummary::of(&[1.0, f64::NAN]).unwrap_err().code(), "invalid-number");
    }
}
