//! What a run comes to for callers that treat all processes alike, and what a terminal shows of it.

use super::result::TangentialResult;
use super::run::TangentialOutcome;
use super::scene::scene_of_tangential;
use super::write::write_tangential;
use crate::job::LoadedTangentialJob;
use erased_serde::Serialize;
use generating_grinding::workflow::{controlled, proven};
use run::summary::{closing, fixed, opening};
use run::{FlankMaps, RunFailure, TaskOutcome, WriteError};
use scene::Scene;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use verdict::Verdict;

/// A run of tangential dressing with the job that it is of: what is written has the job with its settings.
pub struct TangentialJobOutcome {
    /// The job as it was carried out.
    pub loaded: LoadedTangentialJob,
    /// What its run produced.
    pub outcome: TangentialOutcome,
}

impl TaskOutcome for TangentialJobOutcome {
    fn job(&self) -> &str {
        &self.outcome.result.job
    }

    fn verdict(&self) -> Option<&Verdict> {
        Some(&self.outcome.result.verdict)
    }

    fn result(&self) -> &dyn Serialize {
        &self.outcome.result
    }

    fn scene(&self) -> Option<Result<Scene, RunFailure>> {
        Some(scene_of_tangential(&self.outcome))
    }

    fn flanks(&self) -> Vec<FlankMaps<'_>> {
        self.outcome.result.flanks.iter().map(|(name, of)| of.flank.maps(name)).collect()
    }

    fn write(&self, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
        write_tangential(&self.loaded, &self.outcome, directory)
    }

    fn summary(&self, written: &[PathBuf], _: usize) -> String {
        summary(&self.outcome.result, written)
    }
}

fn summary(result: &TangentialResult, written: &[PathBuf]) -> String {
    let worst = result.flanks.values().map(|f| f.flank.max_deviation_um).fold(0.0, f64::max);
    let mut text = opening(&result.job, &result.verdict, worst, result.tolerance_um);
    for pass in &result.passes {
        let names: Vec<String> =
            pass.variables.iter().map(|v| format!("{} {}", v.name, fixed(v.value, 5))).collect();
        let _ = writeln!(
            text,
            "  {}: {} variables by {} in {} rounds: {}",
            pass.flanks.join(" and "),
            names.len(),
            pass.method,
            pass.rounds,
            names.join(", ")
        );
    }
    for (flank, f) in &result.flanks {
        let [from, to] = f.dresser_position_mm;
        let _ = writeln!(
            text,
            "  {flank:<5} deviation max {:.4} um, rms {:.4} um; analytic against referee {:.2e} um, without a surface between the stages {:.1e} um",
            f.flank.max_deviation_um,
            f.flank.rms_deviation_um,
            f.flank.model_difference_um,
            f.sample_difference_um
        );
        let _ = writeln!(text, "        dresser from {from:.2} to {to:.2} mm on the worm");
        if let Some(radial) = &f.radial_feed {
            let left = radial
                .max_deviation_um
                .map_or_else(|| "no flank".to_owned(), |um| format!("up to {um:.3} um off"));
            let twist = radial.twist_normal_um.unwrap_or(radial.closed_twist_normal_um);
            let _ = writeln!(text, "        radial feed would leave {} um of twist, {left}", fixed(twist, 3));
        }
    }
    text += &controlled(result.control.as_ref());
    text += &proven(result.programs.as_ref());
    closing(&mut text, &result.verdict, &result.warnings, &result.timing_s, written);
    text
}
