//! `result.json` of a measured gear, with units in the key names. Deviations in the transverse section, um; slopes with the sign and the
//! reference length that stand beside them.

use super::closed_loop::RoundResult;
use metrology::inspection::PitchEvaluation;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;
use verdict::{Remark, Verdict};

/// The whole document.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct GearInspectionResult {
    /// Name of the part, or of its file.
    pub job: String,
    /// Process.
    pub process: &'static str,
    /// Version of flankwright.
    pub version: &'static str,
    /// What was judged, by the job or by the class that was asked for; a measurement by itself is not judged.
    #[serde(flatten)]
    pub verdict: Verdict,
    /// The class of ISO 1328-1:2013 that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance_class: Option<i32>,
    /// Tolerance of the job.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance_um: Option<f64>,
    /// Files that were read.
    pub files: Vec<String>,
    /// Number of the part, its drawing, date and machine, as far as the files tell.
    pub head: BTreeMap<&'static str, String>,
    /// What the user stated about the measurement because the file does not tell it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub stated: Vec<String>,
    /// Doubts of reading and evaluation.
    pub warnings: Vec<Remark>,
    /// Lines that were not understood, by file.
    pub not_understood: Vec<LinesResult>,
    /// Section in which the file counts deviations.
    pub section: &'static str,
    /// Traces.
    pub traces: Vec<TraceInspectionResult>,
    /// Mean and range over the teeth: characteristic, flank, line.
    pub summary: Vec<SummaryResult>,
    /// Twist of tooth flanks that have two profiles or two helix traces.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub twist: Vec<TwistResult>,
    /// Features of each flank as a surface, where its lines cross; against a job the rounds have them.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub areal: BTreeMap<&'static str, ArealResult>,
    /// Pitches by flank.
    pub pitch: BTreeMap<&'static str, PitchInspectionResult>,
    /// R_s.
    #[serde(rename = "Rs_um", skip_serializing_if = "Option::is_none")]
    pub thickness_variation_um: Option<f64>,
    /// F_r from the pitches.
    #[serde(rename = "Fr_um", skip_serializing_if = "Option::is_none")]
    pub run_out_um: Option<f64>,
    /// e and its direction.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub eccentricity: Option<[f64; 2]>,
    /// F_p without the eccentricity, left and right.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pitch_without_eccentricity_um: Option<[f64; 2]>,
    /// Profile shift by span and balls.
    pub thickness: ThicknessResult,
    /// Classes of ISO 1328-1:2013 that the values reach.
    pub classes: Vec<ClassResult>,
    /// The class of the part; absent where a value is worse than class 11, or nothing was judged.
    pub class: Option<i32>,
    /// Whether something that would count for the class could not be evaluated.
    pub class_is_partial: bool,
    /// How many values the measuring machine printed.
    pub printed_values: usize,
    /// Those of them that have a counterpart here, beside what was evaluated here.
    pub printed: Vec<PrintedResult>,
    /// Largest difference of the two; 0 without printed values.
    pub printed_difference_um: f64,
    /// Rounds against a job: comparison, tests, correction, proof.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub rounds: Vec<RoundResult>,
    /// Seconds per stage; the only part that differs between two runs.
    pub timing_s: BTreeMap<&'static str, f64>,
}

impl GearInspectionResult {
    /// Largest deviation of the last measured flanks from the target, um; 0 without a job.
    pub fn largest_um(&self) -> f64 {
        let last = self.rounds.last().into_iter().flat_map(|round| round.flanks.values());
        last.map(|flank| flank.measured.largest_um).fold(0.0, f64::max)
    }
}

/// Lines of a file that were not understood.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LinesResult {
    /// File.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
    /// Its beginning.
    pub text: String,
}

/// A trace.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct TraceInspectionResult {
    /// profile or helix.
    pub kind: &'static str,
    /// Tooth as the machine counts.
    pub tooth: u32,
    /// Flank.
    pub flank: &'static str,
    /// Mark of the line.
    pub tag: String,
    /// z of a profile, length of roll of a helix.
    pub position_mm: f64,
    /// Evaluated from and to.
    pub range_mm: [f64; 2],
    /// Samples that count, and those in the range that were not measured.
    pub samples: [usize; 2],
    /// f_H as printed.
    #[serde(rename = "fH_um")]
    pub slope_um: f64,
    /// f_H of material rising along the trace.
    #[serde(rename = "fH_material_um")]
    pub slope_material_um: f64,
    /// Length that the slope refers to.
    pub slope_length_mm: f64,
    /// Sign of the printed slope in words.
    pub slope_sign: &'static str,
    /// F.
    #[serde(rename = "F_um")]
    pub total_um: f64,
    /// f_f.
    #[serde(rename = "ff_um")]
    pub form_um: f64,
    /// C: > 0 convex.
    #[serde(rename = "C_um")]
    pub crowning_um: f64,
    /// Relief at the tip, < 0 relieved.
    #[serde(rename = "fKo_um", skip_serializing_if = "Option::is_none")]
    pub tip_relief_um: Option<f64>,
    /// How it lies in the band of the job.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub band: Option<BandResult>,
}

