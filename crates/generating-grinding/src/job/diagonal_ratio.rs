//! `[grinding] diagonal_ratio`: how the worm shifts while it feeds: one ratio, a rule, or a law that changes over
//! the feed.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use foundation::geometry::Flank;

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
    /// A word.
    Rule(DiagonalRule),
    /// A shift that is no multiple of the feed.
    Law(Box<ShiftLaw>),
}

/// How the ratio is chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum DiagonalRule {
    /// The plan chooses one ratio and says why.
    Auto,
    /// Each modified region of the gear has the ratio that its direction asks for; between them `free_ratio`.
    Areas,
    /// A law of the feed, fitted to the target together with worm, dresser and motion.
    Variable,
}

/// A shift z_V1 that is any function of the feed z_V2: exactly one of the two
/// keys.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShiftLaw {
    /// The curve on the gear that one line of the worm grinds.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub curve: Option<ShiftCurve>,
    /// The shift over the feed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub table: Option<ShiftTable>,
}

/// A curve z(w) on a flank of the gear, w = length of roll, that the line X_1 = x_ref_mm of the worm grinds.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum ShiftCurve {
    /// A slope that ends in a level line, rounded between them.
    LineBlend(LineBlendCurve),
    /// A slope with a sine on it.
    LineSine(LineSineCurve),
    /// Points of the curve.
    Points(PointsCurve),
}

/// z = z_e + slope {x for x < -h, -(x - h)^2/(4 h) for |x| <= h, 0 for x > h}, x = w - w_t.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LineBlendCurve {
    /// Slope dz/dw of the inclined part.
    #[schemars(extend("minimum" = -1000, "maximum" = 1000, "x-way-out" = "give dz/dw, the tangent of the direction on the flank"))]
    pub slope: f64,
    /// Length of roll w_t at the transition, mm.
    #[schemars(extend("minimum" = -10000, "maximum" = 10000, "x-way-out" = "give the length of roll at the transition in mm"))]
    pub w_t_mm: f64,
    /// Half length of roll h of the transition, mm.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10000, "x-way-out" = "give half the length of roll of the transition in mm, more than 0"))]
    pub h_mm: f64,
    /// Face position z_e of the level part, mm.
    #[schemars(extend("minimum" = -10000, "maximum" = 10000, "x-way-out" = "give the face position of the level part in mm"))]
    pub z_e_mm: f64,
    /// The worm line X_1 that grinds the curve, mm.
    #[serde(default)]
    #[schemars(extend("minimum" = -10000, "maximum" = 10000, "x-way-out" = "leave it out for the line X_1 = 0"))]
    pub x_ref_mm: f64,
    /// The flank on which the curve lies; the other one follows.
    pub flank: Flank,
}

/// z = slope x + a sin(x/p), x = w - w_0.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LineSineCurve {
    /// Slope dz/dw of the middle line.
    #[schemars(extend("minimum" = -1000, "maximum" = 1000, "x-way-out" = "give dz/dw, the tangent of the direction on the flank"))]
    pub slope: f64,
    /// Length of roll w_0 at z = 0, mm.
    #[schemars(extend("minimum" = -10000, "maximum" = 10000, "x-way-out" = "give the length of roll at z = 0 in mm"))]
    pub w_0_mm: f64,
    /// Amplitude a, mm.
    #[schemars(extend("minimum" = -10000, "maximum" = 10000, "x-way-out" = "give the amplitude along the face width in mm"))]
    pub a_mm: f64,
    /// Phase length p, mm of roll: one period is 2 pi p.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10000, "x-way-out" = "give the period divided by 2 pi in mm, more than 0"))]
    pub p_mm: f64,
    /// The worm line X_1 that grinds the curve, mm.
    #[serde(default)]
    #[schemars(extend("minimum" = -10000, "maximum" = 10000, "x-way-out" = "leave it out for the line X_1 = 0"))]
    pub x_ref_mm: f64,
    /// The flank on which the curve lies; the other one follows.
    pub flank: Flank,
}

/// A curve through points, w ascending.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointsCurve {
    /// Lengths of roll, ascending, mm.
    #[schemars(extend("minItems" = 2, "maxItems" = 100_000))]
    pub w_mm: Vec<f64>,
    /// Face positions, mm.
    #[schemars(extend("minItems" = 2, "maxItems" = 100_000))]
    pub z_mm: Vec<f64>,
    /// The worm line X_1 that grinds the curve, mm.
    #[serde(default)]
    #[schemars(extend("minimum" = -10000, "maximum" = 10000, "x-way-out" = "leave it out for the line X_1 = 0"))]
    pub x_ref_mm: f64,
    /// The flank on which the curve lies; the other one follows.
    pub flank: Flank,
}

/// The shift over the feed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShiftTable {
    /// Feed positions z_V2, ascending, mm.
    #[schemars(extend("minItems" = 2, "maxItems" = 100_000))]
    pub z_v2_mm: Vec<f64>,
    /// Shifts z_V1, mm.
    #[schemars(extend("minItems" = 2, "maxItems" = 100_000))]
    pub z_v1_mm: Vec<f64>,
}
