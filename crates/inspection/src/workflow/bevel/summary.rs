//! What the inspection of a bevel gear comes to for callers that treat all tasks alike, and what a terminal shows of it.

use super::super::result::class_in_words;
use super::super::summary::{of_pitch, of_round};
use super::result::BevelInspectionResult;
use super::run::BevelInspection;
use super::write::write_bevel_inspection;
use erased_serde::Serialize;
use run::summary::{closing, opening};
use run::{TaskOutcome, WriteError};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use verdict::Verdict;

impl TaskOutcome for BevelInspection {
    fn job(&self) -> &str {
        &self.result.job
    }

    fn verdict(&self) -> Option<&Verdict> {
        Some(&self.result.verdict)
    }

    fn result(&self) -> &dyn Serialize {
        &self.result
    }

    fn write(&self, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
        write_bevel_inspection(self, directory)
    }

    fn summary(&self, written: &[PathBuf], _: usize) -> String {
        summary(&self.result, written)
    }
}

fn summary(result: &BevelInspectionResult, written: &[PathBuf]) -> String {
    let mut text = opening(&result.job, &result.verdict, result.largest_um(), result.tolerance_um);
    for round in &result.rounds {
        of_round(&mut text, round, 1);
    }
    of_pitch(&mut text, &result.pitch, result.run_out_um);
    if !result.classes.is_empty() {
        let class = class_in_words(result.class);
        let _ = writeln!(text, "  class of ISO 17485:2006: {class}");
    }
    closing(&mut text, &result.verdict, &result.warnings, &result.timing_s, written);
    text
}
