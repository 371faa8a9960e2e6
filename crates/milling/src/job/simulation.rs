//! `[simulation]`: rays of the flank that the moving cutter shortens, and what else is compared.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Rays of the simulation; they are the points of the result as well.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MillingSimulation {
    /// Rays from root to tip.
    #[serde(default = "default_profile")]
    #[schemars(extend("minimum" = 3, "maximum" = 2001, "x-way-out" = "81 rays are the default"))]
    pub rays_profile: usize,
    /// Rays along the tooth.
    #[serde(default = "default_length")]
    #[schemars(extend("minimum" = 3, "maximum" = 2001, "x-way-out" = "61 rays are the default"))]
    pub rays_length: usize,
    /// Whether the rotary motion is compared with that of an axis along the flank's parameter lines.
    #[serde(default = "yes")]
    pub compare_orientation: bool,
}

impl Default for MillingSimulation {
    fn default() -> Self {
        Self { rays_profile: default_profile(), rays_length: default_length(), compare_orientation: yes() }
    }
}

fn default_profile() -> usize {
    81
}

fn default_length() -> usize {
    61
}

fn yes() -> bool {
    true
}
