//! `[worm]`: the grinding worm.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::choices::Hand;
use super::one_or_sides::{OneOrSides, pressure_angle_schema};

/// The grinding worm. At least one of the two diameters is needed. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Worm {
    /// Number of threads.
    #[schemars(extend("minimum" = 1, "maximum" = 100, "x-way-out" = "give the number of threads of the worm, 1 or more"))]
    pub threads: u32,
    /// Hand of the threads; default the hand of the gear (spur: right).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hand: Option<Hand>,
    /// Pitch diameter; default tip diameter less 2.5 normal modules.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the pitch diameter of the worm in mm"))]
    pub pitch_diameter: Option<f64>,
    /// Tip diameter; default pitch diameter plus 2.5 normal modules.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the tip diameter of the worm in mm"))]
    pub tip_diameter: Option<f64>,
    /// Normal pressure angle in degrees; default that of the gear.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "pressure_angle_schema")]
    pub normal_pressure_angle_deg: Option<OneOrSides<f64>>,
    /// Profile shift coefficient of the worm.
    #[serde(default)]
    #[schemars(extend("minimum" = -20, "maximum" = 20, "x-way-out" = "leave it out: the gear's shift goes into the centre distance"))]
    pub profile_shift: f64,
    /// Usable width along the axis; without it the width needed is reported.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000,
        "x-way-out" = "give the usable width of the worm in mm, or leave it out"))]
    pub width: Option<f64>,
    /// Cone angle in degrees; 0 for a cylindrical worm.
    #[serde(default)]
    #[schemars(extend("exclusiveMinimum" = -90, "exclusiveMaximum" = 90,
        "x-way-out" = "leave the cone angle out for a cylindrical worm"))]
    pub cone_angle_deg: f64,
}
