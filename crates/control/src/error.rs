//! Errors of the data of a control (`docs/mathematics/gearbox.md#limits`).

use finding::Finding;
use std::ops::RangeInclusive;
use thiserror::Error;

/// Why a control, its budget or its simulation refuses.
#[derive(Clone, Copy, Debug, PartialEq, Error, Finding)]
pub enum ControlError {
    /// A parameter is NaN, infinite or outside its range.
    #[error("{name} = {value} is not usable; allowed: {allowed}")]
    #[finding(code = "bad-parameter")]
    #[way_out("give a finite value within the range")]
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
    #[finding(code = "interpolator-too-fast")]
    #[way_out("feed slower, insert fewer pulses, or take a faster clock or a coarser scale")]
    TooFast {
        /// Speed, mm/s.
        speed: f64,
        /// Greatest speed f1 p/P, mm/s.
        greatest: f64,
    },
    /// The sampled loop does not settle.
    #[error("the loop is unstable: its largest pole has the modulus {largest_pole}; allowed: below 1")]
    #[finding(code = "unstable-loop")]
    #[way_out("choose a smaller bandwidth or a shorter sample time, and all three gains for one bandwidth")]
    UnstableLoop {
        /// Largest modulus of the poles.
        largest_pole: f64,
    },
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
