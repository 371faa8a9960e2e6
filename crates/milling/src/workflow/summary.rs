//! What a run comes to for callers that treat all processes alike, and what a terminal shows of it.

use super::result::MillingResult;
use super::run::MillingOutcome;
use super::scene::scene_of_milling;
use super::write::write_milling;
use erased_serde::Serialize;
use run::summary::{closing, opening};
use run::{RunFailure, TaskOutcome, WriteError};
use scene::Scene;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use verdict::Verdict;

impl TaskOutcome for MillingOutcome {
    fn job(&self) -> &str {
        &self.result.job
    }

    fn verdict(&self) -> Option<&Verdict> {
        Some(&self.result.verdict)
    }

    fn result(&self) -> &dyn Serialize {
        &self.result
    }

    fn scene(&self) -> Option<Result<Scene, RunFailure>> {
        Some(scene_of_milling(self))
    }

    fn write(&self, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
        write_milling(self, directory)
    }

    fn summary(&self, written: &[PathBuf], _: usize) -> String {
        summary(&self.result, written)
    }
}

fn summary(result: &MillingResult, written: &[PathBuf]) -> String {
    let worst = result.flanks.values().map(|flank| flank.max_deviation_um).fold(0.0, f64::max);
    let mut text = opening(&result.job, &result.verdict, worst, result.tolerance_um);
    for (name, flank) in &result.flanks {
        let [lowest, highest] = flank.stock_um;
        let _ = writeln!(
            text,
            "  {name}: {} rows, {lowest:.3} to {highest:.3} um, rms {:.3} um; prediction and rays on this flank differ by {:.4} um",
            flank.rows.len(),
            flank.rms_deviation_um,
            flank.model_difference_um
        );
    }
    for operation in &result.operations {
        let _ = writeln!(
            text,
            "  {}: {} paths, {} places, {:.0} mm",
            operation.name, operation.paths, operation.places, operation.way_mm
        );
    }
    for program in &result.programs {
        let _ = writeln!(
            text,
            "  {}: {} blocks, {:.0} s, read back within {:.3} um (explained: {:.3} um)",
            program.file,
            program.blocks,
            program.duration_s,
            program.proof_difference_um,
            program.proof_allowed_um
        );
    }
    closing(&mut text, &result.verdict, &result.warnings, &result.timing_s, written);
    text
}
