//! `[worm]` of tangential dressing: the grinding worm, cylindrical, its threads as thick as their spaces.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use job::tables::Hand;

/// The grinding worm. At least one of the two diameters is needed. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TangentialWorm {
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
    /// Usable width along the axis; without it the width needed is reported.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000,
        "x-way-out" = "give the usable width of the worm in mm, or leave it out"))]
    pub width: Option<f64>,
}
