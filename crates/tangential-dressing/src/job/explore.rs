//! `[explore]` of tangential dressing: what a study varies.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

use generating_grinding::job::Steps;

/// What a study varies; every combination is planned. Lengths in mm.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct TangentialExplore {
    /// kappa, the shift of the tool per feed of the tool; the scale along the worm follows it.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "ratio_steps")]
    pub shift_ratio: Option<Steps>,
    /// Tip diameter of the worm; its addendum stays.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "diameter_steps")]
    pub worm_tip_diameter: Option<Steps>,
    /// Tip diameter of the dresser; its addendum stays.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "diameter_steps")]
    pub dresser_tip_diameter: Option<Steps>,
    /// Numbers of threads of the worm.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(schema_with = "threads")]
    pub worm_threads: Vec<u32>,
}

fn ratio_steps(_: &mut SchemaGenerator) -> Schema {
    Steps::schema(json_schema!({
        "type": "number", "minimum": -1000, "maximum": 1000, "x-way-out": "give a ratio of a few units"
    }))
}

fn diameter_steps(_: &mut SchemaGenerator) -> Schema {
    Steps::schema(json_schema!({
        "type": "number", "exclusiveMinimum": 0, "maximum": 2000, "x-way-out": "give the tip diameter in mm"
    }))
}

fn threads(_: &mut SchemaGenerator) -> Schema {
    json_schema!({
        "type": "array",
        "uniqueItems": true,
        "maxItems": 20,
        "items": {
            "type": "integer", "minimum": 1, "maximum": 100,
            "x-way-out": "give the number of threads of the worm, 1 or more"
        }
    })
}
