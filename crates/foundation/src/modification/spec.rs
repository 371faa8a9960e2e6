//! What a job file says about modifications: one table per entry, tagged by `kind`, with the keys of `docs/mathematics/modifications.md`.
//! Only spelling and types are checked here; the numbers are checked by `Modification::build`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::geometry::Flank;

/// One modification as a file describes it. Amounts in um, transverse, positive = material removed unless the kind
/// says otherwise; lengths in mm. Unknown keys are refused inside every kind.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum ModificationSpec {
    /// Parabolic crowning over the length of roll.
    ProfileCrowning(AmountSpec),
    /// Circular crowning over the length of roll.
    ProfileCrowningArc(AmountSpec),
    /// Parabolic crowning over the radius.
    ProfileCrowningRadius(AmountSpec),
    /// Profile slope, linear over the radius, zero at the middle radius.
    ProfileSlopeRadius(AmountSpec),
    /// Parabolic crowning over the face width.
    HelixCrowning(AmountSpec),
    /// Circular crowning over the face width.
    HelixCrowningArc(AmountSpec),
    /// Two parabolas over the face width that meet at an apex.
    HelixCrowningTwoArc(HelixTwoArcSpec),
    /// Two parabolas over the length of roll that meet at an apex.
    ProfileCrowningTwoArc(ProfileTwoArcSpec),
    /// Profile slope over the length of roll, zero at the root; positive removes at the tip.
    ProfileSlope(AmountSpec),
    /// Helix slope, zero at face I; positive removes at face II, the datum face.
    HelixSlope(AmountSpec),
    /// Bilinear twist (bias).
    Twist(AmountSpec),
    /// Relief towards the tip.
    TipRelief(ReliefSpec),
    /// Relief towards the root.
    RootRelief(ReliefSpec),
    /// Relief towards face I (lower z), the face opposite the datum face.
    #[serde(rename = "end_relief_I")]
    EndReliefI(ReliefSpec),
    /// Relief towards face II (upper z), the datum face.
    #[serde(rename = "end_relief_II")]
    EndReliefII(ReliefSpec),
    /// Relief towards the datum face (upper z, face II).
    EndReliefDatumFace(ReliefSpec),
    /// Relief towards the face opposite the datum face (lower z, face I).
    EndReliefNonDatumFace(ReliefSpec),
    /// Relief of one corner of the flank.
    TriangularEndRelief(TriangularSpec),
    /// Parabolic crowning across an oblique direction.
    DirectedCrowning(DirectedSpec),
    /// Sine along one direction; amplitudes positive or negative, f_t = + sine.
    Waviness(WavinessSpec),
    /// Polynomial, positive = material left.
    Polynomial(PolynomialSpec),
    /// Table, interpolated by a cubic spline, positive = material left.
    Grid(GridSpec),
    /// Scattered points, positive = material left.
    Points(PointsSpec),
    /// Helix traces at two or three lengths of roll, positive = material left.
    HelixTraces(HelixTracesSpec),
    /// A profile as measured: a smooth curve fitted to points with noise, the same over the face width.
    ProfileTrace(ProfileTraceSpec),
    /// Formula in the coordinates of the field, positive = material left.
    Formula(FormulaSpec),
    /// Sum of the children.
    Sum(CompositeSpec),
    /// Product of the children's f_t in mm, point by point.
    Product(CompositeSpec),
    /// A factor times the (sum of the) children.
    Scale(ScaleSpec),
    /// The (sum of the) children at the mirrored point: f(w, -z).
    Mirror(MirrorSpec),
}

