//! `[grinding]`: how the gear is ground.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::diagonal_ratio::DiagonalRatio;
use super::economy::{AxisLimits, Prefer};
use super::gauge::Gauge;
use job::tables::Flanks;

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
    /// What decides among ratios that are good enough for `diagonal_ratio = "auto"`; default `"worm"`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub prefer: Option<Prefer>,
    /// Largest corrections that a plan may ask of the axes on its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axis_limits: Option<AxisLimits>,
    /// Determinant ratio that the envelope keeps along every contact; 0 is a fold, 1 an unmodified flank. Default 0.1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "exclusiveMaximum" = 1,
        "x-way-out" = "give a ratio between 0 (fold) and 1 (unmodified), e.g. 0.3"))]
    pub least_determinant_ratio: Option<f64>,
    /// Whether the exact error is fed back into the commands; default by the method: diagonal yes, radial no.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub precompensation: Option<bool>,
    /// Whether a plan that misses its target plans changes of the job that would meet it, the cheapest first; default true.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub try_changes: Option<bool>,
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
    /// Ratio between the regions of `diagonal_ratio = "areas"`; without it the plan chooses it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = -1000, "maximum" = 1000, "x-way-out" = "give a ratio of a few units; 0 = no shift"))]
    pub free_ratio: Option<f64>,
    /// Which of the equal decompositions of the target is made.
    #[serde(default, skip_serializing_if = "Gauge::is_default")]
    pub gauge: Gauge,
    /// Number of areas of the worm kept for roughing.
    #[serde(default, skip_serializing_if = "is_zero")]
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "leave it out for a worm without roughing areas"))]
    pub roughing_areas: u32,
    /// Diagonal ratio of the roughing strokes; default 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = -1000, "maximum" = 1000, "x-way-out" = "give a ratio of a few units; 0 = no shift"))]
    pub roughing_ratio: Option<f64>,
    /// Threads of the worm that grind, counted from 0; default all.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minItems" = 1, "maxItems" = 100, "uniqueItems" = true))]
    pub active_threads: Option<Vec<u32>>,
}

fn is_zero(areas: &u32) -> bool {
    *areas == 0
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
