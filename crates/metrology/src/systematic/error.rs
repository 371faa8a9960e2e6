//! What keeps a deviation from being judged as systematic.

use thiserror::Error;

/// Errors of the test.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SystematicError {
    /// One tooth tells nothing of what the others have.
    #[error("{teeth} teeth do not tell what is systematic; at least 2 are needed")]
    TooFewTeeth {
        /// Teeth with readings.
        teeth: usize,
    },
    /// Teeth with different numbers of readings, or angles for other teeth.
    #[error("{name}: {found}, but {wanted} are needed")]
    OtherShape {
        /// What is counted.
        name: &'static str,
        /// How many there are.
        found: usize,
        /// How many are needed.
        wanted: usize,
    },
    /// A number that is not usable.
    #[error("{name} = {value} is not usable; allowed: {allowed}")]
    InvalidNumber {
        /// Name of the quantity.
        name: &'static str,
        /// Its value.
        value: f64,
        /// Allowed range in words.
        allowed: &'static str,
    },
}

impl SystematicError {
    /// Stable code.
    pub fn code(&self) -> &'static str {
        match self {
            Self::TooFewTeeth { .. } => "too-few-teeth",
            Self::OtherShape { .. } => "other-shape",
            Self::InvalidNumber { .. } => "invalid-number",
        }
    }

    /// What helps, in one sentence.
    pub fn way_out(&self) -> &'static str {
        match self {
            Self::TooFewTeeth { .. } => "measure more teeth, evenly spaced around the gear",
            Self::OtherShape { .. } => {
                "measure every tooth as often as the others and give one angle for each"
            }
            Self::InvalidNumber { .. } => "give a value in the allowed range",
        }
    }
}
