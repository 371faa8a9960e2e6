//! `[grinding]` of tangential dressing: flanks and the shift of the tool.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use job::tables::Flanks;

/// How the gear is ground: the tool shifts by F_T = kappa z + F_T0 over its feed z along the gear axis. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TangentialGrinding {
    /// Flanks that are ground to the target.
    #[serde(default)]
    pub flanks: Flanks,
    /// kappa, the shift of the tool per feed of the tool.
    #[serde(default)]
    pub shift_ratio: ShiftRatio,
    /// b_w, the range of the tool shift over the face width, and the scale of the dresser's position in its laws; needed by
    /// `shift_ratio = "width"`, else by default |shift_ratio| times face width.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 5000,
        "x-way-out" = "give the range of the tool shift in mm, e.g. 1.2 times the face width"))]
    pub shift_width: Option<f64>,
    /// F_T0, the shift of the tool in the middle of the feed.
    #[serde(default)]
    pub shift_offset: ShiftOffset,
    /// Axial feed per revolution of the gear, mm: for the programs, default 0.3, and for `[control]`, which needs it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100,
        "x-way-out" = "give the axial feed in mm per revolution of the gear, e.g. 0.3"))]
    pub feed_per_revolution: Option<f64>,
}

/// Shift of the tool per feed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum ShiftRatio {
    /// This ratio.
    Number(
        #[schemars(extend("minimum" = -1000, "maximum" = 1000,
            "x-way-out" = "give a ratio of a few units, \"width\" or \"neutral\""))]
        f64,
    ),
    /// A word.
    Rule(ShiftRule),
}

impl Default for ShiftRatio {
    fn default() -> Self {
        Self::Rule(ShiftRule::default())
    }
}

/// How the ratio follows from other entries.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ShiftRule {
    /// b_w/b_g: `shift_width` over the face width.
    #[default]
    Width,
    /// kappa_0, with which the dresser's position depends on the face position only.
    Neutral,
}

/// Shift of the tool in the middle of the feed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum ShiftOffset {
    /// This shift, mm.
    Number(
        #[schemars(extend("minimum" = -5000, "maximum" = 5000,
            "x-way-out" = "give the shift in mm, or \"contact\""))]
        f64,
    ),
    /// A word.
    Rule(OffsetRule),
}

impl Default for ShiftOffset {
    fn default() -> Self {
        Self::Rule(OffsetRule::default())
    }
}

/// How the offset follows from the bodies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum OffsetRule {
    /// F_T0*, with which the middle of the flank is ground where the dresser stood in the middle of the worm; it differs
    /// from flank to flank.
    #[default]
    Contact,
}
