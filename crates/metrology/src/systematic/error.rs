//! What keeps a deviation from being judged as systematic.

use finding::Finding;
use thiserror::Error;

/// Errors of the test.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum SystematicError {
    /// One tooth tells nothing of what the others have.
    #[error("{teeth} teeth do not tell what is systematic; at least 2 are needed")]
    #[finding(code = "too-few-teeth")]
    #[way_out("measure more teeth, evenly spaced around the gear")]
    TooFewTeeth {
        /// Teeth with readings.
        teeth: usize,
    },
    /// Teeth with different numbers of readings, or angles for other teeth.
    #[error("{name}: {found}, but {wanted} are needed")]
    #[finding(code = "other-shape")]
    #[way_out("measure every tooth as often as the others and give one angle for each")]
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
    #[finding(code = "invalid-number")]
    #[way_out("give a value in the allowed range")]
    InvalidNumber {
        /// Name of the quantity.
        name: &'static str,
        /// Its value.
        value: f64,
        /// Allowed range in words.
        allowed: &'static str,
    },
}
