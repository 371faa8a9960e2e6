//! What keeps a correction from being found (`docs/mathematics/inspection.md`).

use crate::GeneratingError;
use dressing::DressingError;
use finding::Finding;
use thiserror::Error;

/// Errors of the closed loop. Lengths mm.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum CorrectionError {
    /// Worm and workpiece do not touch as they should.
    #[error(transparent)]
    #[finding(transparent)]
    Generating(#[from] GeneratingError),
    /// Dresser and worm do not touch as they should.
    #[error(transparent)]
    #[finding(transparent)]
    Dressing(#[from] DressingError),
    /// Nothing was measured.
    #[error("there is no point with a deviation")]
    #[finding(code = "too-few-points")]
    #[way_out("measure the flank")]
    TooFewPoints,
    /// A setting that changes nothing at the measured points.
    #[error("{setting} changes nothing at the measured points")]
    #[finding(code = "setting-without-effect")]
    #[way_out("leave this setting out of the correction")]
    SettingWithoutEffect {
        /// Name of the setting.
        setting: String,
    },
    /// Settings that the measured points do not tell apart.
    #[error(
        "the measured points do not tell these settings apart: {}",
        unseen.iter().map(|names| names.join(" with ")).collect::<Vec<_>>().join("; ")
    )]
    #[finding(code = "underdetermined")]
    #[way_out(
        "measure both flanks or more traces, leave one of the settings out, or allow the shortest correction"
    )]
    Underdetermined {
        /// The settings in each direction that changes nothing.
        unseen: Vec<Vec<String>>,
    },
    /// Bounds the wrong way round, or not a number.
    #[error("{setting}: the bounds from {low} to {high} leave no value")]
    #[finding(code = "invalid-bounds")]
    #[way_out("give a lowest value that is not above the highest")]
    InvalidBounds {
        /// Name of the setting.
        setting: String,
        /// Lowest value.
        low: f64,
        /// Highest value.
        high: f64,
    },
    /// Lists of different lengths.
    #[error("{name}: {found}, but {wanted} are needed")]
    #[finding(code = "other-shape")]
    #[way_out("give one value for each")]
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
    /// Bounded least squares that do not settle.
    #[error("the bounded least squares do not settle")]
    #[finding(code = "not-converged")]
    #[way_out("use fewer settings or wider bounds")]
    NotConverged,
}
