//! `[[technology.strokes]]`: what a stroke leaves, how fast it runs, which way and where on the worm.

use job::tables::{OneOrSides, one_or_sides_schema};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

/// A stroke of a part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StrokeOfJob {
    /// Stock that it leaves, normal, um; one value, or one for each flank: a flank that keeps all its stock is not ground. The last stroke
    /// leaves 0, and no stroke leaves more than the one before.
    #[schemars(schema_with = "left")]
    pub left_um: OneOrSides<f64>,
    /// Feed per revolution of the workpiece, mm; default `grinding.feed_per_revolution`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 20, "x-way-out" = "give the feed in mm, e.g. 0.3"))]
    pub feed_per_revolution: Option<f64>,
    /// Speed of the worm's tip, m/s; default `machine.cutting_speed_m_per_s`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 200, "x-way-out" = "give the cutting speed in m/s, e.g. 50"))]
    pub cutting_speed_m_per_s: Option<f64>,
    /// Which way the workpiece feeds past the worm; default "up".
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub direction: Option<FeedDirection>,
    /// Shift of the worm while it feeds; a stroke that leaves 0 shifts as planned.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shift: Option<StrokeShift>,
    /// Share of the modification that the roughing area of a stroke makes, beside the profile, which the dresser has everywhere: the amount
    /// of its cut. Without it the dresser stands still in the roughing areas; needs `grinding.roughing_areas`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0, "maximum" = 2,
        "x-way-out" = "give a share of the wanted modification, e.g. 0.5; 1 makes all of it"))]
    pub modification_share: Option<f64>,
    /// How far it goes on beyond first and last contact, mm; default `grinding.overrun`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0, "maximum" = 200, "x-way-out" = "give the way in mm, e.g. 1"))]
    pub overrun: Option<f64>,
    /// Pause after it, s; default none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give the time in s, or leave it out"))]
    pub dwell_s: Option<f64>,
    /// Area of the worm that it uses; default with `grinding.roughing_areas` "roughing" for a stroke that leaves stock and "finishing" for one
    /// that leaves none, else "all".
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub zone: Option<StrokeZone>,
}

fn left(_: &mut SchemaGenerator) -> Schema {
    one_or_sides_schema(json_schema!({
        "type": "number",
        "minimum": 0,
        "maximum": 5000,
        "x-way-out": "give what the stroke leaves in um, 0 for finishing"
    }))
}

/// Sense of the feed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum FeedDirection {
    /// z_V2 rises.
    Up,
    /// z_V2 falls.
    Down,
}

/// z_V1 = ratio z_V2 + origin.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StrokeShift {
    /// Diagonal ratio; default that of the plan.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = -1000, "maximum" = 1000, "x-way-out" = "give a ratio of a few units, or leave it out"))]
    pub ratio: Option<f64>,
    /// Shift at z_V2 = 0, mm; default that of the plan.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = -10_000, "maximum" = 10_000, "x-way-out" = "give the shift in mm, or leave it out"))]
    pub origin: Option<f64>,
    /// Jump from part to part, mm; default `technology.step_per_part`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = -100, "maximum" = 100, "x-way-out" = "give the jump in mm, or leave it out"))]
    pub step_per_part: Option<f64>,
}

/// An area of the worm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum StrokeZone {
    /// The worm has one area for all strokes.
    All,
    /// The areas for roughing.
    Roughing,
    /// The area for finishing.
    Finishing,
}

impl StrokeZone {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::All => "all",
            Self::Roughing => "roughing",
            Self::Finishing => "finishing",
        }
    }
}
