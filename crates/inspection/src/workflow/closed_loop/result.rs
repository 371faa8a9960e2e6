//! What a measurement says for a job, as `result.json` has it: comparison on the grid, tests, correction, proof. um, normal to the flank,
//! positive = material left, unless a key says otherwise.

use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// One round of measuring and correcting.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RoundResult {
    /// Round, from 1.
    pub round: usize,
    /// Target, process and measurement on the grid, by flank.
    pub flanks: BTreeMap<&'static str, MeasuredFlankResult>,
    /// Which part of every characteristic the teeth share.
    pub characteristics: Vec<CharacteristicResult>,
    /// The correction; absent where nothing is worth one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub correction: Option<CorrectionResult>,
    /// Why there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub no_correction: Option<String>,
    /// Axes of the machine that would explain the measurement, each by itself, the one that explains most first.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub axes: Vec<AxisResult>,
    /// Axes that explain the measurement together, where several explain clearly more than the best of them alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axes_together: Option<AxesTogether>,
    /// Axes that could not be asked, with the reason.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub axes_not_asked: BTreeMap<String, String>,
}

/// An axis of the machine that may be off.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct AxisResult {
    /// Its name with the unit, as forward models have it.
    pub axis: String,
    /// The deviation that explains the measurement best, in that unit.
    pub value: f64,
    /// Its standard uncertainty.
    pub uncertainty: f64,
    /// Share of the squares of the measured lines that it explains.
    pub explains: f64,
    /// Axes that leave nearly the same.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub not_told_apart: Vec<String>,
}

/// Several axes of the machine that may be off at once.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct AxesTogether {
    /// The axes with what each would be off by, in the order in which they were found.
    pub axes: Vec<JointAxis>,
    /// Share of the squares of the measured lines that they explain together.
    pub explains: f64,
}

/// One of several axes that may be off at once.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct JointAxis {
    /// Its name with the unit, as forward models have it.
    pub axis: String,
    /// Its deviation in that unit.
    pub value: f64,
    /// Its standard uncertainty beside the others.
    pub uncertainty: f64,
}

/// A flank on the grid, row-major [profile][helix]; absent values were not measured.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MeasuredFlankResult {
    /// Lengths of roll.
    pub w_mm: Vec<f64>,
    /// Heights.
    pub z_mm: Vec<f64>,
    /// Target, without compensation.
    pub target_um: Vec<Vec<f64>>,
    /// Planned, with compensation, by the exact contact.
    pub planned_um: Vec<Vec<f64>>,
    /// The same by the referee's rays.
    pub simulated_um: Vec<Vec<f64>>,
    /// Measured, mean over the teeth; its zero is that of the target.
    pub measured_um: Vec<Vec<Option<f64>>>,
    /// Teeth that it is the mean of.
    pub teeth: usize,
    /// What the surface was made of.
    pub surface: String,
    /// How far profiles and helix traces disagree where they cross: root mean square and largest.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mismatch_um: Option<[f64; 2]>,
    /// How far the grid goes beyond the outermost lines, as a share of the field, where that is far.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub outside_traces: BTreeMap<&'static str, f64>,
    /// Whether the measured lines tell anything of the twist; one profile and one helix trace do not.
    pub sees_twist: bool,
    /// Teeth that differ from the others beyond chance and by more than the tolerance: their largest difference from what all share and what
    /// goes around the gear once a turn, um.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub standing_out: BTreeMap<u32, f64>,
    /// Simulated minus target.
    pub produced: DifferenceResult,
    /// Measured minus target.
    pub measured: DifferenceResult,
    /// Measured minus simulated.
    pub model: DifferenceResult,
    /// Correlation of measured and simulated deviations.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub correlation: Option<f64>,
    /// Whether the process model explains the part.
    pub explained: bool,
}

