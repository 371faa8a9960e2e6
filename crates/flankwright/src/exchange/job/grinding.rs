//! `[grinding]`: how the gear is ground.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use super::choices::Flanks;

/// How the gear is ground. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Grinding {
    /// With or without shift of the worm.
    pub method: Method,
    /// Flanks ground at once.
    #[serde(default)]
    pub flanks: Flanks,
    /// Shift of the worm per feed of the gear; default `"auto"` (method radial: 0).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub diagonal_ratio: Option<DiagonalRatio>,
    /// Whether the exact error is fed back into the commands; default by the method: diagonal yes, radial no.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub precompensation: Option<bool>,
    /// Axial feed per revolution of the gear, for the feed marks.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100,
        "x-way-out" = "give the axial feed in mm per revolution of the gear, e.g. 0.3"))]
    pub feed_per_revolution: Option<f64>,
    /// Travel of the feed beyond the first and last contact; never less than 1 mm and one feed mark.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give the travel beyond the first and last contact in mm, or leave it out"))]
    pub overrun: Option<f64>,
    /// Number of areas of the worm used one after the other.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 1, "maximum" = 1000, "x-way-out" = "leave it out for one area"))]
    pub areas: Option<u32>,
}

/// The grinding method.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Method {
    /// The worm shifts along its axis while it feeds.
    Diagonal,
    /// No shift: modifications along the face width by the centre distance only.
    Radial,
}

/// Shift of the worm per feed of the gear.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum DiagonalRatio {
    /// This ratio.
    Number(
        #[schemars(extend("minimum" = -1000, "maximum" = 1000,
            "x-way-out" = "give a ratio of a few units, or \"auto\""))]
        f64,
    ),
    /// `"auto"`.
    Rule(DiagonalRule),
    /// A ratio that changes over the feed.
    Table(Map<String, Value>),
}

/// How the ratio is chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum DiagonalRule {
    /// The plan chooses it and says why.
    Auto,
}
