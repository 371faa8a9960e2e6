//! `dressing.conditions`: what the dressing corrections have to meet, as words for the usual ones and as tables for those with numbers,
//! which may change over the width of the worm.

use super::over_width::{OverWidth, correction, micrometres, share, stretch, weight};
use foundation::geometry::Flank;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

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

    /// The word in job files.
    pub fn name(self) -> &'static str {
        match self {
            Self::PhiS => "phi_S",
            Self::Gamma => "gamma",
            Self::D => "d",
            Self::Vy => "v_y",
        }
    }
}

/// A condition on the dressed worm by a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ConditionWord {
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

impl ConditionWord {
    /// The component that a `fix-` condition holds.
    fn fixes(self) -> Option<DegreeOfFreedom> {
        match self {
            Self::FixPhiS => Some(DegreeOfFreedom::PhiS),
            Self::FixGamma => Some(DegreeOfFreedom::Gamma),
            Self::FixD => Some(DegreeOfFreedom::D),
            Self::FixVy => Some(DegreeOfFreedom::Vy),
            Self::ThreePoint | Self::FourPoint | Self::RadiusMap | Self::Head => None,
        }
    }

    /// Rows beside those of fixed components, which [`Dressing::fixed`] counts once each.
    fn rows(self) -> usize {
        match self {
            Self::ThreePoint => 3,
            Self::FourPoint => 4,
            Self::RadiusMap | Self::Head => 1,
            Self::FixPhiS | Self::FixGamma | Self::FixD | Self::FixVy => 0,
        }
    }
}

/// A condition on the dressed worm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Condition {
    /// A word.
    Word(ConditionWord),
    /// A table.
    Of(ConditionOf),
}

impl From<ConditionWord> for Condition {
    fn from(word: ConditionWord) -> Self {
        Self::Word(word)
    }
}

/// A condition with numbers of its own. Shares count over the used profile of the worm from w_NfS (0), which grinds the tip of the gear, to
/// w_NaS (1), which grinds its root form circle. A condition with a weight is met as nearly as possible: the sum of the squares of weight times
/// miss is the least, where 1 um of a point or of the head, 1 % of the profile of a map or of the stretch, 0.01 degrees or 0.01 mm of a
/// correction is a miss of 1.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum ConditionOf {
    /// The worm is met exactly at a point of its profile.
    Point(PointCondition),
    /// A place of the dresser's profile finishes a place of the worm's.
    Map(MapCondition),
    /// The profile is stretched.
    Stretch(StretchCondition),
    /// The head part of the dresser finishes the worm's tip at a given height.
    Head(HeadCondition),
    /// A correction is given.
    Fixed(FixedCondition),
}

/// A point of the worm's profile.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointCondition {
    /// Its place, as a share of the profile.
    #[schemars(schema_with = "share")]
    pub at: OverWidth,
    /// Its flank; needed where one motion serves both flanks, else not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flank: Option<Flank>,
    /// Weight of a miss; default none: the condition is met exactly.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "weight")]
    pub weight: Option<f64>,
}

/// Which place of the dresser finishes which place of the worm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MapCondition {
    /// Share of the profile that the dresser was designed for.
    #[schemars(schema_with = "share")]
    pub dresser: OverWidth,
    /// Share of the worm's profile.
    #[schemars(schema_with = "share")]
    pub at: OverWidth,
    /// The flank; needed where one motion serves both flanks, else not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flank: Option<Flank>,
    /// Weight of a miss; default none: the condition is met exactly.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "weight")]
    pub weight: Option<f64>,
}

/// How much longer the dressed profile is than the designed one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StretchCondition {
    /// Relative stretch, positive = longer.
    #[schemars(schema_with = "stretch")]
    pub percent: OverWidth,
    /// The flank; needed where one motion serves both flanks, else not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flank: Option<Flank>,
    /// Weight of a miss; default none: the condition is met exactly.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "weight")]
    pub weight: Option<f64>,
}

/// Where the head of the dresser touches the worm's tip, and how high.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HeadCondition {
    /// Distance from where the dresser stands, along the worm, mm.
    #[serde(default)]
    #[schemars(extend("minimum" = -200, "maximum" = 200, "x-way-out" = "give the distance along the worm in mm, e.g. 0"))]
    pub position: f64,
    /// Threads further up the worm, each by an axial pitch; below 0 further down.
    #[serde(default)]
    #[schemars(extend("minimum" = -20, "maximum" = 20, "x-way-out" = "give a whole number of threads, e.g. 1"))]
    pub thread: i32,
    /// Height above the tip that is wanted there, um.
    #[serde(default = "level")]
    #[schemars(schema_with = "micrometres")]
    pub above_um: OverWidth,
    /// Weight of a miss; default none: the condition is met exactly.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "weight")]
    pub weight: Option<f64>,
}

fn level() -> OverWidth {
    OverWidth::Constant(0.0)
}

/// A correction that is given: an angle in degrees or a length in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FixedCondition {
    /// Which one.
    pub axis: DegreeOfFreedom,
    /// Its value, degrees; of "phi_S" and "gamma".
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "correction")]
    pub deg: Option<OverWidth>,
    /// Its value, mm; of "d" and "v_y".
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "correction")]
    pub mm: Option<OverWidth>,
    /// Weight of a miss; default none: the condition is met exactly.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "weight")]
    pub weight: Option<f64>,
}

impl ConditionOf {
    /// As [`Condition::weight`].
    pub fn weight(&self) -> Option<f64> {
        match self {
            Self::Point(PointCondition { weight, .. })
            | Self::Map(MapCondition { weight, .. })
            | Self::Stretch(StretchCondition { weight, .. })
            | Self::Head(HeadCondition { weight, .. })
            | Self::Fixed(FixedCondition { weight, .. }) => *weight,
        }
    }
}

impl Condition {
    /// The component that a condition holds where it is.
    pub fn fixes(&self) -> Option<DegreeOfFreedom> {
        match self {
            Self::Word(word) => word.fixes(),
            Self::Of(_) => None,
        }
    }

    /// The weight of a condition that is met as nearly as possible; `None` for one that is met exactly.
    pub fn weight(&self) -> Option<f64> {
        match self {
            Self::Word(_) => None,
            Self::Of(condition) => condition.weight(),
        }
    }

    /// Rows beside those of components that keep their nominal value, which [`super::Dressing::fixed`] counts once each.
    pub(super) fn rows(&self) -> usize {
        match self {
            Self::Word(word) => word.rows(),
            Self::Of(_) => 1,
        }
    }
}