/// How a trace lies in its band.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct BandResult {
    /// Whether it lies in it.
    pub passed: bool,
    /// Least distance from a limit; below 0 by so much beyond.
    pub margin_um: f64,
    /// What was added to the trace to lie so.
    pub shift_um: f64,
}

/// A characteristic over the teeth.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SummaryResult {
    /// profile or helix.
    pub kind: &'static str,
    /// Flank.
    pub flank: &'static str,
    /// Mark of the line.
    pub tag: String,
    /// fH, F, ff, C or fKo.
    pub characteristic: &'static str,
    /// Teeth.
    pub teeth: usize,
    /// Mean.
    pub mean_um: f64,
    /// Greatest less least; absent with one tooth.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub range_um: Option<f64>,
}

/// Twist S of a tooth flank, transverse, > 0 removes at the tip of the upper face.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct TwistResult {
    /// Flank.
    pub flank: &'static str,
    /// Tooth as the machine counts.
    pub tooth: u32,
    /// S_alpha: from the profile slopes at two heights.
    #[serde(rename = "S_by_profiles_um", skip_serializing_if = "Option::is_none")]
    pub by_profiles_um: Option<f64>,
    /// S_beta: from the helix slopes at two lengths of roll.
    #[serde(rename = "S_by_leads_um", skip_serializing_if = "Option::is_none")]
    pub by_leads_um: Option<f64>,
    /// Their difference: what is no bilinear twist.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub difference_um: Option<f64>,
}

/// Features of a flank: of the surface of second degree through what was measured, mean of the teeth, normal to the flank. The surface between
/// lines is reconstructed; `surface` says from what.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ArealResult {
    /// What the surface was made of.
    pub surface: String,
    /// Teeth that were measured so.
    pub teeth: usize,
    /// Lengths of roll and heights that the features refer to.
    pub field_mm: [[f64; 2]; 2],
    /// f_Ha, material rising to the tip.
    #[serde(rename = "fHa_um")]
    pub profile_slope_um: f64,
    /// f_Hb, material rising to +z.
    #[serde(rename = "fHb_um")]
    pub helix_slope_um: f64,
    /// C_alpha.
    #[serde(rename = "Ca_um")]
    pub profile_crowning_um: f64,
    /// C_beta.
    #[serde(rename = "Cb_um")]
    pub helix_crowning_um: f64,
    /// S; absent where the lines do not tell it.
    #[serde(rename = "S_um", skip_serializing_if = "Option::is_none")]
    pub twist_um: Option<f64>,
    /// What the surface of second degree leaves, root mean square.
    pub rest_rms_um: f64,
    /// What it leaves, largest minus smallest.
    pub form_um: f64,
    /// Share of the squares that it explains.
    pub explained_share: f64,
    /// How far profiles and helix traces disagree where they cross: root mean square and largest.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mismatch_um: Option<[f64; 2]>,
    /// How far the field goes beyond the outermost lines, as a share of it, where that is far.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub outside_traces: BTreeMap<&'static str, f64>,
}

/// Pitches of a flank.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PitchInspectionResult {
    /// f_p.
    #[serde(rename = "fp_um")]
    pub single_um: f64,
    /// f_u.
    #[serde(rename = "fu_um")]
    pub neighbours_um: f64,
    /// R_p.
    #[serde(rename = "Rp_um")]
    pub range_um: f64,
    /// F_p.
    #[serde(rename = "Fp_um")]
    pub total_um: f64,
    /// F_pk and its k.
    #[serde(rename = "Fpk_um")]
    pub sector_um: f64,
    /// k.
    pub sector_pitches: usize,
    /// F_p of every tooth against the last.
    pub cumulative_um: Vec<f64>,
}

impl PitchInspectionResult {
    /// Of an evaluation.
    pub(super) fn of(pitch: &PitchEvaluation) -> Self {
        Self {
            single_um: 1e3 * pitch.single,
            neighbours_um: 1e3 * pitch.neighbours,
            range_um: 1e3 * pitch.single_range,
            total_um: 1e3 * pitch.total,
            sector_um: 1e3 * pitch.sector,
            sector_pitches: pitch.sector_pitches,
            cumulative_um: pitch.cumulative.iter().map(|mm| 1e3 * mm).collect(),
        }
    }
}

/// Profile shift coefficients that the sizes mean.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ThicknessResult {
    /// By the span.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub x_from_span: Option<f64>,
    /// By the balls.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub x_from_balls: Option<f64>,
}

/// The class of a value.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ClassResult {
    /// Flank; absent where it is a value of the gear.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flank: Option<&'static str>,
    /// Symbol.
    pub quantity: &'static str,
    /// Value; slopes with their sign.
    pub value_um: f64,
    /// Class; absent if worse than 11.
    pub class: Option<i32>,
}

/// A class in words; without one the value is worse than the last.
pub fn class_in_words(class: Option<i32>) -> String {
    class.map_or_else(|| "worse than 11".to_owned(), |class| class.to_string())
}

/// A printed value.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PrintedResult {
    /// Which.
    pub name: String,
    /// As printed.
    pub printed_um: f64,
    /// As evaluated.
    pub evaluated_um: f64,
}
