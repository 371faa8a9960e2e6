//! `[settings]`: what the axes do and what profile the dresser has. `plan` writes it, `simulate` runs it.

use foundation::geometry::Flank;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use job::tables::Modification;

/// Settings of grinding and dressing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Settings {
    /// Diagonal ratio K of z_V1 = K z_V2 + z_V01; 0 = no shift.
    #[schemars(extend("minimum" = -1000, "maximum" = 1000, "x-way-out" = "give a ratio of a few units"))]
    pub diagonal_ratio: f64,
    /// z_V01, mm: tool shift at z_V2 = 0.
    #[serde(default)]
    #[schemars(extend("minimum" = -5000, "maximum" = 5000, "x-way-out" = "give the tool shift at mid stroke in mm"))]
    pub shift_origin_mm: f64,
    /// Coefficients of Delta_d over z_V2, um/mm^k, k = 0, 1, ...
    #[serde(default)]
    #[schemars(extend("maxItems" = 20))]
    pub delta_d_um: Vec<f64>,
    /// Coefficients of Delta_phi_2 over z_V2, urad/mm^k, k = 0, 1, ...
    #[serde(default)]
    #[schemars(extend("maxItems" = 20))]
    pub delta_phi_2_urad: Vec<f64>,
    /// z_V1 over z_V2 in place of ratio and origin, for a ratio that changes over the feed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shift: Option<Pieces>,
    /// Delta_d over z_V2, um and um/mm^k, in place of `delta_d_um`, where it is no polynomial.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub delta_d_pieces: Option<Pieces>,
    /// Delta_phi_2 over z_V2, urad and urad/mm^k, in place of `delta_phi_2_urad`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub delta_phi_2_pieces: Option<Pieces>,
    /// Flanks of a tool that is not dressed; absent: unmodified, or as `[worm] modifications` says.
    #[serde(default, skip_serializing_if = "ToolTables::is_empty")]
    pub tool: ToolTables,
    /// Strokes in which the worm flanks are dressed, with `[dressing.strokes]`, in place of `left` and `right`.
    #[serde(default, skip_serializing_if = "StrokeTables::is_empty")]
    pub strokes: StrokeTables,
    /// Dressing of the left worm flank; absent: nominal.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub left: Option<FlankSettings>,
    /// Dressing of the right worm flank; absent: nominal.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub right: Option<FlankSettings>,
}

/// A law or a profile in pieces of third degree.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Pieces {
    /// Ends of the pieces over z_V2, for a profile over w, mm, ascending: one more than pieces. Beyond both ends it goes on straight.
    #[schemars(extend("minItems" = 2, "maxItems" = 100_001))]
    pub breaks_mm: Vec<f64>,
    /// Per piece the coefficients of (z_V2 - first end)^k, or of w, k = 0..3, in the unit of the key per mm^k.
    #[schemars(extend("minItems" = 1, "maxItems" = 100_000))]
    pub coefficients: Vec<[f64; 4]>,
}

/// Modifications of the flanks of a tool that is not dressed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToolTables {
    /// Left flank.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub left: Option<ToolTable>,
    /// Right flank.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub right: Option<ToolTable>,
}

impl ToolTables {
    fn is_empty(&self) -> bool {
        self.left.is_none() && self.right.is_none()
    }
}

impl Settings {
    /// What is set on one flank.
    pub fn flank(&self, flank: Flank) -> Option<&FlankSettings> {
        match flank {
            Flank::Left => self.left.as_ref(),
            Flank::Right => self.right.as_ref(),
        }
    }
}

/// Modification of a tool's flank, normal, positive = material left, as a table; a cubic spline goes through it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToolTable {
    /// Lengths of roll w_1, ascending.
    #[schemars(extend("minItems" = 4, "maxItems" = 10_000))]
    pub w_mm: Vec<f64>,
    /// Positions z_1 on the tool, ascending.
    #[schemars(extend("minItems" = 4, "maxItems" = 10_000))]
    pub z_mm: Vec<f64>,
    /// f_n1 by [w][z].
    pub f_um: Vec<Vec<f64>>,
}

/// The strokes of both worm flanks.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StrokeTables {
    /// Strokes of the left flank.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(max = 1000))]
    pub left: Vec<StrokeSettings>,
    /// Strokes of the right flank.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(max = 1000))]
    pub right: Vec<StrokeSettings>,
}

