//! `[explore]` of the electronic gearbox: what there is to choose from, and at what cost.

use schemars::{JsonSchema, Schema, json_schema};
use serde::{Deserialize, Serialize};

use job::control::{clock_schema, encoder_pulses_schema, pulses_per_interval_schema, scale_pulses_schema};

/// Scales, clocks, interpolations and encoders to choose from: every combination is judged, and the cheapest that is accurate
/// enough is looked for. What has no list is as in `[feed]` and `[workpiece]`, at no cost.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GearboxExplore {
    /// Error of the flank that is wanted at most, um.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e6, "x-way-out" = "give the largest error of the flank in micrometres, e.g. 0.5"))]
    pub wanted_um: f64,
    /// Scales of the feed slide.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(min = 1, max = 50))]
    pub scales: Vec<ScaleChoice>,
    /// Clocks of the interpolator.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(min = 1, max = 50))]
    pub clocks: Vec<ClockChoice>,
    /// Interpolations.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(min = 1, max = 50))]
    pub interpolations: Vec<InterpolationChoice>,
    /// Encoders of the workpiece spindle.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(min = 1, max = 50))]
    pub encoders: Vec<EncoderChoice>,
    /// Speed of the feed, mm/min; default the greatest of the motion.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e7, "x-way-out" = "give the speed of the feed in mm/min, e.g. 300"))]
    pub speed_mm_per_min: Option<f64>,
    /// Acceleration of the feed, mm/s^2; default the greatest of the motion.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e7, "x-way-out" = "give the acceleration of the feed in mm/s^2, e.g. 200"))]
    pub acceleration_mm_per_s2: Option<f64>,
}

impl GearboxExplore {
    /// Whether there is nothing to choose from.
    pub fn is_fixed(&self) -> bool {
        self.scales.is_empty()
            && self.clocks.is_empty()
            && self.interpolations.is_empty()
            && self.encoders.is_empty()
    }
}

/// A scale of the feed slide.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ScaleChoice {
    /// Reference pulses per metre of feed.
    #[schemars(schema_with = "scale_pulses_schema")]
    pub pulses_per_metre: f64,
    /// What it costs, in any unit.
    #[schemars(schema_with = "cost_schema")]
    pub cost: f64,
}

/// A clock of the interpolator.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ClockChoice {
    /// Its frequency.
    #[schemars(schema_with = "clock_schema")]
    pub clock_hz: f64,
    /// What it costs, in any unit.
    #[schemars(schema_with = "cost_schema")]
    pub cost: f64,
}

/// An interpolation.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct InterpolationChoice {
    /// Pulses per reference interval, the reference pulse included.
    #[schemars(schema_with = "pulses_per_interval_schema")]
    pub pulses_per_interval: u32,
    /// What it costs, in any unit.
    #[schemars(schema_with = "cost_schema")]
    pub cost: f64,
}

/// An encoder of the workpiece spindle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EncoderChoice {
    /// Pulses per revolution of the workpiece.
    #[schemars(schema_with = "encoder_pulses_schema")]
    pub pulses_per_revolution: u32,
    /// What it costs, in any unit.
    #[schemars(schema_with = "cost_schema")]
    pub cost: f64,
}

fn cost_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({
        "type": "number", "minimum": 0, "maximum": 1e12, "x-way-out": "give what it costs in any unit; 0: it is there"
    })
}
