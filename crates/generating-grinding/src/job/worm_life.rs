//! `[explore.worm_life]`: one worm from its first to its last diameter.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The job planned for the diameters of its worm, all dressed by the dresser that is made for the new one. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WormLifeStudy {
    /// Least tip diameter of the worm.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000,
        "x-way-out" = "give the tip diameter at which the worm is worn out, in mm"))]
    pub last_tip_diameter: f64,
    /// Diameters that are planned, the first and the last included; default 7.
    #[serde(default = "usual_count")]
    #[schemars(extend("minimum" = 2, "maximum" = 50, "x-way-out" = "give the number of diameters, e.g. 7"))]
    pub count: usize,
}

fn usual_count() -> usize {
    7
}
