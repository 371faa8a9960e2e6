//! `[gear]` of the electronic gearbox: what the rotation over the feed depends on.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Drawing data of the workpiece as far as its rotation depends on them. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GearboxGear {
    /// Number of teeth; negative for an internal gear.
    #[schemars(extend("minimum" = -2000, "maximum" = 2000, "not" = {"const": 0},
        "x-way-out" = "give the number of teeth of the drawing; negative for an internal gear"))]
    pub teeth: i32,
    /// Normal module.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100,
        "x-way-out" = "give the normal module of the drawing in mm"))]
    pub normal_module: f64,
    /// Normal pressure angle in degrees.
    #[schemars(extend("minimum" = 5, "maximum" = 45,
        "x-way-out" = "give the normal pressure angle of the drawing in degrees, e.g. 20.0"))]
    pub normal_pressure_angle_deg: f64,
    /// Helix angle at the pitch cylinder in degrees, positive for a right-hand gear.
    #[schemars(extend("exclusiveMinimum" = -90, "exclusiveMaximum" = 90,
        "x-way-out" = "give the helix angle in degrees: 0 for a spur gear, > 0 right-hand, < 0 left-hand"))]
    pub helix_angle_deg: f64,
}
