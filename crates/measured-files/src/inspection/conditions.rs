//! How a gear was measured: ranges, places, section, signs, filters, reference lengths.

use serde::{Deserialize, Serialize};

use super::InspectionError;
use super::trace::TraceKind;
use foundation::geometry::{Flank, Sides};

/// The face from which drawings and files look at a gear.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum DatumFace {
    /// The upper one.
    #[default]
    #[serde(rename = "+z")]
    PlusZ,
    /// The lower one.
    #[serde(rename = "-z")]
    MinusZ,
}

impl DatumFace {
    /// Distance xi of a height z from the face, mm; `face_width` b mm.
    pub fn distance(self, z: f64, face_width: f64) -> f64 {
        match self {
            Self::PlusZ => 0.5 * face_width - z,
            Self::MinusZ => 0.5 * face_width + z,
        }
    }

    /// Height z of a distance xi from the face, mm.
    pub fn height(self, xi: f64, face_width: f64) -> f64 {
        match self {
            Self::PlusZ => 0.5 * face_width - xi,
            Self::MinusZ => xi - 0.5 * face_width,
        }
    }
}

/// The section in which deviations stand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Section {
    /// Transverse, along the base tangent.
    #[default]
    Transverse,
    /// Normal to the flank.
    Normal,
}

/// The sense in which teeth are numbered, seen from +z.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum CountingDirection {
    /// Against the sense of rotation about +z.
    Clockwise,
    /// In the sense of rotation about +z.
    CounterClockwise,
}

/// The length to which slopes refer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SlopeReference {
    /// The face width.
    FaceWidth,
    /// The evaluated range.
    Range,
}

/// Heights of the profiles, mm from the middle of the face width.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ProfilePositions {
    /// Lower one, tag `u`.
    pub bottom_mm: Option<f64>,
    /// Middle one.
    pub middle_mm: Option<f64>,
    /// Upper one, tag `o`.
    pub top_mm: Option<f64>,
}

/// Lengths of roll of the helix traces, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct LeadPositions {
    /// Towards the root, tag `f`.
    pub inner_mm: Option<f64>,
    /// Middle one.
    pub middle_mm: Option<f64>,
    /// Towards the tip, tag `k`.
    pub outer_mm: Option<f64>,
}

/// What was measured and is evaluated on one flank. Lengths in mm; what the file does not state is absent.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FlankConditions {
    /// Length of roll at which profiles begin.
    pub w_start_mm: Option<f64>,
    /// Length of roll at which their evaluation begins.
    pub w_1_mm: Option<f64>,
    /// Length of roll at which their evaluation ends.
    pub w_2_mm: Option<f64>,
    /// Length of roll at which profiles end.
    pub w_end_mm: Option<f64>,
    /// Tip relief: lengths of roll of its start and its far end.
    pub tip_relief_mm: Option<[f64; 2]>,
    /// Root relief: lengths of roll of its start and its far end.
    pub root_relief_mm: Option<[f64; 2]>,
    /// Height z at which helix traces begin.
    pub z_a_mm: Option<f64>,
    /// Height z at which their evaluation begins.
    pub z_1_mm: Option<f64>,
    /// Height z at which their evaluation ends.
    pub z_2_mm: Option<f64>,
    /// Height z at which helix traces end.
    pub z_b_mm: Option<f64>,
    /// Heights of the profiles.
    pub profiles: ProfilePositions,
    /// Lengths of roll of the helix traces.
    pub leads: LeadPositions,
    /// sigma_F: printed helix slope = sigma_F times the slope of the material towards +z; +1 or -1.
    pub printed_sign: Option<f64>,
}

/// How a gear was measured.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Conditions {
    /// What belongs to a flank.
    pub flanks: Sides<FlankConditions>,
    /// Section of the deviations.
    pub section: Section,
    /// Diameter of the stylus ball, mm.
    pub stylus_diameter_mm: Option<f64>,
    /// Filter of the helix traces, as the file calls it.
    pub helix_filter: Option<String>,
    /// Filter of the profiles, as the file calls it.
    pub profile_filter: Option<String>,
    /// Temperature of the gear, degree Celsius.
    pub temperature_c: Option<f64>,
    /// Whether it was taken from the other end and then turned: flanks and heights are those of the gear, teeth and positions of the probe
    /// are numbered as the machine saw them.
    #[serde(default)]
    pub turned: bool,
    /// The face that left and right are looked at from.
    pub datum_face: DatumFace,
    /// Length to which helix slopes refer.
    pub helix_slope_reference: Option<SlopeReference>,
    /// Length to which profile slopes refer.
    pub profile_slope_reference: Option<SlopeReference>,
}

impl Conditions {
    /// The evaluated range of a trace, mm: lengths of roll [w_1, w_2] of a profile (with tip relief up to its start), heights
    /// [z_1, z_2] of a helix.
    ///
    /// # Errors
    /// [`InspectionError::MissingCode`] with the code under which Klingelnberg files state the end that is absent.
    pub fn range(&self, kind: TraceKind, flank: Flank) -> Result<[f64; 2], InspectionError> {
        let of = &self.flanks[flank];
        let need =
            |value: Option<f64>, code, meaning| value.ok_or(InspectionError::MissingCode { code, meaning });
        match kind {
            TraceKind::Profile => {
                let lo = need(of.w_1_mm, 42, "start of the profile evaluation")?;
                let hi = of.tip_relief_mm.map(|[start, _]| start).or(of.w_2_mm);
                Ok([lo, need(hi, 43, "end of the profile evaluation")?])
            }
            TraceKind::Helix => Ok([
                need(of.z_1_mm, 62, "start of the helix evaluation")?,
                need(of.z_2_mm, 63, "end of the helix evaluation")?,
            ]),
        }
    }

    /// The length to which the slope of a trace refers, mm; `face_width` b mm.
    ///
    /// # Errors
    /// As [`Conditions::range`]; [`InspectionError::MissingCode`] where the file does not say which length it is, or the face width
    /// is needed and absent.
    pub fn reference_length(
        &self,
        kind: TraceKind,
        flank: Flank,
        face_width: Option<f64>,
    ) -> Result<f64, InspectionError> {
        let (stated, code, meaning) = match kind {
            TraceKind::Helix => (self.helix_slope_reference, 179, "reference length of the helix slope"),
            TraceKind::Profile => {
                (self.profile_slope_reference, 180, "reference length of the profile slope")
            }
        };
        match stated.ok_or(InspectionError::MissingCode { code, meaning })? {
            SlopeReference::FaceWidth => {
                face_width.ok_or(InspectionError::MissingCode { code: 26, meaning: "face width" })
            }
            SlopeReference::Range => self.range(kind, flank).map(|[lo, hi]| hi - lo),
        }
    }
}
