//! `[compare]` of the electronic gearbox: multipliers of older controls on the same motion
//! (`docs/mathematics/gearbox.md#older-multipliers`).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Multipliers of older controls, beside the interpolator on the same motion and scale.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GearboxCompare {
    /// A phase-locked loop.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pll: Option<ComparedLoop>,
    /// Interpolation between the amplitudes of sine and cosine.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub amplitude: Option<ComparedAmplitude>,
}

/// A phase-locked loop of second order.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ComparedLoop {
    /// Natural frequency.
    #[schemars(extend("minimum" = 0.01, "maximum" = 100_000,
        "x-way-out" = "give the natural frequency of the loop in Hz, e.g. 50.0"))]
    pub bandwidth_hz: f64,
    /// Damping.
    #[serde(default = "default_damping")]
    #[schemars(extend("minimum" = 0.05, "maximum" = 10, "x-way-out" = "give the damping, e.g. 0.7"))]
    pub damping: f64,
}

/// Sine and cosine of the scale, divided by their amplitudes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ComparedAmplitude {
    /// Zero of both signals, in percent of their amplitude.
    #[schemars(extend("minimum" = -50, "maximum" = 50, "x-way-out" = "give the offset in percent of the amplitude, e.g. 1.0"))]
    pub offset_percent: f64,
    /// Difference of the amplitudes, in percent of their mean.
    #[schemars(extend("minimum" = -50, "maximum" = 50,
        "x-way-out" = "give the difference of the amplitudes in percent, e.g. 2.0"))]
    pub mismatch_percent: f64,
    /// What the signals are off a quarter of a period by.
    #[schemars(extend("minimum" = -25, "maximum" = 25, "x-way-out" = "give the error of the phase in degrees, e.g. 1.0"))]
    pub phase_error_deg: f64,
    /// Time from signal to pulse.
    #[schemars(extend("minimum" = 0, "maximum" = 100_000, "x-way-out" = "give the delay in microseconds, e.g. 3.0"))]
    pub delay_us: f64,
}

fn default_damping() -> f64 {
    0.7
}
