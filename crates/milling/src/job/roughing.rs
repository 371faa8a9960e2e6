//! `[milling.roughing]`: clearing the space, layer by layer, before its flanks are finished.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How the space is cleared. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Roughing {
    /// What stays on flanks and bottom.
    #[schemars(extend("minimum" = 0, "maximum" = 100, "x-way-out" = "give what is left for finishing in mm, e.g. 0.3"))]
    pub allowance: f64,
    /// Greatest depth of a layer.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the depth of a layer in mm"))]
    pub step_down: f64,
    /// Greatest distance of passes side by side.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the distance of passes in mm, at most the diameter"))]
    pub step_over: f64,
    /// Speed along a pass, mm/min; default that of `[milling]`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e5, "x-way-out" = "give the feed in mm/min, or leave it out"))]
    pub feed_mm_per_min: Option<f64>,
}
