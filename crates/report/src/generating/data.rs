//! The figures of a generating-grinding plan, as the report takes them. Plain numbers with their units in the names.

use serde::Serialize;

use crate::charts::{DressingSectionChart, SectionTrace, Topography, WormOccupationChart};
use crate::control::ControlReport;
use crate::data::{Quantity, Stamp, Warning};
use crate::programs::ProgramsReport;
use foundation::geometry::Sides;
use verdict::Verdict;

/// Everything that the report of a generating-grinding job can show.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct GeneratingReport {
    /// Name of the job.
    pub job_name: String,
    /// Its description, if any.
    pub description: Option<String>,
    /// Process in words, for example "diagonal generating grinding".
    pub process: String,
    /// Version of the program.
    pub version: String,
    /// How the job ended.
    pub status: Stamp,
    /// What was judged and what was not.
    pub verdict: Verdict,
    /// Why the job ended so, where the figures of the flanks don't say it: always for "not producible", for "missed" if
    /// there is a cause to name (natural twist, terms outside the class).
    pub reason: Option<Reason>,
    /// Tolerance on the simulated deviation, um, normal.
    pub tolerance_um: f64,
    /// Target and result per flank; `None` for a flank that is not ground or was not reached.
    pub flanks: Sides<Option<FlankReport>>,
    /// Data of the gear.
    pub gear: Vec<Quantity>,
    /// Data of the worm.
    pub worm: Vec<Quantity>,
    /// Data of the dresser.
    pub dresser: Vec<Quantity>,
    /// Settings of the machine and the process: distances, angles, feeds, used worm width.
    pub settings: Vec<Quantity>,
    /// The diagonal ratio and why it was chosen.
    pub ratio: Option<RatioChoice>,
    /// Who uses which part of the tool.
    pub occupation: Option<WormOccupationChart>,
    /// Sections through dresser and thread space.
    pub sections: Vec<DressingSectionChart>,
    /// The grinding motions over the feed: one, or one for each flank.
    pub grinding_motions: Vec<GrindingMotion>,
    /// Dressing corrections per flank; both equal if both flanks are dressed with one motion.
    pub dressing: Sides<Option<DressingMotion>>,
    /// The strokes per flank, where the worm is dressed in strokes.
    pub strokes: Sides<Vec<StrokeReport>>,
    /// What gearbox and servo leave, where the job describes its control.
    pub control: Option<ControlReport>,
    /// NC programs, where the job names a machine.
    pub programs: Option<ProgramsReport>,
    /// What to know, with a way out.
    pub warnings: Vec<Warning>,
    /// How the result was verified.
    pub verification: Option<Verification>,
    /// Largest error by round of the precompensation.
    pub convergence: Vec<ConvergenceRound>,
    /// Time per stage.
    pub timing: Vec<Timing>,
    /// Files that were written beside the report.
    pub files: Vec<WrittenFile>,
}

/// Why a job ended as it did.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Reason {
    /// Stable code, for example "worm-too-short".
    pub code: String,
    /// Cause in one sentence.
    pub cause: String,
    /// What would help, in one sentence.
    pub way_out: String,
}

/// Target and result of one flank. Topographies are normal to the flank, um, positive = material left standing.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FlankReport {
    /// Amounts that the job asks for.
    pub amounts: Vec<TargetAmount>,
    /// Wanted topography.
    pub target: Topography,
    /// Topography by the analytic model.
    pub planned: Option<Topography>,
    /// Topography by the referee; the deviation is taken from it (from `planned` if it is absent).
    pub simulated: Option<Topography>,
    /// Characteristic values of the target.
    pub target_values: Characteristics,
    /// Characteristic values of the planned flank.
    pub planned_values: Option<Characteristics>,
    /// Characteristic values of the simulated flank.
    pub simulated_values: Option<Characteristics>,
    /// Largest |simulated - target|, um, normal.
    pub max_deviation_um: Option<f64>,
    /// Root mean square of simulated - target, um, normal.
    pub rms_deviation_um: Option<f64>,
    /// Largest |planned - simulated|, um, normal.
    pub model_difference_um: Option<f64>,
    /// Terms of the target that the process can't make, with what remains of them.
    pub outside: Vec<OutsideTerm>,
    /// Profile traces with their values; empty: the report draws three sections without values.
    pub profiles: Vec<SectionTrace>,
    /// Helix traces with their values; empty: the report draws three sections without values.
    pub helices: Vec<SectionTrace>,
}

/// One modification of the target.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TargetAmount {
    /// Kind in words, for example "helix crowning".
    pub name: String,
    /// Amount, um, as the job gives it; `None` for a kind without a single amount.
    pub amount_um: Option<f64>,
    /// What else belongs to it, for example "transverse" or "over 3 mm of roll".
    pub detail: String,
}

