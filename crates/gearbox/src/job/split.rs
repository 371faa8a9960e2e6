//! `[split]` of the electronic gearbox: whole workpiece pulses to the controller, the part of one as a voltage
//! (`docs/mathematics/gearbox.md#coarse-and-fine`).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The rotation as a controller of two inputs gets it: whole workpiece pulses as increments, the part below one from a converter.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GearboxSplit {
    /// Voltage of a whole workpiece pulse at the controller.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000,
        "x-way-out" = "give the voltage that stands for one workpiece pulse, e.g. 10.0"))]
    pub volts_per_pulse: f64,
    /// Bits of the converter.
    #[serde(default = "default_bits")]
    #[schemars(extend("minimum" = 1, "maximum" = 24, "x-way-out" = "give the bits of the converter, e.g. 12"))]
    pub bits: u32,
    /// Voltage that the converter gives at 0.
    #[serde(default)]
    #[schemars(extend("minimum" = -10_000, "maximum" = 10_000,
        "x-way-out" = "give the offset of the converter in millivolts, or leave it out"))]
    pub offset_mv: f64,
    /// By how much its voltage is too large.
    #[serde(default)]
    #[schemars(extend("minimum" = -50, "maximum" = 50,
        "x-way-out" = "give the error of the slope in percent, or leave it out"))]
    pub gain_error_percent: f64,
}

fn default_bits() -> u32 {
    12
}
