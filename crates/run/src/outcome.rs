//! The outcome of a task: verdict, document, files, summary, for callers to whom one process is like the other.

use super::finding::RunFailure;
use super::write_error::WriteError;
use erased_serde::Serialize;
use scene::Scene;
use serde_json::Value;
use std::path::{Path, PathBuf};
use verdict::{Status, Verdict};

/// The flank of a ground gear over its grid, `[profile][helix]`, normal, um.
#[derive(Clone, Copy, Debug)]
pub struct FlankMaps<'a> {
    /// Its name.
    pub name: &'static str,
    /// Lengths of roll, mm.
    pub w_mm: &'a [f64],
    /// Axial positions, mm.
    pub z_mm: &'a [f64],
    /// What is wanted.
    pub target_um: &'a [Vec<f64>],
    /// What planning expects.
    pub planned_um: &'a [Vec<f64>],
    /// What the referee found.
    pub simulated_um: &'a [Vec<f64>],
}

/// How a task ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Conclusion {
    /// As wanted, or nothing was asked for.
    Done,
    /// Made, but not as wanted.
    Missed,
    /// Not with these bodies.
    NotProducible,
}

/// A task that was carried out, with all that is needed to show it and to write it.
pub trait TaskOutcome: Send + Sync {
    /// Name of the job.
    fn job(&self) -> &str;

    /// Whether the target is met; studies have no verdict.
    fn verdict(&self) -> Option<&Verdict>;

    /// What stands in `result.json` or `explore.json`.
    fn result(&self) -> &dyn Serialize;

    /// The same as a document.
    ///
    /// # Errors
    /// A value that JSON cannot hold.
    fn document(&self) -> Result<Value, serde_json::Error> {
        serde_json::to_value(self.result())
    }

    /// Bodies and motions for a view in space; `None` where nothing moves that could be seen.
    ///
    /// # Errors
    /// Bodies that cannot be drawn, with a finding as for a job.
    fn scene(&self) -> Option<Result<Scene, RunFailure>> {
        None
    }

    /// Ground flanks over their grids; empty for what grinds nothing.
    fn flanks(&self) -> Vec<FlankMaps<'_>> {
        Vec::new()
    }

    /// Writes all files into `directory` (made if missing); returns their paths, the page last.
    ///
    /// # Errors
    /// [`WriteError`]; the files of an earlier run stay.
    fn write(&self, directory: &Path) -> Result<Vec<PathBuf>, WriteError>;

    /// The figures that a terminal shows; `written` are the paths of the files, `rows` how many rows of a ranking there are room for.
    fn summary(&self, written: &[PathBuf], rows: usize) -> String;

    /// How the task ended: for the exit status.
    fn conclusion(&self) -> Conclusion {
        match self.verdict().and_then(Verdict::reason) {
            // Without a reason the target is met, or nothing was asked for.
            None => Conclusion::Done,
            Some(_) => Conclusion::Missed,
        }
    }

    /// What is reported where all else is quiet: why a target is missed, or why nothing can be made.
    fn complaint(&self) -> Option<String> {
        let verdict = self.verdict()?;
        let reason = verdict.reason()?;
        Some(format!(
            "{}: target {}: {} {}",
            self.job(),
            verdict.status().words(),
            reason.text,
            reason.way_out
        ))
    }

    /// Why the bodies that a study chose cannot make the target.
    fn refusal(&self) -> Option<&RunFailure> {
        None
    }

    /// Whether the target is met; studies have no status.
    fn status(&self) -> Option<Status> {
        self.verdict().map(Verdict::status)
    }
}
