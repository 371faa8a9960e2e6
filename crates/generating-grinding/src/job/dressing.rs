//! `[dressing]`: how the worm is dressed.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::gear_root::GearRoot;
use super::strokes::Strokes;
use super::worm::direction_schema;
use job::tables::OneOrSides;

/// How the worm is dressed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Dressing {
    /// Motions that may be corrected; default all four.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("uniqueItems" = true, "minItems" = 1))]
    pub degrees_of_freedom: Option<Vec<DegreeOfFreedom>>,
    /// What the correction has to meet; together four conditions.
    #[serde(default = "default_conditions")]
    #[schemars(extend("uniqueItems" = true, "minItems" = 1))]
    pub conditions: Vec<Condition>,
    /// One flank after the other, each with its own motion, or both with one motion.
    #[serde(default)]
    pub flanks: DressingFlanks,
    /// Strokes that divide the worm's profile; default one stroke for all of it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strokes: Option<Strokes>,
    /// What makes the profile crowning.
    #[serde(default)]
    pub profile_crowning_by: ProfileCrowningBy,
    /// The worm's tip grinds the root of the gear; goes with the condition `"head"`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gear_root: Option<GearRoot>,
    /// Direction rho_1 of the lines that a disc in point contact writes, degrees, w_1 sin rho_1 + z_1 cos rho_1 = constant;
    /// default the generatrix, or those with which both flanks ask for the same diagonal ratio.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "direction_schema")]
    pub line_direction_deg: Option<OneOrSides<f64>>,
    /// Height of the scallops that a disc in point contact may leave between its lines, um; default 0.2.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0.001, "maximum" = 100,
        "x-way-out" = "give the height of the scallops in micrometres, e.g. 0.2"))]
    pub scallop_um: Option<f64>,
}

/// Height of scallops where the job gives none, um.
const SCALLOP_UM: f64 = 0.2;

impl Default for Dressing {
    fn default() -> Self {
        Self {
            degrees_of_freedom: None,
            conditions: default_conditions(),
            flanks: DressingFlanks::default(),
            strokes: None,
            profile_crowning_by: ProfileCrowningBy::default(),
            gear_root: None,
            line_direction_deg: None,
            scallop_um: None,
        }
    }
}

fn default_conditions() -> Vec<Condition> {
    vec![Condition::ThreePoint, Condition::RadiusMap]
}

impl Dressing {
    /// Motions that keep their nominal value: left out of `degrees_of_freedom` or held by a `fix-` condition.
    pub fn fixed(&self) -> Vec<DegreeOfFreedom> {
        let fixed = |axis: &DegreeOfFreedom| {
            self.degrees_of_freedom.as_ref().is_some_and(|free| !free.contains(axis))
                || self.conditions.iter().any(|c| c.fixes() == Some(*axis))
        };
        DegreeOfFreedom::ALL.into_iter().filter(fixed).collect()
    }

    /// Height of the scallops between dressing lines, um.
    pub fn scallop_height_um(&self) -> f64 {
        self.scallop_um.unwrap_or(SCALLOP_UM)
    }

    /// Rows of the system of conditions; four make it determinate.
    pub fn rows(&self) -> usize {
        self.fixed().len() + self.conditions.iter().map(|c| c.rows()).sum::<usize>()
    }
}

/// A component of the dressing correction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum DegreeOfFreedom {
    /// Phase of the worm.
    #[serde(rename = "phi_S")]
    PhiS,
    /// Crossing angle.
    #[serde(rename = "gamma")]
    Gamma,
    /// Centre distance.
    #[serde(rename = "d")]
    D,
    /// Offset of the dresser along its tangent.
    #[serde(rename = "v_y")]
    Vy,
}

impl DegreeOfFreedom {
    /// All components in the order of the correction vector.
    pub const ALL: [DegreeOfFreedom; 4] = [Self::PhiS, Self::Gamma, Self::D, Self::Vy];
}

/// A condition on the dressed worm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Condition {
    /// Three points of the worm's profile.
    ThreePoint,
    /// Four points of the worm's profile.
    FourPoint,
    /// A given radius of the dresser finishes a given radius of the worm.
    RadiusMap,
    /// The head part of the dresser finishes the worm's tip radius.
    Head,
    /// The phase keeps its nominal value.
    #[serde(rename = "fix-phi_S")]
    FixPhiS,
    /// The crossing angle keeps its nominal value.
    FixGamma,
    /// The centre distance keeps its nominal value.
    FixD,
    /// The offset keeps its nominal value.
    #[serde(rename = "fix-v_y")]
    FixVy,
}

impl Condition {
    /// The component that a `fix-` condition holds.
    pub fn fixes(self) -> Option<DegreeOfFreedom> {
        match self {
            Condition::FixPhiS => Some(DegreeOfFreedom::PhiS),
            Condition::FixGamma => Some(DegreeOfFreedom::Gamma),
            Condition::FixD => Some(DegreeOfFreedom::D),
            Condition::FixVy => Some(DegreeOfFreedom::Vy),
            Condition::ThreePoint | Condition::FourPoint | Condition::RadiusMap | Condition::Head => None,
        }
    }

    /// Rows beside those of fixed components, which [`Dressing::fixed`] counts once each.
    fn rows(self) -> usize {
        match self {
            Condition::ThreePoint => 3,
            Condition::FourPoint => 4,
            Condition::RadiusMap | Condition::Head => 1,
            Condition::FixPhiS | Condition::FixGamma | Condition::FixD | Condition::FixVy => 0,
        }
    }
}

/// Flanks that one dressing motion serves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum DressingFlanks {
    /// One flank after the other, each with its own motion.
    #[default]
    One,
    /// Both flanks with one motion.
    Two,
}

/// What makes the profile crowning of the gear.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ProfileCrowningBy {
    /// The dresser's profile.
    Dresser,
    /// The dressing correction.
    Correction,
    /// The diagonal ratio with a correction of the grinding motion.
    Diagonal,
    /// The best of those that the dresser allows.
    #[default]
    Auto,
}
