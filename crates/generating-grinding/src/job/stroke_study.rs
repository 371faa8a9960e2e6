//! `[explore.dressing.strokes]` and `[explore.dressing.deviations]`: dressing in several strokes, deviations of the axes.

use schemars::{JsonSchema, Schema, json_schema};
use serde::{Deserialize, Serialize};

/// Dressing of one profile in several strokes. Shares count from w_NfS (0) to w_NaS (1) of the used profile; f_n is the normal
/// modification of the worm, positive = material left.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StrokeStudy {
    /// Active areas of the dresser.
    #[schemars(length(min = 1, max = 12))]
    pub areas: Vec<DresserArea>,
    /// Modification at the start of the profile, um.
    #[serde(default)]
    #[schemars(schema_with = "modification")]
    pub start_um: f64,
    /// Sections of the worm's profile from its start to its end; each is a parabola.
    #[schemars(length(min = 1, max = 12))]
    pub sections: Vec<StrokeSection>,
    /// Overlap of neighbouring strokes, mm.
    #[serde(default = "overlap")]
    #[schemars(extend("minimum" = 0, "maximum" = 10, "x-way-out" = "give some hundredths of a mm"))]
    pub overlap: f64,
}

pub(super) fn overlap() -> f64 {
    0.05
}

/// A part of the dresser's profile that touches the worm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DresserArea {
    /// Share of the profile at its start.
    #[schemars(schema_with = "share")]
    pub from: f64,
    /// Share of the profile at its end.
    #[schemars(schema_with = "share")]
    pub to: f64,
}

/// A section of the worm's profile, which begins where the one before it ends.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StrokeSection {
    /// Share of the profile at its end; the last section ends at 1.
    #[schemars(schema_with = "share")]
    pub to: f64,
    /// Modification in its middle, um.
    #[schemars(schema_with = "modification")]
    pub middle_um: f64,
    /// Modification at its end, um.
    #[schemars(schema_with = "modification")]
    pub end_um: f64,
    /// Number of the active area that dresses it, from 1.
    #[serde(default = "first")]
    #[schemars(extend("minimum" = 1, "maximum" = 12, "x-way-out" = "give the number of an entry of `areas`"))]
    pub area: usize,
}

pub(super) fn first() -> usize {
    1
}

/// Deviations of the dressing axes: each by itself, all at once, and drawn at random.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AxisDeviations {
    /// Worm angle, degrees; of the random deviations the standard deviation or half width, as of the other axes.
    #[serde(default, rename = "d_phi_S_deg")]
    #[schemars(schema_with = "angle")]
    pub d_phi_s_deg: f64,
    /// Crossing angle, degrees.
    #[serde(default)]
    #[schemars(schema_with = "angle")]
    pub d_gamma_deg: f64,
    /// Centre distance, mm.
    #[serde(default)]
    #[schemars(schema_with = "length")]
    pub d_d_mm: f64,
    /// Offset of the dresser, mm.
    #[serde(default, rename = "d_v_yA_mm")]
    #[schemars(schema_with = "length")]
    pub d_v_ya_mm: f64,
    /// Distribution of the random deviations.
    #[serde(default)]
    pub distribution: Distribution,
    /// Number of draws.
    #[serde(default = "samples")]
    #[schemars(extend("minimum" = 1, "maximum" = 1_000_000, "x-way-out" = "give some thousands"))]
    pub samples: usize,
    /// Seed of the draws: the same gives the same result.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 9_007_199_254_740_991_u64, "x-way-out" = "give a whole number"))]
    pub seed: u64,
}

fn samples() -> usize {
    1000
}

impl AxisDeviations {
    /// rad, rad, mm, mm.
    pub fn values(&self) -> [f64; 4] {
        [self.d_phi_s_deg.to_radians(), self.d_gamma_deg.to_radians(), self.d_d_mm, self.d_v_ya_mm]
    }
}

/// Distribution of random deviations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Distribution {
    /// Normal; the deviations are standard deviations.
    #[default]
    Normal,
    /// Even; the deviations are half widths.
    Uniform,
}

impl Distribution {
    /// The word in job files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Normal => "normal",
            Self::Uniform => "uniform",
        }
    }
}

pub(super) fn share(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({
        "type": "number", "minimum": -0.5, "maximum": 1.5,
        "x-way-out": "give a share of the used profile, 0 at w_NfS and 1 at w_NaS"
    })
}

fn modification(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({
        "type": "number", "minimum": -1000, "maximum": 1000,
        "x-way-out": "give the modification of the worm in um, positive = material left"
    })
}

fn angle(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({ "type": "number", "minimum": 0, "maximum": 5, "x-way-out": "give a deviation in degrees, e.g. 0.01" })
}

fn length(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({ "type": "number", "minimum": 0, "maximum": 10, "x-way-out": "give a deviation in mm, e.g. 0.01" })
}
