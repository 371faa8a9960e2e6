//! Errors of the data of a control (`docs/mathematics/gearbox.md#limits`).

use std::ops::RangeInclusive;
use thiserror::Error;

/// Why a control, its budget or its simulation refuses.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum ControlError {
    /// A parameter is NaN, infinite or outside its range.
    #[error("{name} = {value} is not usable; allowed: {allowed}")]
    BadParameter {
        /// Which.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What is allowed, in words.
        allowed: &'static str,
    },
    /// Reference pulses follow one another faster than the clock can fill in the pulses between them.
    #[error(
        "a feed of {speed} mm/s is faster than the interpolator: it follows up to {greatest} mm/s, beyond that pulses come late without bound"
    )]
    TooFast {
        /// Speed, mm/s.
        speed: f64,
        /// Greatest speed f1 p/P, mm/s.
        greatest: f64,
    },
    /// The sampled loop does not settle.
    #[error("the loop is unstable: its largest pole has the modulus {largest_pole}; allowed: below 1")]
    UnstableLoop {
        /// Largest modulus of the poles.
        largest_pole: f64,
    },
}

impl ControlError {
    /// Stable kebab-case code.
    pub fn code(&self) -> &'static str {
        match self {
            Self::BadParameter { .. } => "bad-parameter",
            Self::TooFast { .. } => "interpolator-too-fast",
            Self::UnstableLoop { .. } => "unstable-loop",
        }
    }

    /// What the user can do about it, in one sentence.
    pub fn way_out(&self) -> &'static str {
        match self {
            Self::BadParameter { .. } => "give a finite value within the range",
            Self::TooFast { .. } => {
                "feed slower, insert fewer pulses, or take a faster clock or a coarser scale"
            }
            Self::UnstableLoop { .. } => {
                "choose a smaller bandwidth or a shorter sample time, and all three gains for one bandwidth"
            }
        }
    }
}

/// The value, if it lies within the range; NaN never does.
pub(super) fn within(
    name: &'static str,
    value: f64,
    range: RangeInclusive<f64>,
    allowed: &'static str,
) -> Result<f64, ControlError> {
    if range.contains(&value) { Ok(value) } else { Err(ControlError::BadParameter { name, value, allowed }) }
}
