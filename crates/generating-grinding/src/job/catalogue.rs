//! `[catalogue]`: worms and dressers that are there, in place of `[worm]` and `[dresser]`.

use schemars::{JsonSchema, Schema, json_schema};
use serde::{Deserialize, Serialize};

/// A catalogue from which worm and dresser are chosen. The files stand beside the job file unless their paths are absolute.
/// Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CatalogueSource {
    /// A TOML or JSON file with entries `[[worm]]` and `[[dresser]]`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minLength" = 1))]
    pub file: Option<String>,
    /// A table of worms (CSV), instead of `file`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minLength" = 1))]
    pub worms_csv: Option<String>,
    /// A table of dressers (CSV), instead of `file`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minLength" = 1))]
    pub dressers_csv: Option<String>,
    /// Clearance between the gear's tip and the worm's root; default 0.25 normal modules.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0, "maximum" = 100, "x-way-out" = "give the clearance in mm, or leave it out"))]
    pub root_clearance: Option<f64>,
    /// Largest relative stretch |P| of the profile.
    #[serde(default = "largest_stretch")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10, "x-way-out" = "give a share such as 0.1, or leave it out"))]
    pub largest_stretch: f64,
    /// Width that the tip land of a dresser must at least have where the catalogue does not state its land.
    #[serde(default = "smallest_tip_land")]
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give the width of the tip land in mm, or leave it out"))]
    pub smallest_tip_land: f64,
    /// Distance that the dresser keeps from the opposite flank of the thread space.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 100, "x-way-out" = "give the distance in mm, or leave it out"))]
    pub clearance: f64,
    /// What the pairs are ranked by: the profile crowning of the target, or what a plan of the whole target leaves.
    #[serde(default)]
    pub rank_by: RankBy,
    /// Pairs that are planned with `rank_by = "whole-target"`, those first whose range of crownings serves the whole width; default
    /// 12.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 1, "maximum" = MOST_PLANS, "x-way-out" = "each plan takes seconds; a few tens are usual"))]
    pub plans: Option<u32>,
    /// Positions z over the face width at which the wanted profile crowning and that of the plans are compared, with `rank_by =
    /// "whole-target"`, ascending; default the ends and the middle of the evaluated width.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "positions_schema")]
    pub crowning_at: Option<Vec<f64>>,
}

/// Pairs that a ranking by plans may plan.
const MOST_PLANS: u32 = 200;

/// What pairs are ranked by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RankBy {
    /// The profile crowning of the target, one number for the whole width: fast.
    #[default]
    Profile,
    /// What a plan of the whole target leaves on the flank.
    WholeTarget,
}

fn positions_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({
        "type": "array", "minItems": 1, "maxItems": 21,
        "items": { "type": "number", "minimum": -10000, "maximum": 10000 },
        "x-way-out": "give positions z of the gear in mm, the smallest first"
    })
}

fn largest_stretch() -> f64 {
    0.1
}

fn smallest_tip_land() -> f64 {
    0.5
}

/// A study in which one quantity of the worms of a catalogue is free: with which values does each dresser make the target?
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FreeWorm {
    /// What is free; all else stays as the catalogue has it.
    pub free: FreeQuantity,
    /// Smallest value.
    #[schemars(schema_with = "value_schema")]
    pub from: f64,
    /// Largest value.
    #[schemars(schema_with = "value_schema")]
    pub to: f64,
}

/// A quantity of the worm that is free.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FreeQuantity {
    /// Pitch diameter in mm.
    PitchDiameter,
    /// Normal pressure angle of the left flank in degrees.
    PressureAngle,
    /// Number of threads.
    Threads,
}

impl FreeQuantity {
    /// The word in job files.
    pub fn name(self) -> &'static str {
        match self {
            Self::PitchDiameter => "pitch-diameter",
            Self::PressureAngle => "pressure-angle",
            Self::Threads => "threads",
        }
    }

    /// The quantity in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::PitchDiameter => "pitch diameter of the worm",
            Self::PressureAngle => "normal pressure angle of the worm",
            Self::Threads => "number of threads of the worm",
        }
    }

    /// Values that it may have.
    pub fn range(self) -> [f64; 2] {
        match self {
            Self::PitchDiameter => [1.0, 2000.0],
            Self::PressureAngle => [5.0, 45.0],
            Self::Threads => [1.0, 100.0],
        }
    }
}

fn value_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({
        "type": "number", "exclusiveMinimum": 0, "maximum": 2000,
        "x-way-out": "give a diameter in mm, an angle in degrees or a number of threads"
    })
}
