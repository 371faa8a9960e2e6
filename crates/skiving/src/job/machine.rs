//! `[machine]` of measuring a skiving tool: which machine, how the tool sits in its spindle, what triggers the recorder.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The machine. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SkivingMachine {
    /// Machine description (TOML or JSON), beside the job file.
    #[schemars(extend("minLength" = 1))]
    pub file: String,
    /// From the spindle's origin to the tool's datum face, along the spindle axis.
    #[serde(default)]
    #[schemars(extend("minimum" = -2000, "maximum" = 2000, "x-way-out" = "give the distance from the spindle's origin to the datum face in mm"))]
    pub tool_length: f64,
    /// Angle at which tooth 0 stands in the spindle, degrees.
    #[serde(default)]
    #[schemars(extend("minimum" = -360, "maximum" = 360, "x-way-out" = "give the angle in degrees, or leave it out"))]
    pub tooth_angle_deg: f64,
    /// How far the tool goes back from the beam between poses.
    #[serde(default = "default_retreat")]
    #[schemars(extend("minimum" = 1, "maximum" = 1000, "x-way-out" = "give the distance in mm; 20 is the default"))]
    pub retreat: f64,
    /// The axis that brings the light barrier before the tool, or the tool before the light barrier, and parks it again.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub carrier: Option<BarrierCarrier>,
    /// Number of the digital output that tells the recorder to take readings.
    #[serde(default = "default_output")]
    #[schemars(extend("minimum" = 1, "maximum" = 15, "x-way-out" = "give the number of a digital output, 1 to 15"))]
    pub output: u8,
}

/// A carrier with a place in which the tool is measured, and one before and after. `light_barrier` is stated for the place in which it
/// measures.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BarrierCarrier {
    /// Name of the axis: one of the workpiece's chain that carries the light barrier beside the work spindle, or the first of the tool's.
    #[schemars(extend("minLength" = 1))]
    pub axis: String,
    /// Where a carrier that swivels stands while the tool is measured, degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = -360, "maximum" = 360, "x-way-out" = "give the angle of the carrier in degrees"))]
    pub measuring_deg: Option<f64>,
    /// Where it stands before and after, degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = -360, "maximum" = 360, "x-way-out" = "give the angle of the carrier in degrees"))]
    pub parked_deg: Option<f64>,
    /// Where a carrier that slides stands while the tool is measured.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = -100_000, "maximum" = 100_000, "x-way-out" = "give the position of the carrier in mm"))]
    pub measuring: Option<f64>,
    /// Where it stands before and after.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = -100_000, "maximum" = 100_000, "x-way-out" = "give the position of the carrier in mm"))]
    pub parked: Option<f64>,
}

impl Default for SkivingMachine {
    fn default() -> Self {
        Self {
            file: String::new(),
            tool_length: 0.0,
            tooth_angle_deg: 0.0,
            retreat: default_retreat(),
            carrier: None,
            output: default_output(),
        }
    }
}

fn default_retreat() -> f64 {
    20.0
}

fn default_output() -> u8 {
    1
}
