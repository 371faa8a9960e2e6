//! `[dressing.gear_root]`: the root of the gear, ground by the tip of the worm that the dresser's head makes.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The root circle of the gear is ground to `gear.root_diameter`, the fillet by the rounded edge of the worm's tip. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GearRoot {
    /// Radius of the edge between flank and tip of the worm.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100, "x-way-out" = "give the radius of the worm's edge in mm"))]
    pub corner_radius: f64,
    /// How the root runs along the face.
    #[serde(default)]
    pub along: RootAlong,
    /// Least radius of curvature that the fillet must have.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100, "x-way-out" = "give the radius in mm, or leave it out"))]
    pub least_fillet_radius: Option<f64>,
}

/// How the root runs along the face.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum RootAlong {
    /// It is a cylinder: the head of the dresser lets the worm's tip follow what the centre distance does.
    #[default]
    Constant,
    /// The worm's tip is a cylinder: the root follows the centre distance.
    Follows,
}
