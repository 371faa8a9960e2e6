//! `designed_for`: the worm for which a dresser was made; the same in job files and catalogues.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use job::tables::{OneOrSides, pressure_angle_schema};

/// The worm that a dresser was made for, of the hand of the worm that it dresses. At least one of the two diameters is needed.
/// Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DesignedFor {
    /// Number of threads.
    #[schemars(extend("minimum" = 1, "maximum" = 100, "x-way-out" = "give the number of threads of that worm, 1 or more"))]
    pub threads: u32,
    /// Pitch diameter; default tip diameter less 2.5 normal modules.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the pitch diameter of that worm in mm"))]
    pub pitch_diameter: Option<f64>,
    /// Tip diameter; default pitch diameter plus 2.5 normal modules.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the tip diameter of that worm in mm"))]
    pub tip_diameter: Option<f64>,
    /// Normal pressure angle in degrees; default that of the gear.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "pressure_angle_schema")]
    pub normal_pressure_angle_deg: Option<OneOrSides<f64>>,
    /// Normal module; default the one that meshes with the gear. Another one is refused.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100, "x-way-out" = "give the normal module of that worm in mm, or leave it out"))]
    pub normal_module: Option<f64>,
}