/// A difference of two flanks about its mean.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DifferenceResult {
    /// Root mean square.
    pub rms_um: f64,
    /// Largest.
    pub largest_um: f64,
    /// Largest minus smallest.
    pub range_um: f64,
    /// f_Ha, f_Hb (of material), C_alpha, C_beta, S of the areal fit of second degree.
    #[serde(rename = "fHa_um")]
    pub profile_slope_um: f64,
    /// f_Hb.
    #[serde(rename = "fHb_material_um")]
    pub helix_slope_um: f64,
    /// C_alpha.
    #[serde(rename = "Ca_um")]
    pub profile_crowning_um: f64,
    /// C_beta.
    #[serde(rename = "Cb_um")]
    pub helix_crowning_um: f64,
    /// S.
    #[serde(rename = "S_um")]
    pub twist_um: f64,
    /// Share of the points within the tolerance.
    pub within_tolerance: f64,
}

/// The test of one characteristic.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CharacteristicResult {
    /// Flank.
    pub flank: &'static str,
    /// fHa, Ca, fHb, Cb or S; slopes of material.
    pub characteristic: &'static str,
    /// Teeth.
    pub teeth: Vec<u32>,
    /// Readings of each tooth.
    pub repeats: usize,
    /// Mean of each tooth's readings.
    pub values_um: Vec<f64>,
    /// What all teeth share.
    pub common_um: f64,
    /// Standard uncertainty of that; absent with one tooth.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub uncertainty_um: Option<f64>,
    /// Above this it is corrected.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit_um: Option<f64>,
    /// Probability of so large a mean by chance.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub p: Option<f64>,
    /// Amplitude of the first harmonic around the gear, where it is real: the clamping, which no correction removes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub harmonic_um: Option<f64>,
    /// correct, below-dead-band, not-systematic, first-harmonic or not-tested.
    pub decision: &'static str,
}

/// A correction and its proof.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CorrectionResult {
    /// Settings that are turned; none where the flank itself is corrected, as in milling.
    pub settings: Vec<CorrectedSettingResult>,
    /// Deviation of the measured lines, root mean square.
    pub rms_before_um: f64,
    /// What the first-order model predicts.
    pub rms_predicted_um: f64,
    /// What these settings cannot remove.
    pub rms_unremovable_um: f64,
    /// Independent unknowns, of how many.
    pub rank: [usize; 2],
    /// Settings that the lines do not tell apart.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub not_told_apart: Vec<Vec<(String, f64)>>,
    /// What the corrected job leaves, by flank: the measured deviation and what the referee's rays say that the corrected settings change.
    pub proof: BTreeMap<&'static str, ProofResult>,
    /// Change of the machine's settings from the job to the corrected one.
    pub machine: MachineChange,
}

/// A setting of a correction.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CorrectedSettingResult {
    /// Name with its unit.
    pub name: String,
    /// Change.
    pub change: f64,
    /// Standard deviation of it; absent where the lines leave it open.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deviation: Option<f64>,
    /// Sum of all corrections.
    pub total: f64,
    /// Whether a bound holds it.
    pub at_bound: bool,
    /// Whether it is too small to be turned.
    pub dropped: bool,
}

/// What the referee says of a correction, on the grid, about the mean.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ProofResult {
    /// Measured deviation now.
    pub before: DifferenceResult,
    /// Measured deviation with the referee's change.
    pub after: DifferenceResult,
    /// Largest difference of first order and referee.
    pub first_order_off_um: f64,
}

/// What changes on the machine: coefficients over the feed and largest changes of the dressing axes; nothing where the flank itself is
/// corrected.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct MachineChange {
    /// Change of Delta_d over z_V2, um/mm^k.
    pub delta_d_um: Vec<f64>,
    /// Change of Delta_phi_2 over z_V2, urad/mm^k.
    pub delta_phi_2_urad: Vec<f64>,
    /// Largest change of d_phi_S (deg), d_gamma (deg), d_d (mm), d_v_yA (mm) while the worm is dressed, by flank.
    pub dressing: BTreeMap<&'static str, [f64; 4]>,
}
