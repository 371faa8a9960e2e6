//! `[explore]`: settings that a study varies.

use schemars::{JsonSchema, Schema, json_schema};
use serde::{Deserialize, Serialize};

use super::catalogue::FreeWorm;
use super::dressing_study::DressingStudy;
use super::steps::Steps;
use super::worm_life::WormLifeStudy;

/// Settings that a study varies; every combination is computed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Explore {
    /// Diagonal ratio K.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "ratio_steps")]
    pub diagonal_ratio: Option<Steps>,
    /// Cone angle of the worm, degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "cone_steps")]
    pub worm_cone_angle_deg: Option<Steps>,
    /// Crossed-axes angle of worm and gear, degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "crossing_steps")]
    pub crossed_axes_angle_deg: Option<Steps>,
    /// A study of dressing in place of the others.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dressing: Option<DressingStudy>,
    /// One worm over its life in place of the others.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub worm_life: Option<WormLifeStudy>,
    /// A study of the `[catalogue]` with one quantity of its worms free; without it all pairs are ranked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub catalogue: Option<FreeWorm>,
}

fn ratio_steps(_: &mut schemars::SchemaGenerator) -> Schema {
    Steps::schema(json_schema!({
        "type": "number", "minimum": -1000, "maximum": 1000, "x-way-out": "give a ratio of a few units"
    }))
}

fn cone_steps(_: &mut schemars::SchemaGenerator) -> Schema {
    Steps::schema(json_schema!({
        "type": "number", "exclusiveMinimum": -90, "exclusiveMaximum": 90,
        "x-way-out": "give the cone angle of the worm in degrees"
    }))
}

fn crossing_steps(_: &mut schemars::SchemaGenerator) -> Schema {
    Steps::schema(json_schema!({
        "type": "number", "minimum": -180, "maximum": 180,
        "x-way-out": "give the crossed-axes angle of worm and gear in degrees"
    }))
}
