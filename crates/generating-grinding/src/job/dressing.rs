//! `[dressing]`: how the worm is dressed.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::conditions::{Condition, ConditionOf, ConditionWord, DegreeOfFreedom};
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
    /// What the correction has to meet, words or tables: four conditions, or more of which some have a weight.
    #[serde(default = "default_conditions")]
    #[schemars(extend("uniqueItems" = true, "minItems" = 1, "maxItems" = 12))]
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
    vec![ConditionWord::ThreePoint.into(), ConditionWord::RadiusMap.into()]
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

    /// Whether the corrections are to meet three points and the radius map with all four motions, as they do by default.
    pub fn has_usual_conditions(&self) -> bool {
        self.conditions == Self::default().conditions && self.fixed().is_empty()
    }

    /// Height of the scallops between dressing lines, um.
    pub fn scallop_height_um(&self) -> f64 {
        self.scallop_um.unwrap_or(SCALLOP_UM)
    }

    /// Rows of the system of conditions: four of them, or more of which some have a weight.
    pub fn rows(&self) -> usize {
        self.fixed().len() + self.conditions.iter().map(Condition::rows).sum::<usize>()
    }

    /// Rows that are met as nearly as their weights ask.
    pub fn weighed_rows(&self) -> usize {
        self.conditions.iter().filter(|condition| condition.weight().is_some()).count()
    }

    /// Whether a condition holds the height of the worm's tip.
    pub fn dresses_head(&self) -> bool {
        let head = |c: &Condition| {
            let asks =
                matches!(c, Condition::Word(ConditionWord::Head) | Condition::Of(ConditionOf::Head(_)));
            asks && c.weight().is_none()
        };
        self.conditions.iter().any(head)
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
