//! `[workpiece]` and `[worm]` of the electronic gearbox: the spindle that follows and the one that leads.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use job::control::{RotationRate, WorkpieceEncoder, encoder_pulses_schema};

/// The workpiece spindle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GearboxWorkpiece {
    /// Pulses per revolution of the workpiece.
    #[schemars(schema_with = "encoder_pulses_schema")]
    pub pulses_per_revolution: u32,
    /// Which of the interpolated pulses pass to the workpiece.
    #[serde(default)]
    pub rate: RotationRate,
    /// Whether spindle or slide of the machine count in the other sense, so that a right-hand gear turns backward over the feed.
    #[serde(default)]
    pub reversed: bool,
}

impl GearboxWorkpiece {
    /// Encoder and multiplier without the sense of the machine.
    pub fn encoder(&self) -> WorkpieceEncoder {
        WorkpieceEncoder { pulses_per_revolution: self.pulses_per_revolution, rate: self.rate }
    }
}

/// The tool spindle that leads the workpiece.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LeadingWorm {
    /// Number of threads.
    #[schemars(extend("minimum" = 1, "maximum" = 100, "x-way-out" = "give the number of threads of the worm, 1 or more"))]
    pub threads: u32,
    /// Pulses per revolution of the worm.
    #[schemars(schema_with = "encoder_pulses_schema")]
    pub pulses_per_revolution: u32,
    /// Speed of the worm, 1/min.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100_000, "x-way-out" = "give the speed of the worm in 1/min, e.g. 3000"))]
    pub speed_rpm: f64,
}
