//! `[workpiece_probe]`: the machined workpiece measured in the machine by a probe in the tool spindle.

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Serialize};

/// A probe with a ball that scans the profiles of some tooth spaces, both flanks, along their base circle. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WorkpieceProbe {
    /// Radius of the ball.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 20, "x-way-out" = "give the radius of the ball in mm; it must fit into the tooth space"))]
    pub ball_radius: f64,
    /// From the spindle's origin to the centre of the ball, along the spindle axis.
    #[schemars(extend("minimum" = -2000, "maximum" = 2000, "x-way-out" = "give the distance from the spindle's origin to the ball's centre in mm"))]
    pub length: f64,
    /// How far the ball stands beside the spindle axis, along the spindle's x.
    #[serde(default)]
    #[schemars(extend("minimum" = -500, "maximum" = 500, "x-way-out" = "give the distance of the ball from the spindle axis in mm, 0 for a straight probe"))]
    pub reach: f64,
    /// Swivel A of the probe, degrees.
    #[serde(default)]
    #[schemars(extend("minimum" = -180, "maximum" = 180, "x-way-out" = "give the swivel of the tool head in degrees"))]
    pub swivel_deg: f64,
    /// Turn B of the spindle with the probe, degrees.
    #[serde(default)]
    #[schemars(extend("minimum" = -360, "maximum" = 360, "x-way-out" = "give the turn of the tool spindle in degrees"))]
    pub spindle_deg: f64,
    /// Tooth spaces that are scanned, from 0; three or more.
    #[schemars(schema_with = "gaps_schema")]
    pub gaps: Vec<usize>,
    /// Places of a profile.
    #[serde(default = "default_places")]
    #[schemars(extend("minimum" = 5, "maximum" = 1000, "x-way-out" = "give the number of places of a profile; 21 is the default"))]
    pub places: usize,
    /// Where it scans, from the middle of the face along the axis.
    #[serde(default)]
    #[schemars(extend("minimum" = -5000, "maximum" = 5000, "x-way-out" = "give the place of the scan along the face in mm, 0 in the middle"))]
    pub height: f64,
    /// From the origin of the work spindle to the middle of the workpiece's face, along its axis.
    #[serde(default)]
    #[schemars(extend("minimum" = -5000, "maximum" = 5000, "x-way-out" = "give the height of the middle of the face above the origin of the work spindle in mm"))]
    pub work_height: f64,
    /// Speed of the ball along the flank and towards it, mm/min.
    #[serde(default = "default_speed")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10_000, "x-way-out" = "give the speed in mm/min; 60 is the default"))]
    pub speed_mm_per_min: f64,
    /// How far the ball stays off tip circle and flanks before it is laid on.
    #[serde(default = "default_clearance")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 500, "x-way-out" = "give the distance in mm; 2 is the default"))]
    pub clearance: f64,
    /// Standard deviation of a value of the probe, um; of a simulated measurement.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give the standard deviation in micrometres, 0 for none"))]
    pub noise_um: f64,
    /// Start of the random numbers of a simulated measurement.
    #[serde(default = "one")]
    pub seed: u64,
    /// How far the machine's setting is off what it shows; the workpiece whose measurement is simulated was made with it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub setting_errors: Option<SettingErrors>,
    /// Values of a real measurement: a table (CSV) with the columns flank, gap, roll_mm, deviation_um, beside the job file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minLength" = 1))]
    pub readings: Option<String>,
}

/// A setting that is off what the machine shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct SettingErrors {
    /// Of the centre distance, um.
    #[schemars(extend("minimum" = -1000, "maximum" = 1000, "x-way-out" = "give the error in micrometres"))]
    pub centre_distance_um: f64,
    /// Of the crossed-axes angle, degrees.
    #[schemars(extend("minimum" = -1, "maximum" = 1, "x-way-out" = "give the error in degrees"))]
    pub crossed_axes_angle_deg: f64,
    /// Of the tool shift, um.
    #[schemars(extend("minimum" = -5000, "maximum" = 5000, "x-way-out" = "give the error in micrometres"))]
    pub tool_shift_um: f64,
    /// Of the tool's angle against the coupling, degrees.
    #[schemars(extend("minimum" = -1, "maximum" = 1, "x-way-out" = "give the error in degrees"))]
    pub tool_angle_deg: f64,
}

impl SettingErrors {
    /// As a change of [d, gamma, z_V1, phi_1], mm and rad.
    pub(crate) fn change(&self) -> [f64; 4] {
        [
            1e-3 * self.centre_distance_um,
            self.crossed_axes_angle_deg.to_radians(),
            1e-3 * self.tool_shift_um,
            self.tool_angle_deg.to_radians(),
        ]
    }
}

fn default_places() -> usize {
    21
}

fn default_speed() -> f64 {
    60.0
}

fn default_clearance() -> f64 {
    2.0
}

fn one() -> u64 {
    1
}

fn gaps_schema(_: &mut SchemaGenerator) -> Schema {
    schemars::json_schema!({
        "type": "array",
        "items": { "type": "integer", "minimum": 0, "maximum": 9999, "x-way-out": "give numbers of tooth spaces, from 0" },
        "minItems": 3,
        "maxItems": 1000,
        "uniqueItems": true
    })
}
