//! `machine.probe`: a touch probe that finds the clocking angle of a workpiece whose teeth are cut already.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A touch probe in the spindle: a ball on a stem. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TouchProbe {
    /// Number of the tool.
    #[schemars(extend("minimum" = 1, "maximum" = 99_999_999, "x-way-out" = "give the number of the probe in the machine's store"))]
    pub number: u32,
    /// Diameter of the ball.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100, "x-way-out" = "give the diameter of the ball in mm, smaller than the space"))]
    pub diameter: f64,
    /// Diameter of the stem; default 0.6 of the ball's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100, "x-way-out" = "give the diameter of the stem in mm, smaller than the ball"))]
    pub stem_diameter: Option<f64>,
    /// From the nose of the spindle to the tip of the ball.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the distance from spindle nose to the tip of the ball in mm"))]
    pub tool_length: f64,
    /// Number of its length on the control, as that of a cutter.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 1, "maximum" = 999, "x-way-out" = "give the number behind H or D, or leave it out"))]
    pub length_offset: Option<u32>,
    /// Height of the ball's centre above the root body; default that of the middle of the flank.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the height above the root body in mm, or leave it out"))]
    pub height: Option<f64>,
    /// How far the table turns on beyond where the flank is expected before it is an alarm, degrees.
    #[serde(default = "default_search")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 20, "x-way-out" = "give the angle in degrees; 2 is the default"))]
    pub search_deg: f64,
    /// Speed of the table towards a flank, deg/min.
    #[serde(default = "default_turn")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 3600, "x-way-out" = "give the speed in deg/min; 60 is the default"))]
    pub turn_deg_per_min: f64,
    /// Speed into the space and out of it, mm/min.
    #[serde(default = "default_feed")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e5, "x-way-out" = "give the feed in mm/min; 500 is the default"))]
    pub feed_mm_per_min: f64,
}

fn default_search() -> f64 {
    2.0
}

fn default_turn() -> f64 {
    60.0
}

fn default_feed() -> f64 {
    500.0
}
