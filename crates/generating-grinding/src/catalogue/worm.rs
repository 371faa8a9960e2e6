//! `[[worm]]`: a grinding worm of a catalogue.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use job::tables::{Hand, OneOrSides, pressure_angle_schema};

/// A grinding worm that is there. At least one of the two diameters is needed. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WormEntry {
    /// What the shop calls it; each name once.
    #[schemars(extend("minLength" = 1, "maxLength" = 100))]
    pub name: String,
    /// Number of threads.
    #[schemars(extend("minimum" = 1, "maximum" = 100, "x-way-out" = "give the number of threads of the worm, 1 or more"))]
    pub threads: u32,
    /// Hand of the threads; default the hand of the gear (spur: right).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hand: Option<Hand>,
    /// Current pitch diameter; default tip diameter less 2.5 normal modules.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the pitch diameter of the worm in mm"))]
    pub pitch_diameter: Option<f64>,
    /// Current tip diameter; default pitch diameter plus 2.5 normal modules.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the tip diameter of the worm in mm"))]
    pub tip_diameter: Option<f64>,
    /// Pitch diameter down to which it may be dressed; without this or the next key it is looked at as it is now.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000,
        "x-way-out" = "give the pitch diameter of the worn worm in mm, or leave it out"))]
    pub smallest_pitch_diameter: Option<f64>,
    /// Tip diameter down to which it may be dressed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000,
        "x-way-out" = "give the tip diameter of the worn worm in mm, or leave it out"))]
    pub smallest_tip_diameter: Option<f64>,
    /// Normal pressure angle in degrees; default that of the gear.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "pressure_angle_schema")]
    pub normal_pressure_angle_deg: Option<OneOrSides<f64>>,
    /// Normal module; default the one that meshes with the gear. A worm of another one is refused.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100,
        "x-way-out" = "give the normal module of the worm in mm, or leave it out"))]
    pub normal_module: Option<f64>,
    /// Usable width along the axis.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the usable width of the worm in mm"))]
    pub width: f64,
}
