//! `[stimulus]` of the electronic gearbox: what the feed slide does, as a train of reference pulses or as a motion.

use schemars::{JsonSchema, Schema, json_schema};
use serde::{Deserialize, Serialize};

use super::travel::Move;

/// What the feed slide does: exactly one of `references`, `reference_ticks` and `motion`. Lengths in mm.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Stimulus {
    /// Reference pulses as a table (CSV) with the columns tick, sign, beside the job file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minLength" = 1))]
    pub references: Option<String>,
    /// Ticks of the reference pulses, rising from 1 on.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "ticks_schema")]
    pub reference_ticks: Option<Vec<u64>>,
    /// Their signs, +1 for upward and -1 for downward, as many as there are ticks.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "signs_schema")]
    pub reference_signs: Option<Vec<i64>>,
    /// Tick up to which a train runs; default the last reference pulse.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 1, "maximum" = GREATEST_TICK, "x-way-out" = "give a tick after the last reference pulse, or leave it out"))]
    pub last_tick: Option<u64>,
    /// Moves of the slide one after the other.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(length(min = 1, max = 1000))]
    pub motion: Option<Vec<Move>>,
    /// Position of the slide before a motion; default 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = -1e5, "maximum" = 1e5, "x-way-out" = "give the position before the motion in mm, or leave it out"))]
    pub start: Option<f64>,
    /// Time at rest after a motion, s; default 0.1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0, "maximum" = 86_400, "x-way-out" = "give the time at rest after the motion in s, or leave it out"))]
    pub rest_s: Option<f64>,
}

impl Stimulus {
    /// Position of the slide before the motion, mm.
    pub fn start_or_default(&self) -> f64 {
        self.start.unwrap_or(0.0)
    }

    /// Time at rest after the motion, s.
    pub fn rest_or_default(&self) -> f64 {
        self.rest_s.unwrap_or(0.1)
    }
}

/// Greatest tick: 2^53, up to which a number of JSON is exact.
pub const GREATEST_TICK: u64 = 1 << 53;

fn ticks_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({
        "type": "array", "minItems": 1,
        "items": {
            "type": "integer", "minimum": 0, "maximum": GREATEST_TICK,
            "x-way-out": "give the tick of the reference pulse, counted from 1"
        }
    })
}

/// Which signs can be is the business of the gearbox; here they have to be whole numbers.
fn signs_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({ "type": "array", "minItems": 1, "items": { "type": "integer" } })
}
