//! `[calibration]`: the beam measured with a mandrel in the tool spindle.

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Serialize};

use super::light_barrier::point_schema;
use super::list_schema;

/// A mandrel driven into the beam, the spindle upright. Without switches the places at which the given beam will switch, and how well
/// they will tell it, are worked out. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MandrelCalibration {
    /// R: radius of the mandrel.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 500, "x-way-out" = "give the radius of the mandrel in mm"))]
    pub radius: f64,
    /// h: its height.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 500, "x-way-out" = "give the height of the mandrel in mm; a low one tells most"))]
    pub height: f64,
    /// Positions Z of its lower face at which the beam is to be approached, where there are no switches yet.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "heights_schema")]
    pub heights: Option<[f64; 2]>,
    /// Standard deviation of a switch, um.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give the standard deviation in micrometres"))]
    pub noise_um: f64,
    /// From the spindle's origin to the lower face of the mandrel, along the spindle axis; default `machine.tool_length`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = -2000, "maximum" = 2000, "x-way-out" = "give the distance from the spindle's origin to the mandrel's lower face in mm"))]
    pub mandrel_length: Option<f64>,
    /// Turns of the spindle, evenly spaced from 0, at which the mandrel is driven into the beam: 2 and more average its run-out.
    #[serde(default = "default_positions")]
    #[schemars(extend("minimum" = 1, "maximum" = 36, "x-way-out" = "give the number of spindle positions: 1, or 2 (0 and 180 degrees) to average the run-out"))]
    pub spindle_positions: usize,
    /// Speed of the mandrel towards the beam and through it, mm/min.
    #[serde(default = "default_speed")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10_000, "x-way-out" = "give the speed in mm/min; 60 is the default"))]
    pub speed_mm_per_min: f64,
    /// How far the beam may be from where it is given: the approaches begin so far before the switch and end so far behind it.
    #[serde(default = "default_reach")]
    #[schemars(extend("minimum" = 0.1, "maximum" = 100, "x-way-out" = "give the distance in mm; 3 is the default"))]
    pub reach: f64,
    /// Places of the mandrel at which the beam switched: at each height two along Y and one along X, or more.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("maxItems" = 1000))]
    pub switches: Vec<MandrelSwitch>,
}

/// A place of the mandrel at which the beam switched.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MandrelSwitch {
    /// Along which axis it moved.
    pub along: CalibrationMove,
    /// X and Y of its axis, Z of its lower face.
    #[schemars(schema_with = "point_schema")]
    pub place: [f64; 3],
}

/// Axis along which the mandrel moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum CalibrationMove {
    /// X.
    X,
    /// Y.
    Y,
}

fn default_positions() -> usize {
    1
}

fn default_speed() -> f64 {
    60.0
}

fn default_reach() -> f64 {
    3.0
}

fn heights_schema(_: &mut SchemaGenerator) -> Schema {
    list_schema([2, 2], [-10_000.0, 10_000.0], "give two positions Z of the mandrel's lower face in mm")
}