impl StrokeTables {
    /// Whether neither flank has strokes.
    pub fn is_empty(&self) -> bool {
        self.left.is_empty() && self.right.is_empty()
    }
}

/// One stroke: what of which dresser touches which part of the worm's profile, and its corrections DK(v) as Chebyshev series of the
/// worm position v_zS.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StrokeSettings {
    /// Number of the dresser: 1 is `[dresser]`, from 2 on the entries of `dresser.others`.
    #[schemars(extend("minimum" = 1, "maximum" = 13, "x-way-out" = "give 1 for `[dresser]`, from 2 on the entries of `dresser.others`"))]
    pub dresser: usize,
    /// Start and end of the active area by the parameter of the dresser's profile, the length of roll that it was designed for, mm.
    pub area_mm: [f64; 2],
    /// All that touches the worm: the area and what it overlaps with its neighbours by, mm.
    pub touching_mm: [f64; 2],
    /// Lengths of roll of the worm on which the area is laid, mm.
    pub range_mm: [f64; 2],
    /// First worm position v_zS of the series, mm.
    #[schemars(extend("minimum" = -5000, "maximum" = 5000, "x-way-out" = "give the start of the dressing stroke in mm"))]
    pub v_from_mm: f64,
    /// Last worm position v_zS of the series, mm.
    #[schemars(extend("minimum" = -5000, "maximum" = 5000, "x-way-out" = "give the end of the dressing stroke in mm"))]
    pub v_to_mm: f64,
    /// Chebyshev coefficients of d_phi_S, deg.
    #[serde(default, rename = "d_phi_S_deg")]
    #[schemars(extend("maxItems" = 1000))]
    pub d_phi_s_deg: Vec<f64>,
    /// Chebyshev coefficients of d_gamma, deg.
    #[serde(default)]
    #[schemars(extend("maxItems" = 1000))]
    pub d_gamma_deg: Vec<f64>,
    /// Chebyshev coefficients of d_d, mm.
    #[serde(default)]
    #[schemars(extend("maxItems" = 1000))]
    pub d_d_mm: Vec<f64>,
    /// Chebyshev coefficients of d_v_yA, mm.
    #[serde(default, rename = "d_v_yA_mm")]
    #[schemars(extend("maxItems" = 1000))]
    pub d_v_ya_mm: Vec<f64>,
}

/// Dressing of one worm flank: corrections DK(v) as Chebyshev series of the worm position v_zS, and the dresser's profile.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FlankSettings {
    /// First worm position v_zS of the series, mm.
    #[schemars(extend("minimum" = -5000, "maximum" = 5000, "x-way-out" = "give the start of the dressing stroke in mm"))]
    pub v_from_mm: f64,
    /// Last worm position v_zS of the series, mm.
    #[schemars(extend("minimum" = -5000, "maximum" = 5000, "x-way-out" = "give the end of the dressing stroke in mm"))]
    pub v_to_mm: f64,
    /// Chebyshev coefficients of d_phi_S, deg.
    #[serde(default, rename = "d_phi_S_deg")]
    #[schemars(extend("maxItems" = 1000))]
    pub d_phi_s_deg: Vec<f64>,
    /// Chebyshev coefficients of d_gamma, deg.
    #[serde(default)]
    #[schemars(extend("maxItems" = 1000))]
    pub d_gamma_deg: Vec<f64>,
    /// Chebyshev coefficients of d_d, mm.
    #[serde(default)]
    #[schemars(extend("maxItems" = 1000))]
    pub d_d_mm: Vec<f64>,
    /// Chebyshev coefficients of d_v_yA, mm.
    #[serde(default, rename = "d_v_yA_mm")]
    #[schemars(extend("maxItems" = 1000))]
    pub d_v_ya_mm: Vec<f64>,
    /// Profile that the dresser leaves on the gear: coefficients of (w - w_m)^k, um/mm^k, transverse, > 0 material left.
    #[serde(default)]
    #[schemars(extend("maxItems" = 50))]
    pub profile_um: Vec<f64>,
    /// A further part of that profile over the length of roll w, um and um/mm^k: what a best fit found.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub profile_pieces: Option<Pieces>,
    /// Reliefs and other profile forms that the dresser carries beside it: modifications of the profile, as in the target.
    #[serde(default)]
    pub reliefs: Vec<Modification>,
}
