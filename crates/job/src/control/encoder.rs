//! Encoders of spindles, and how the pulses of the slide become a rotation of the workpiece
//! (`docs/mathematics/gearbox.md#from-pulses-to-counts`).

use schemars::{JsonSchema, Schema, json_schema};
use serde::{Deserialize, Serialize};

/// The encoder of the workpiece spindle and how its additional rotation is counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WorkpieceEncoder {
    /// Pulses per revolution of the workpiece.
    #[schemars(schema_with = "encoder_pulses_schema")]
    pub pulses_per_revolution: u32,
    /// How interpolated pulses of the slide become rotation of the workpiece.
    #[serde(default)]
    pub rate: RotationRate,
}

/// The encoder of the worm spindle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WormEncoder {
    /// Pulses per revolution of the worm.
    #[schemars(schema_with = "encoder_pulses_schema")]
    pub pulses_per_revolution: u32,
}

/// How pulses of the slide become rotation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum RotationRate {
    /// By an accumulator of 128 bits: any ratio, less than a part of a pulse off.
    #[default]
    Exact,
    /// By a rate multiplier of 18 bits that passes a pulse whenever the count grows by one: never a whole pulse off. At most one pulse of
    /// rotation for one of the slide.
    Bresenham,
    /// By a rate multiplier of 18 bits that goes by the bits of its counter, as circuits do: up to 3.4 pulses off.
    Binary,
}

/// The range of the pulses of an encoder.
pub fn encoder_pulses_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({
        "type": "integer", "minimum": 1, "maximum": 1_u32 << 31,
        "x-way-out": "give the pulses per revolution of the encoder, e.g. 36000"
    })
}