/// Characteristic values of a flank, um. Transverse unless the name says normal; `None` = not evaluated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Characteristics {
    /// Helix crowning C_beta.
    pub helix_crowning_um: Option<f64>,
    /// Profile crowning C_alpha.
    pub profile_crowning_um: Option<f64>,
    /// Helix slope C_Hbeta.
    pub helix_slope_um: Option<f64>,
    /// Profile slope C_Halpha.
    pub profile_slope_um: Option<f64>,
    /// Twist from the four corners, transverse.
    pub twist_corner_um: Option<f64>,
    /// Twist from the four corners, normal.
    pub twist_corner_normal_um: Option<f64>,
    /// Twist by least squares, transverse.
    pub twist_fit_um: Option<f64>,
    /// Twist by least squares, normal.
    pub twist_fit_normal_um: Option<f64>,
}

/// A term of the target outside the class that the process can make.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OutsideTerm {
    /// Term in words.
    pub name: String,
    /// What the target asks for, um.
    pub wanted_um: f64,
    /// What remains missing, um.
    pub residual_um: f64,
}

/// The diagonal ratio and how it was found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RatioChoice {
    /// Chosen ratio K = shift of the worm per axial feed; `None` if no candidate was allowed.
    pub chosen: Option<f64>,
    /// Why this one, in one or two sentences.
    pub reason: String,
    /// What was compared.
    pub candidates: Vec<RatioCandidate>,
}

/// A diagonal ratio that was tried.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RatioCandidate {
    /// The ratio K.
    pub ratio: f64,
    /// Who carries the profile crowning: "dresser", "diagonal", "correction".
    pub place: String,
    /// Score: share of the limits in use, 1 = at the limit; `None` if the candidate failed before.
    pub score: Option<f64>,
    /// Worm width that the contact runs over, mm.
    pub occupation_mm: Option<f64>,
    /// Error of the model, um.
    pub error_um: Option<f64>,
    /// "chosen", the reason why it was dropped, or nothing.
    pub note: String,
}

/// Corrections of the grinding motion over the axial feed; lists of equal length.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct GrindingMotion {
    /// Flanks that it grinds, for example "both flanks".
    pub flanks: String,
    /// Axial feed z_V2, mm.
    pub z_v2_mm: Vec<f64>,
    /// Shift of the worm z_V1, mm.
    pub z_v1_mm: Vec<f64>,
    /// Change of the centre distance, um.
    pub delta_d_um: Vec<f64>,
    /// Additional rotation of the workpiece, urad.
    pub delta_phi_2_urad: Vec<f64>,
    /// Change of the crossed-axes angle, degree.
    pub delta_gamma_deg: Vec<f64>,
}

/// Dressing corrections DK of one flank over the worm position; lists of equal length.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DressingMotion {
    /// Axial position of the worm v_zS, mm.
    pub v_zs_mm: Vec<f64>,
    /// Change of the worm's rotation, degree.
    pub d_phi_s_deg: Vec<f64>,
    /// Change of the crossing angle, degree.
    pub d_gamma_deg: Vec<f64>,
    /// Change of the centre distance of dresser and worm, mm.
    pub d_d_mm: Vec<f64>,
    /// Change of the dresser's tangential offset, mm.
    pub d_v_ya_mm: Vec<f64>,
}

/// One stroke of dressing.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StrokeReport {
    /// Number of its dresser, from 1.
    pub dresser: usize,
    /// Lengths of roll of the worm that it dresses, mm.
    pub range_mm: [f64; 2],
    /// Its corrections.
    pub motion: DressingMotion,
}

/// How the result was verified.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Verification {
    /// In words.
    pub paragraphs: Vec<String>,
    /// The stages of the referee.
    pub stages: Vec<RefereeStage>,
}

/// One stage of the referee.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RefereeStage {
    /// Bodies, for example "dresser against worm".
    pub name: String,
    /// Number of normal rays.
    pub rays: u64,
    /// Poses of the tool that each ray was offered.
    pub poses: u64,
    /// Own discretisation error, um.
    pub discretisation_um: f64,
}

/// Largest error after a round of the precompensation, um, normal.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ConvergenceRound {
    /// Number of the round; 0 = first-order start.
    pub round: u32,
    /// Largest error per flank; `None` for a flank that is not ground.
    pub error_um: Sides<Option<f64>>,
}

/// Time of a stage.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Timing {
    /// Stage in words.
    pub stage: String,
    /// Seconds.
    pub seconds: f64,
}

/// A file that was written.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct WrittenFile {
    /// Path below the output directory.
    pub path: String,
    /// What is in it.
    pub content: String,
}
