//! What keeps a correction from being found (`docs/mathematics/inspection.md`).

use crate::dressing::DressingError;
use crate::generating::GeneratingError;
use thiserror::Error;

/// Errors of the closed loop. Lengths mm.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum CorrectionError {
    /// Worm and workpiece do not touch as they should.
    #[error(transparent)]
    Generating(#[from] GeneratingError),
    /// Dresser and worm do not touch as they should.
    #[error(transparent)]
    Dressing(#[from] DressingError),
    /// Nothing was measured.
    #[error("there is no point with a deviation")]
    TooFewPoints,
    /// A setting that changes nothing at the measured points.
    #[error("{setting} changes nothing at the measured points")]
    SettingWithoutEffect {
        /// Name of the setting.
        setting: String,
    },
    /// Settings that the measured points do not tell apart.
    #[error(
        "the measured points do not tell these settings apart: {}",
        unseen.iter().map(|names| names.join(" with ")).collect::<Vec<_>>().join("; ")
    )]
    Underdetermined {
        /// The settings in each direction that changes nothing.
        unseen: Vec<Vec<String>>,
    },
    /// Bounds the wrong way round, or not a number.
    #[error("{setting}: the bounds from {low} to {high} leave no value")]
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
    /// Bounded least squares that do not settle.
    #[error("the bounded least squares do not settle")]
    NotConverged,
}

impl CorrectionError {
    /// Stable code.
    pub fn code(&self) -> &'static str {
        match self {
            Self::Generating(error) => error.code(),
            Self::Dressing(error) => error.code(),
            Self::TooFewPoints => "too-few-points",
            Self::SettingWithoutEffect { .. } => "setting-without-effect",
            Self::Underdetermined { .. } => "underdetermined",
            Self::InvalidBounds { .. } => "invalid-bounds",
            Self::OtherShape { .. } => "other-shape",
            Self::InvalidNumber { .. } => "invalid-number",
            Self::NotConverged => "not-converged",
        }
    }

    /// What helps, in one sentence.
    pub fn way_out(&self) -> String {
        match self {
            Self::Generating(error) => error.way_out().to_string(),
            Self::Dressing(error) => error.way_out().to_string(),
            Self::TooFewPoints => "measure the flank".into(),
            Self::SettingWithoutEffect { .. } => "leave this setting out of the correction".into(),
            Self::Underdetermined { .. } => {
                "measure both flanks or more traces, leave one of the settings out, or allow the shortest correction".into()
            }
            Self::InvalidBounds { .. } => "give a lowest value that is not above the highest".into(),
            Self::OtherShape { .. } => "give one value for each".into(),
            Self::InvalidNumber { .. } => "give a value in the allowed range".into(),
            Self::NotConverged => "use fewer settings or wider bounds".into(),
        }
    }
}