impl ModificationSpec {
    /// The name of the kind as files spell it.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::ProfileCrowning(_) => "profile_crowning",
            Self::ProfileCrowningArc(_) => "profile_crowning_arc",
            Self::ProfileCrowningRadius(_) => "profile_crowning_radius",
            Self::ProfileSlopeRadius(_) => "profile_slope_radius",
            Self::HelixCrowning(_) => "helix_crowning",
            Self::HelixCrowningArc(_) => "helix_crowning_arc",
            Self::HelixCrowningTwoArc(_) => "helix_crowning_two_arc",
            Self::ProfileCrowningTwoArc(_) => "profile_crowning_two_arc",
            Self::ProfileSlope(_) => "profile_slope",
            Self::HelixSlope(_) => "helix_slope",
            Self::Twist(_) => "twist",
            Self::TipRelief(_) => "tip_relief",
            Self::RootRelief(_) => "root_relief",
            Self::EndReliefI(_) => "end_relief_I",
            Self::EndReliefII(_) => "end_relief_II",
            Self::EndReliefDatumFace(_) => "end_relief_datum_face",
            Self::EndReliefNonDatumFace(_) => "end_relief_non_datum_face",
            Self::TriangularEndRelief(_) => "triangular_end_relief",
            Self::DirectedCrowning(_) => "directed_crowning",
            Self::Waviness(_) => "waviness",
            Self::Polynomial(_) => "polynomial",
            Self::Grid(_) => "grid",
            Self::Points(_) => "points",
            Self::HelixTraces(_) => "helix_traces",
            Self::ProfileTrace(_) => "profile_trace",
            Self::Formula(_) => "formula",
            Self::Sum(_) => "sum",
            Self::Product(_) => "product",
            Self::Scale(_) => "scale",
            Self::Mirror(_) => "mirror",
        }
    }

    /// The flanks to which it applies.
    pub fn flank(&self) -> FlankChoice {
        self.common().0
    }

    /// The direction in which its amounts are measured.
    pub fn reference(&self) -> Reference {
        self.common().1
    }

    fn common(&self) -> (FlankChoice, Reference) {
        match self {
            Self::ProfileCrowning(s)
            | Self::ProfileCrowningArc(s)
            | Self::ProfileCrowningRadius(s)
            | Self::ProfileSlopeRadius(s)
            | Self::HelixCrowning(s)
            | Self::HelixCrowningArc(s)
            | Self::ProfileSlope(s)
            | Self::HelixSlope(s)
            | Self::Twist(s) => (s.flank, s.reference),
            Self::HelixCrowningTwoArc(s) => (s.flank, s.reference),
            Self::ProfileCrowningTwoArc(s) => (s.flank, s.reference),
            Self::TipRelief(s)
            | Self::RootRelief(s)
            | Self::EndReliefI(s)
            | Self::EndReliefII(s)
            | Self::EndReliefDatumFace(s)
            | Self::EndReliefNonDatumFace(s) => (s.flank, s.reference),
            Self::TriangularEndRelief(s) => (s.flank, s.reference),
            Self::DirectedCrowning(s) => (s.flank, s.reference),
            Self::Waviness(s) => (s.flank, s.reference),
            Self::Polynomial(s) => (s.flank, s.reference),
            Self::Grid(s) => (s.flank, s.reference),
            Self::Points(s) => (s.flank, s.reference),
            Self::HelixTraces(s) => (s.flank, s.reference),
            Self::ProfileTrace(s) => (s.flank, s.reference),
            Self::Formula(s) => (s.flank, s.reference),
            Self::Sum(s) | Self::Product(s) => (s.flank, s.reference),
            Self::Scale(s) => (s.flank, s.reference),
            Self::Mirror(s) => (s.flank, s.reference),
        }
    }
}

/// The flanks to which a modification applies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum FlankChoice {
    /// The left flank only.
    Left,
    /// The right flank only.
    Right,
    /// Both flanks.
    #[default]
    Both,
}

impl From<Flank> for FlankChoice {
    fn from(flank: Flank) -> Self {
        match flank {
            Flank::Left => Self::Left,
            Flank::Right => Self::Right,
        }
    }
}

impl FlankChoice {
    /// Whether `flank` is meant.
    pub fn includes(self, flank: Flank) -> bool {
        match self {
            Self::Left => flank == Flank::Left,
            Self::Right => flank == Flank::Right,
            Self::Both => true,
        }
    }

    fn is_default(&self) -> bool {
        *self == Self::default()
    }
}

/// The direction in which amounts are measured: f_n = f_t cos(beta_b).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Reference {
    /// Along the base tangent in the transverse plane (ISO 21771).
    #[default]
    Transverse,
    /// Normal to the flank: every `amount_*` is divided by cos(beta_b).
    Normal,
}

impl Reference {
    fn is_default(&self) -> bool {
        *self == Self::default()
    }
}

