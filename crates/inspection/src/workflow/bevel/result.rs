//! `result.json` of a measured bevel gear, with units in the key names. Deviations normal to the flank, positive = material left standing.

use super::super::closed_loop::RoundResult;
use super::super::result::{ClassResult, PitchInspectionResult};
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;
use verdict::{Remark, Verdict};

/// The whole document.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct BevelInspectionResult {
    /// Name of the file that was measured.
    pub job: String,
    /// Process.
    pub process: &'static str,
    /// Version of flankwright.
    pub version: &'static str,
    /// What was judged.
    #[serde(flatten)]
    pub verdict: Verdict,
    /// The class of ISO 17485:2006 that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance_class: Option<i32>,
    /// Tolerance of the job.
    pub tolerance_um: f64,
    /// The file that was read.
    pub files: Vec<String>,
    /// Doubts of reading and evaluation.
    pub warnings: Vec<Remark>,
    /// Rows and columns of the grid.
    pub grid: [usize; 2],
    /// Comparison with the job, tests, correction, proof; one round. w is the length of roll in the middle of the face, z counts along the
    /// pitch cone from there to the heel.
    pub rounds: Vec<RoundResult>,
    /// Where the pitch was measured; absent where not all teeth were.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pitch_place: Option<BevelPitchPlace>,
    /// Pitches by flank, on the tolerance diameter.
    pub pitch: BTreeMap<&'static str, PitchInspectionResult>,
    /// F_r: run-out of a ball in the spaces, across the pitch cone.
    #[serde(rename = "Fr_um", skip_serializing_if = "Option::is_none")]
    pub run_out_um: Option<f64>,
    /// Classes of ISO 17485:2006 that the values reach.
    pub classes: Vec<ClassResult>,
    /// The worst of them; absent where a value is worse than class 11, or nothing was judged.
    pub class: Option<i32>,
    /// Seconds per stage; the only part that differs between two runs.
    pub timing_s: BTreeMap<&'static str, f64>,
}

/// The point of each tooth at which the pitch was measured, and what the tolerances depend on.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct BevelPitchPlace {
    /// Row, from 1 at the root.
    pub row: usize,
    /// Column, from 1 at the toe.
    pub column: usize,
    /// Its distance from the axis.
    pub radius_mm: f64,
    /// d_T: the mean pitch diameter.
    pub tolerance_diameter_mm: f64,
    /// m_mn.
    pub mean_normal_module_mm: f64,
}

impl BevelInspectionResult {
    /// Largest deviation of the measured flanks from the target, um.
    pub fn largest_um(&self) -> f64 {
        let flanks = self.rounds.iter().flat_map(|round| round.flanks.values());
        flanks.map(|flank| flank.measured.largest_um).fold(0.0, f64::max)
    }
}
