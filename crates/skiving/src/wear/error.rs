//! What keeps wear from being followed.

use thiserror::Error;

/// Errors of trend and resharpening.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum WearError {
    /// A number that is not finite or outside the range that has a meaning.
    #[error("{field} = {value} is not usable; allowed: {allowed}")]
    InvalidNumber {
        /// Name of the quantity.
        field: &'static str,
        /// The offending value.
        value: f64,
        /// Allowed range in words.
        allowed: &'static str,
    },
    /// A straight line needs measurements at two counts of workpieces.
    #[error("a trend needs measurements at two different counts of workpieces; there are {counts}")]
    TooFewMeasurements {
        /// Different counts of workpieces.
        counts: usize,
    },
    /// Two measurements have not the same flanks, tracks and teeth.
    #[error("{field}: {found} does not go with {wanted} of the other measurement or the edges")]
    OtherShape {
        /// What is counted.
        field: &'static str,
        /// How many there are.
        found: usize,
        /// How many there should be.
        wanted: usize,
    },
}

impl WearError {
    /// Stable code.
    pub fn code(&self) -> &'static str {
        match self {
            Self::InvalidNumber { .. } => "invalid-number",
            Self::TooFewMeasurements { .. } => "too-few-measurements",
            Self::OtherShape { .. } => "other-shape",
        }
    }

    /// What helps, in one sentence.
    pub fn way_out(&self) -> &'static str {
        match self {
            Self::InvalidNumber { .. } => "give a value in the allowed range",
            Self::TooFewMeasurements { .. } => "measure the tool once more after further workpieces",
            Self::OtherShape { .. } => "compare measurements of the same tool at the same tracks",
        }
    }
}