/// A modification with one amount.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AmountSpec {
    /// Amount, um.
    pub amount_um: f64,
    /// The flanks to which it applies.
    #[serde(default, skip_serializing_if = "FlankChoice::is_default")]
    pub flank: FlankChoice,
    /// The direction in which amounts are measured.
    #[serde(default, skip_serializing_if = "Reference::is_default")]
    pub reference: Reference,
}

/// Two parabolas over the face width.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HelixTwoArcSpec {
    /// Apex, mm, inside the field.
    pub apex_z_mm: f64,
    /// Amount at face I (lower z), the face opposite the datum face, um; another name of `amount_non_datum_face_um`.
    #[serde(default, rename = "amount_I_um", skip_serializing_if = "Option::is_none")]
    pub amount_1_um: Option<f64>,
    /// Amount at face II (upper z), the datum face, um; another name of `amount_datum_face_um`.
    #[serde(default, rename = "amount_II_um", skip_serializing_if = "Option::is_none")]
    pub amount_2_um: Option<f64>,
    /// Amount at the datum face (upper z, face II), um.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub amount_datum_face_um: Option<f64>,
    /// Amount at the face opposite the datum face (lower z, face I), um.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub amount_non_datum_face_um: Option<f64>,
    /// The flanks to which it applies.
    #[serde(default, skip_serializing_if = "FlankChoice::is_default")]
    pub flank: FlankChoice,
    /// The direction in which amounts are measured.
    #[serde(default, skip_serializing_if = "Reference::is_default")]
    pub reference: Reference,
}

/// Two parabolas over the length of roll.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ProfileTwoArcSpec {
    /// Apex, mm length of roll, inside the field.
    pub apex_w_mm: f64,
    /// Amount at the root, um.
    #[serde(rename = "amount_I_um")]
    pub amount_1_um: f64,
    /// Amount at the tip, um.
    #[serde(rename = "amount_II_um")]
    pub amount_2_um: f64,
    /// The flanks to which it applies.
    #[serde(default, skip_serializing_if = "FlankChoice::is_default")]
    pub flank: FlankChoice,
    /// The direction in which amounts are measured.
    #[serde(default, skip_serializing_if = "Reference::is_default")]
    pub reference: Reference,
}

/// A relief towards one border of the flank.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ReliefSpec {
    /// Amount at the border of the field, um.
    pub amount_um: f64,
    /// Length over which it grows, mm (length of roll for tip and root).
    pub length_mm: f64,
    /// Exponent of the law: 1 = straight, 2 = parabola; at least 1.
    #[serde(default = "one")]
    pub exponent: f64,
    /// Half length over which a straight relief starts rounded, mm.
    #[serde(default)]
    pub transition_mm: f64,
    /// The flanks to which it applies.
    #[serde(default, skip_serializing_if = "FlankChoice::is_default")]
    pub flank: FlankChoice,
    /// The direction in which amounts are measured.
    #[serde(default, skip_serializing_if = "Reference::is_default")]
    pub reference: Reference,
}

/// A relief of one corner.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TriangularSpec {
    /// Amount at the corner, um.
    pub amount_um: f64,
    /// Profile end of the corner.
    pub corner_profile: CornerProfile,
    /// Face of the corner.
    pub corner_face: CornerFace,
    /// Extent along the length of roll, mm.
    pub length_w_mm: f64,
    /// Extent along the face width, mm.
    pub length_z_mm: f64,
    /// Exponent of the law: 1 = straight, 2 = parabola; at least 1.
    #[serde(default = "one")]
    pub exponent: f64,
    /// Half length of the rounded start of a straight relief, as a share of the extent.
    #[serde(default)]
    pub transition: f64,
    /// The flanks to which it applies.
    #[serde(default, skip_serializing_if = "FlankChoice::is_default")]
    pub flank: FlankChoice,
    /// The direction in which amounts are measured.
    #[serde(default, skip_serializing_if = "Reference::is_default")]
    pub reference: Reference,
}

