//! Torques that disturb the workpiece spindle: in time, or in the angle of worm or workpiece.

use schemars::{JsonSchema, Schema, json_schema};
use serde::{Deserialize, Serialize};

/// A torque on the workpiece spindle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "lowercase", deny_unknown_fields)]
pub enum Disturbance {
    /// Always the same.
    Constant {
        /// Torque, N m.
        #[schemars(schema_with = "torque_schema")]
        torque_n_m: f64,
    },
    /// None before a moment, always the same after it.
    Step {
        /// Torque after the moment, N m.
        #[schemars(schema_with = "torque_schema")]
        torque_n_m: f64,
        /// The moment, s.
        #[schemars(extend("minimum" = 0, "maximum" = 1e6, "x-way-out" = "give the moment in s after the begin"))]
        at_s: f64,
    },
    /// A sine in time.
    Harmonic {
        /// Amplitude, N m.
        #[schemars(schema_with = "torque_schema")]
        torque_n_m: f64,
        /// Frequency, Hz.
        #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e6, "x-way-out" = "give the frequency in Hz, e.g. 50"))]
        frequency_hz: f64,
        /// Phase at the begin, degrees.
        #[serde(default)]
        #[schemars(schema_with = "phase_schema")]
        phase_deg: f64,
    },
    /// A sine in the angle of a spindle.
    Order {
        /// Amplitude, N m.
        #[schemars(schema_with = "torque_schema")]
        torque_n_m: f64,
        /// The spindle whose angle counts.
        axis: Spindle,
        /// Periods per revolution of the spindle.
        #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e6,
            "x-way-out" = "give the periods per revolution, e.g. the number of teeth"))]
        order: f64,
        /// Phase at angle 0, degrees.
        #[serde(default)]
        #[schemars(schema_with = "phase_schema")]
        phase_deg: f64,
    },
    /// Equal pulses at equal angles of a spindle, the first from angle 0 on.
    Pulses {
        /// Torque during a pulse, N m; none between pulses.
        #[schemars(schema_with = "torque_schema")]
        torque_n_m: f64,
        /// The spindle whose angle counts.
        axis: Spindle,
        /// Pulses per revolution of the spindle.
        #[schemars(extend("minimum" = 1, "maximum" = 1_000_000, "x-way-out" = "give the pulses per revolution, 1 or more"))]
        per_revolution: u32,
        /// Angle over which a pulse lasts, degrees.
        #[schemars(extend("exclusiveMinimum" = 0, "exclusiveMaximum" = 360, "x-way-out" = "give the angle of a pulse in degrees"))]
        width_deg: f64,
    },
}

impl Disturbance {
    /// The spindle in whose angle the torque runs; `None` if it runs in time.
    pub fn axis(&self) -> Option<Spindle> {
        match *self {
            Self::Order { axis, .. } | Self::Pulses { axis, .. } => Some(axis),
            Self::Constant { .. } | Self::Step { .. } | Self::Harmonic { .. } => None,
        }
    }
}

/// A spindle whose angle a torque follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Spindle {
    /// The worm.
    Worm,
    /// The workpiece.
    Workpiece,
}

fn torque_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({ "type": "number", "minimum": -1e6, "maximum": 1e6, "x-way-out": "give the torque in N m" })
}

fn phase_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({
        "type": "number", "minimum": -360, "maximum": 360, "x-way-out": "give the phase in degrees, or leave it out"
    })
}
