//! `[dressing.strokes]`: dressing in several strokes, each by an active area of one of the dressers.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::over_width::{OverWidth, share as share_over_face};
use super::stroke_study::{first, overlap, share};

/// Dressing of the worm's profile in several strokes, each with its own corrections. Shares count from w_NfS (0), which grinds the
/// tip of the gear, to w_NaS (1), which grinds its root form circle, evenly in the length of roll.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Strokes {
    /// Active areas of the dressers.
    #[schemars(length(min = 1, max = 24))]
    pub areas: Vec<StrokeArea>,
    /// Sections of the worm's profile from its start to its end.
    #[schemars(length(min = 1, max = 24))]
    pub sections: Vec<DressedSection>,
    /// Overlap of neighbouring strokes, mm.
    #[serde(default = "overlap")]
    #[schemars(extend("minimum" = 0, "maximum" = 10, "x-way-out" = "give some hundredths of a mm"))]
    pub overlap: f64,
}

/// A part of a dresser's profile that touches the worm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StrokeArea {
    /// Share of the profile at its start.
    #[schemars(schema_with = "share")]
    pub from: f64,
    /// Share of the profile at its end.
    #[schemars(schema_with = "share")]
    pub to: f64,
    /// Number of the dresser: 1 is `[dresser]`, from 2 on the entries of `dresser.others`.
    #[serde(default = "first")]
    #[schemars(extend("minimum" = 1, "maximum" = 13, "x-way-out" = "give 1 for `[dresser]`, from 2 on the entries of `dresser.others`"))]
    pub dresser: usize,
}

/// A section of the worm's profile, which begins where the one before it ends.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DressedSection {
    /// Share of the profile at its end, the same all over the face or coefficients of q^k, q from -1 to 1 over the evaluated face; the
    /// last section ends at 1.
    #[schemars(schema_with = "share_over_face")]
    pub to: OverWidth,
    /// Number of the active area that dresses it, from 1, in as many strokes as it takes.
    #[serde(default = "first")]
    #[schemars(extend("minimum" = 1, "maximum" = 24, "x-way-out" = "give the number of an entry of `areas`"))]
    pub area: usize,
}