/// Crowning across an oblique direction.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DirectedSpec {
    /// Amount at the farthest corners, um.
    pub amount_um: f64,
    /// Direction, degree: the crowning varies along w sin rho + z cos rho.
    pub rho_deg: f64,
    /// The flanks to which it applies.
    #[serde(default, skip_serializing_if = "FlankChoice::is_default")]
    pub flank: FlankChoice,
    /// The direction in which amounts are measured.
    #[serde(default, skip_serializing_if = "Reference::is_default")]
    pub reference: Reference,
}

/// Sine with varying amplitude.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WavinessSpec {
    /// Direction of the wave, degree: X = w sin rho + z cos rho.
    pub rho_deg: f64,
    /// Wavelength along X, mm.
    pub wavelength_mm: f64,
    /// Phase at X = 0, degree.
    #[serde(default)]
    pub phase_deg: f64,
    /// Amplitude in the middle of the field, um.
    pub amp_0_um: f64,
    /// Growth of the amplitude to tip and root, um.
    #[serde(default)]
    pub amp_uu_um: f64,
    /// Growth of the amplitude to the faces, um.
    #[serde(default)]
    pub amp_vv_um: f64,
    /// The flanks to which it applies.
    #[serde(default, skip_serializing_if = "FlankChoice::is_default")]
    pub flank: FlankChoice,
    /// Always transverse: this kind has no `amount_*` to be divided.
    #[serde(default, skip_serializing_if = "Reference::is_default")]
    pub reference: Reference,
}

/// sum a_ij (w-w_0)^i (z-z_0)^j.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PolynomialSpec {
    /// Origin w_0, mm.
    #[serde(default)]
    pub w0_mm: f64,
    /// Origin z_0, mm.
    #[serde(default)]
    pub z0_mm: f64,
    /// Terms [i, j, a_ij], a_ij in um/mm^(i+j).
    pub terms: Vec<(u32, u32, f64)>,
    /// The flanks to which it applies.
    #[serde(default, skip_serializing_if = "FlankChoice::is_default")]
    pub flank: FlankChoice,
    /// Always transverse: this kind has no `amount_*` to be divided.
    #[serde(default, skip_serializing_if = "Reference::is_default")]
    pub reference: Reference,
}

/// A table, given here or in a file.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GridSpec {
    /// Lengths of roll, ascending, at least 4, mm.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub w_mm: Vec<f64>,
    /// Face positions, ascending, at least 4, mm.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub z_mm: Vec<f64>,
    /// Values `[w][z]`, um.
    #[serde(default, skip_serializing_if = "Vec::is_empty", alias = "f_t_um")]
    pub f_um: Vec<Vec<f64>>,
    /// A file that holds the table, instead of the three lists.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// The flanks to which it applies.
    #[serde(default, skip_serializing_if = "FlankChoice::is_default")]
    pub flank: FlankChoice,
    /// Always transverse: this kind has no `amount_*` to be divided.
    #[serde(default, skip_serializing_if = "Reference::is_default")]
    pub reference: Reference,
}

/// Scattered points, given here or in a file.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointsSpec {
    /// Points [w mm, z mm, f um], at least 3, not on one line.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub points: Vec<[f64; 3]>,
    /// A file that holds the points, instead of the list.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// How the space between the points is filled.
    #[serde(default)]
    pub method: PointMethod,
    /// The flanks to which it applies.
    #[serde(default, skip_serializing_if = "FlankChoice::is_default")]
    pub flank: FlankChoice,
    /// Always transverse: this kind has no `amount_*` to be divided.
    #[serde(default, skip_serializing_if = "Reference::is_default")]
    pub reference: Reference,
}

/// Helix traces, given here or in a file: a cubic spline over z along each, between them straight (two traces) or
/// parabolic (three) over w.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HelixTracesSpec {
    /// Lengths of roll of the traces, ascending, 2 or 3, mm.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub w_mm: Vec<f64>,
    /// Face positions, ascending, at least 4, mm.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub z_mm: Vec<f64>,
    /// Values `[w][z]`, um.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub f_um: Vec<Vec<f64>>,
    /// A file that holds the traces, instead of the three lists.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// The flanks to which it applies.
    #[serde(default, skip_serializing_if = "FlankChoice::is_default")]
    pub flank: FlankChoice,
    /// Always transverse: this kind has no `amount_*` to be divided.
    #[serde(default, skip_serializing_if = "Reference::is_default")]
    pub reference: Reference,
}

