//! Encoders of spindles, and how the pulses of the slide become a rotation of the workpiece (spec 70 section 4).

use schemars::{JsonSchema, Schema, json_schema};
use serde::{Deserialize, Serialize};

/// The encoder of the workpiece spindle and the multiplier of its additional rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WorkpieceEncoder {
    /// Pulses per revolution of the workpiece.
    #[schemars(schema_with = "encoder_pulses_schema")]
    pub pulses_per_revolution: u32,
    /// Which of the interpolated pulses pass to the workpiece.
    #[serde(default)]
    pub rate: MultiplierRate,
}

/// The encoder of the worm spindle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WormEncoder {
    /// Pulses per revolution of the worm.
    #[schemars(schema_with = "encoder_pulses_schema")]
    pub pulses_per_revolution: u32,
}

/// The rule by which a rate multiplier lets pulses pass.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum MultiplierRate {
    /// Whenever the exact count grows by one: never a whole pulse off.
    #[default]
    Bresenham,
    /// By the bits of a counter of 18 places, as circuits do: up to 3.4 pulses off.
    Binary,
}

pub(in crate::exchange) fn encoder_pulses_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({
        "type": "integer", "minimum": 1, "maximum": 1_u32 << 31,
        "x-way-out": "give the pulses per revolution of the encoder, e.g. 36000"
    })
}
