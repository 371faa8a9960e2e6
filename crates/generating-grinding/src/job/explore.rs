//! `[explore]`: settings that a study varies.

use schemars::{JsonSchema, Schema, json_schema};
use serde::{Deserialize, Serialize};

use super::catalogue::FreeWorm;
use super::dressing_study::DressingStudy;

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
    /// A study of the `[catalogue]` with one quantity of its worms free; without it all pairs are ranked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub catalogue: Option<FreeWorm>,
}

/// Equidistant values, both ends included.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Steps {
    /// First value.
    pub from: f64,
    /// Last value.
    pub to: f64,
    /// Number of values.
    pub count: usize,
}

impl Steps {
    /// Values that one study may have in each direction.
    pub const MOST: usize = 10_000;

    /// The values; the ends are met exactly.
    pub fn values(&self) -> impl Iterator<Item = f64> {
        let Self { from, to, count } = *self;
        let last = count.saturating_sub(1);
        (0..count).map(move |i| {
            let share = if last == 0 { 0.0 } else { i as f64 / last as f64 };
            from * (1.0 - share) + to * share
        })
    }

    /// The schema of steps between two values of the schema `end`.
    pub(super) fn schema(end: Schema) -> Schema {
        json_schema!({
            "type": "object",
            "properties": {
                "from": end,
                "to": end,
                "count": {
                    "type": "integer",
                    "minimum": 2,
                    "maximum": Self::MOST,
                    "x-way-out": "give the number of values, both ends included, e.g. 21"
                }
            },
            "required": ["from", "to", "count"],
            "additionalProperties": false
        })
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_meet_both_ends() {
        let values: Vec<f64> = Steps { from: -0.3, to: 0.7, count: 5 }.values().collect();
        assert_eq!((values[0], values[4], values.len()), (-0.3, 0.7, 5));
        assert!((values[1] + 0.05).abs() < 1e-16);
    }
}