/// Points of a measured profile, given here or in a file.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ProfileTraceSpec {
    /// Points [w mm, f um] that cover the evaluation range, at least 8.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub points: Vec<[f64; 2]>,
    /// A CSV file with the columns w_mm and f_um, instead of the list.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// Standard deviation of a point, um; without it the scatter about the curve tells it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub noise_um: Option<f64>,
    /// The flanks to which it applies.
    #[serde(default, skip_serializing_if = "FlankChoice::is_default")]
    pub flank: FlankChoice,
    /// Always transverse: this kind has no `amount_*` to be divided.
    #[serde(default, skip_serializing_if = "Reference::is_default")]
    pub reference: Reference,
}

/// A formula.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FormulaSpec {
    /// f in um, of w, z (mm), u, v (from -1 to 1 over the field), w_f, w_a, z_I, z_II (its borders, mm), pi; with + - * / ^,
    /// parentheses, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, ln, log10, sqrt, abs, min, max.
    pub f_um: String,
    /// The flanks to which it applies.
    #[serde(default, skip_serializing_if = "FlankChoice::is_default")]
    pub flank: FlankChoice,
    /// Always transverse: this kind has no `amount_*` to be divided.
    #[serde(default, skip_serializing_if = "Reference::is_default")]
    pub reference: Reference,
}

/// Several modifications taken together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompositeSpec {
    /// The parts, at least one.
    pub children: Vec<ModificationSpec>,
    /// The flanks to which it applies.
    #[serde(default, skip_serializing_if = "FlankChoice::is_default")]
    pub flank: FlankChoice,
    /// Always transverse: this kind has no `amount_*` to be divided.
    #[serde(default, skip_serializing_if = "Reference::is_default")]
    pub reference: Reference,
}

/// A multiple.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ScaleSpec {
    /// What is multiplied; several are added first.
    pub children: Vec<ModificationSpec>,
    /// The factor.
    pub factor: f64,
    /// The flanks to which it applies.
    #[serde(default, skip_serializing_if = "FlankChoice::is_default")]
    pub flank: FlankChoice,
    /// Always transverse: this kind has no `amount_*` to be divided.
    #[serde(default, skip_serializing_if = "Reference::is_default")]
    pub reference: Reference,
}

/// A mirror image.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MirrorSpec {
    /// What is mirrored; several are added first.
    pub children: Vec<ModificationSpec>,
    /// The coordinate that changes its sign.
    #[serde(default)]
    pub axis: Axis,
    /// The flanks to which it applies.
    #[serde(default, skip_serializing_if = "FlankChoice::is_default")]
    pub flank: FlankChoice,
    /// Always transverse: this kind has no `amount_*` to be divided.
    #[serde(default, skip_serializing_if = "Reference::is_default")]
    pub reference: Reference,
}

/// Profile end of a corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum CornerProfile {
    /// Tip (end of the active profile).
    #[serde(rename = "tip")]
    Tip,
    /// Root (start of the active profile).
    #[serde(rename = "root")]
    Root,
}

/// Face of a corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum CornerFace {
    /// Face I (lower z), the face opposite the datum face.
    #[serde(rename = "I")]
    I,
    /// Face II (upper z), the datum face.
    #[serde(rename = "II")]
    II,
    /// The datum face (upper z, face II).
    #[serde(rename = "datum_face")]
    DatumFace,
    /// The face opposite the datum face (lower z, face I).
    #[serde(rename = "non_datum_face")]
    NonDatumFace,
}

/// How the space between scattered points is filled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum PointMethod {
    /// Barycentric on the Delaunay triangulation.
    #[default]
    #[serde(rename = "linear")]
    Linear,
    /// Least-squares tensor B-spline, C2, over at most 12 x 12 equal cells: as many as leave about four points for
    /// each coefficient, fewer where the cloud has holes. Needs 16 points.
    #[serde(rename = "spline")]
    Spline,
}

/// The coordinate that a mirror reverses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum Axis {
    /// Along the face width.
    #[default]
    #[serde(rename = "z")]
    Z,
}

fn one() -> f64 {
    1.0
}
