//! `[errors]` of the electronic gearbox: what scale or ball screw and the encoder of the workpiece get wrong
//! (`docs/mathematics/gearbox.md#errors-of-what-is-measured`).

use schemars::{JsonSchema, Schema, json_schema};
use serde::{Deserialize, Serialize};

/// Errors of what is measured, as makers state them. Reference pulses come from a scale on the slide, or from an encoder on its ball
/// screw: give one of the two.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GearboxErrors {
    /// Of a scale on the slide.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scale: Option<ScaleErrors>,
    /// Of a ball screw whose encoder takes the place of a scale.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ball_screw: Option<BallScrewErrors>,
    /// Of the encoder on the workpiece spindle.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub encoder: Option<WorkpieceEncoderErrors>,
}

/// Errors of the lines of a scale.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ScaleErrors {
    /// Error that grows along the scale, um/m; positive where lines are too far apart.
    #[serde(default)]
    #[schemars(extend("minimum" = -10_000, "maximum" = 10_000,
        "x-way-out" = "give the error of the scale in micrometres a metre, e.g. 3.0"))]
    pub slope_um_per_m: f64,
    /// Errors that repeat along the scale.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(max = 20))]
    pub periodic: Vec<PeriodicError>,
}

/// An error that repeats along the feed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PeriodicError {
    /// Amplitude, um.
    #[schemars(schema_with = "amplitude_schema")]
    pub amplitude_um: f64,
    /// Period, mm.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e5, "x-way-out" = "give the period of the error in mm, e.g. 20.0"))]
    pub period_mm: f64,
    /// Phase at the position 0.
    #[serde(default)]
    #[schemars(schema_with = "phase_schema")]
    pub phase_deg: f64,
}

/// Errors of a ball screw.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BallScrewErrors {
    /// Lead of the screw.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the lead of the ball screw in mm, e.g. 10.0"))]
    pub lead_mm: f64,
    /// Travel deviation over 300 mm, um; positive where the slide goes too far.
    #[serde(default)]
    #[schemars(extend("minimum" = -3000, "maximum" = 3000,
        "x-way-out" = "give the travel deviation over 300 mm in micrometres, e.g. 12.0 for class 3"))]
    pub travel_um_per_300mm: f64,
    /// Amplitude of the error that repeats with every turn, um.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give half the wobble of a turn in micrometres, e.g. 3.0"))]
    pub wobble_um: f64,
    /// Its phase at the position 0.
    #[serde(default)]
    #[schemars(schema_with = "phase_schema")]
    pub wobble_phase_deg: f64,
    /// What the slide stays behind after a reversal, um.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give the backlash in micrometres, 0 for a preloaded nut"))]
    pub backlash_um: f64,
}

/// Errors of the encoder on the workpiece spindle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WorkpieceEncoderErrors {
    /// Radius of the graduation.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000,
        "x-way-out" = "give the radius on which the encoder has its lines in mm, e.g. 50.0"))]
    pub radius_mm: f64,
    /// Eccentricity of the disc on the spindle, um.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 1000,
        "x-way-out" = "give the eccentricity in micrometres: half of what a dial gauge shows over a turn"))]
    pub eccentricity_um: f64,
    /// Where the eccentricity points.
    #[serde(default)]
    #[schemars(schema_with = "phase_schema")]
    pub eccentricity_phase_deg: f64,
    /// Errors of the graduation that repeat over the turn.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(max = 50))]
    pub periodic: Vec<EncoderHarmonic>,
}

/// An error of a graduation that repeats over the turn.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EncoderHarmonic {
    /// Periods a turn.
    #[schemars(extend("minimum" = 1, "maximum" = 100_000, "x-way-out" = "give the number of periods a turn, 1 or more"))]
    pub order: u32,
    /// Amplitude in seconds of arc.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 3600, "x-way-out" = "give the amplitude in seconds of arc, e.g. 1.0"))]
    pub amplitude_arcsec: f64,
    /// Phase.
    #[serde(default)]
    #[schemars(schema_with = "phase_schema")]
    pub phase_deg: f64,
}

fn amplitude_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({
        "type": "number", "exclusiveMinimum": 0, "maximum": 1000,
        "x-way-out": "give the amplitude in micrometres, e.g. 1.0"
    })
}

fn phase_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({
        "type": "number", "minimum": -360, "maximum": 360,
        "x-way-out": "give the phase in degrees, or leave it out"
    })
}
