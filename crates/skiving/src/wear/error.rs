//! What keeps wear from being followed.

use finding::Finding;
use thiserror::Error;

/// Errors of trend and resharpening.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum WearError {
    /// A number that is not finite or outside the range that has a meaning.
    #[error("{field} = {value} is not usable; allowed: {allowed}")]
    #[finding(code = "invalid-number")]
    #[way_out("give a value in the allowed range")]
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
    #[finding(code = "too-few-measurements")]
    #[way_out("measure the tool once more after further workpieces")]
    TooFewMeasurements {
        /// Different counts of workpieces.
        counts: usize,
    },
    /// Two measurements have not the same flanks, tracks and teeth.
    #[error("{field}: {found} does not go with {wanted} of the other measurement or the edges")]
    #[finding(code = "other-shape")]
    #[way_out("compare measurements of the same tool at the same tracks")]
    OtherShape {
        /// What is counted.
        field: &'static str,
        /// How many there are.
        found: usize,
        /// How many there should be.
        wanted: usize,
    },
}
