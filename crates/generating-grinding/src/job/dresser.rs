//! `[dresser]`: the disc that profiles the worm.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::designed_for::DesignedFor;
use job::tables::Modification;

/// The disc dresser. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Dresser {
    /// Tip diameter.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the tip diameter of the dresser in mm"))]
    pub tip_diameter: f64,
    /// How the disc touches the worm: along a line over the whole profile, or in a point with its rounded tip, line by line.
    #[serde(default, skip_serializing_if = "DresserContact::is_default")]
    pub contact: DresserContact,
    /// Radius of the rounded tip of a disc in point contact, whose sides are parallel.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100, "x-way-out" = "give the tip radius of the disc in mm, e.g. 0.5"))]
    pub tip_radius: Option<f64>,
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
    /// Width of the cylindrical land at the tip; default the largest that clears the opposite flank.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give the width of the tip land in mm, or leave it out"))]
    pub tip_land: Option<f64>,
    /// What profile the dresser carries.
    #[serde(default)]
    pub modification: DresserModification,
    /// Another worm for which the dresser was made; default the worm of the job.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub designed_for: Option<DesignedFor>,
    /// Further dressers of the same worm, for the strokes of `[dressing.strokes]`; they count from 2.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(max = 12))]
    pub others: Vec<OtherDresser>,
}

/// A further dresser, made for the worm of the job. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OtherDresser {
    /// Tip diameter.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the tip diameter of the dresser in mm"))]
    pub tip_diameter: f64,
    /// Pitch diameter; with it the dressing centre distance is the sum of the pitch radii, without it the disc tip touches the
    /// worm root.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000,
        "x-way-out" = "give the pitch diameter of the dresser in mm, or leave it out"))]
    pub pitch_diameter: Option<f64>,
    /// What profile it carries; default none.
    #[serde(default = "plain")]
    pub modification: DresserModification,
}

fn plain() -> DresserModification {
    DresserModification::Rule(FixedDresser::None)
}

/// How the disc touches the worm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum DresserContact {
    /// Along a line: its profile is that of the worm.
    #[default]
    Line,
    /// In a point: it writes the worm line by line.
    Point,
}

impl DresserContact {
    fn is_default(&self) -> bool {
        *self == Self::default()
    }
}

/// Profile modification of the dresser.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum DresserModification {
    /// `"target"` or `"none"`.
    Rule(FixedDresser),
    /// A dresser that exists: one entry as in `[target] modifications`, of a profile kind.
    Given(Modification),
    /// The same with several entries, which add up; each may be for one flank.
    Sum(Vec<Modification>),
}

impl DresserModification {
    /// What a dresser that exists carries; `None` if it is made for the target.
    pub fn given(&self) -> Option<&[Modification]> {
        match self {
            Self::Rule(FixedDresser::Target) => None,
            Self::Rule(FixedDresser::None) => Some(&[]),
            Self::Given(entry) => Some(std::slice::from_ref(entry)),
            Self::Sum(entries) => Some(entries),
        }
    }
}

impl Default for DresserModification {
    fn default() -> Self {
        Self::Rule(FixedDresser::Target)
    }
}

/// Where the dresser's profile comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum FixedDresser {
    /// It is made for the target: profile terms and reliefs.
    Target,
    /// It is plain.
    None,
}
