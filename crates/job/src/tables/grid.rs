//! `[grid]`: points of the result.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Points of the result grid, equidistant in length of roll and face width.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Grid {
    /// Points along the profile; at most 40401 along both together.
    #[serde(default = "default_points")]
    #[schemars(extend("minimum" = 3, "maximum" = 1001, "x-way-out" = "41 points are the default; profile_points x helix_points may be up to 40401"))]
    pub profile_points: usize,
    /// Points along the face width; at most 40401 along both together.
    #[serde(default = "default_points")]
    #[schemars(extend("minimum" = 3, "maximum" = 1001, "x-way-out" = "41 points are the default; profile_points x helix_points may be up to 40401"))]
    pub helix_points: usize,
}

impl Default for Grid {
    fn default() -> Self {
        Self { profile_points: default_points(), helix_points: default_points() }
    }
}

fn default_points() -> usize {
    41
}
