//! `[dresser]` of tangential dressing: the disc that profiles the worm, made for the target or there already.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use generating_grinding::job::{DesignedFor, DresserModification};

/// The disc dresser. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TangentialDresser {
    /// Tip diameter.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the tip diameter of the dresser in mm"))]
    pub tip_diameter: f64,
    /// Pitch diameter; with it the dressing centre distance is the sum of the pitch radii, without it the disc
    /// tip touches the worm root.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000,
        "x-way-out" = "give the pitch diameter of the dresser in mm, or leave it out"))]
    pub pitch_diameter: Option<f64>,
    /// Clearance between the gear's tip and the worm's root; default 0.25 normal modules.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0, "maximum" = 100, "x-way-out" = "give the clearance in mm, or leave it out"))]
    pub root_clearance: Option<f64>,
    /// Depth of its flank below the pitch circle; default that of the worm's tip.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 200,
        "x-way-out" = "give the depth of the flank in mm, at most 1.75 normal modules, or leave it out"))]
    pub flank_depth: Option<f64>,
    /// The profile before anything is added to it.
    #[serde(default)]
    pub profile: DresserProfile,
    /// What profile the dresser carries. One that exists is not changed: the channels Fp, FpL and FpR then take no part.
    #[serde(default)]
    pub modification: DresserModification,
    /// Another worm for which a dresser that exists was made; default the worm of the job.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub designed_for: Option<DesignedFor>,
}

impl TangentialDresser {
    /// Whether it exists, so that its profile is what it is.
    pub fn exists(&self) -> bool {
        self.modification.given().is_some()
    }
}

/// The nominal profile of the dresser.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum DresserProfile {
    /// Conjugate to the involute worm: without modifications the gear is an exact involute.
    #[default]
    Conjugate,
    /// A straight line, as published: its error stays on the gear unless variables take it away.
    Straight,
}
