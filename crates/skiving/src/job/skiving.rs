//! `[skiving]`: how tool and workpiece stand to each other while they skive.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The setting of the machine; what is left out is nominal. Lengths in mm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct SkivingSetting {
    /// How both move: a skiving tool on crossed axes, or a shaping cutter on a parallel one.
    #[serde(skip_serializing_if = "ToolKinematics::is_skiving")]
    pub kinematics: ToolKinematics,
    /// z_V1: offset of the tool's datum face from the common normal.
    #[schemars(extend("minimum" = -500, "maximum" = 500, "x-way-out" = "give the offset of the datum face in mm, 0 in the central plane"))]
    pub tool_shift: f64,
    /// d: centre distance, negative for an internal gear; default r_1 + r_2, for an internal gear r_1 - r_2.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = -10_000, "maximum" = 10_000, "x-way-out" = "give d > 0 for external and d < 0 for internal gears, or leave it out"))]
    pub centre_distance: Option<f64>,
    /// gamma: crossed-axes angle, degrees; default -(beta_1 + beta_2), for an internal gear -(beta_1 - beta_2).
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = -90, "exclusiveMaximum" = 90, "x-way-out" = "give the crossed-axes angle in degrees, or leave it out"))]
    pub crossed_axes_angle_deg: Option<f64>,
}

/// How tool and workpiece move.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ToolKinematics {
    /// Crossed axes: the edge cuts on its way through the space while the tool turns.
    #[default]
    Skiving,
    /// Parallel axes: the cutter cuts along its axis, stroke by stroke, while both roll on each other.
    Shaping,
}

impl ToolKinematics {
    #[expect(clippy::trivially_copy_pass_by_ref, reason = "as serde calls it")]
    fn is_skiving(&self) -> bool {
        *self == Self::Skiving
    }
}
