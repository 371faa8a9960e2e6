//! What is handed out: one report a file and their sum (JSON of `README.md#references-exit-status`).

use super::Schema;
use super::ledger::{Failure, Ledger, NotRun, Worst};
use serde::Serialize;

/// The outcome for one file.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FileReport {
    /// File as given.
    pub file: String,
    /// Schema recognised, e.g. `10-gears`.
    pub schema: Schema,
    /// Number of comparisons made.
    pub checks: usize,
    /// Number of failures.
    pub failed: usize,
    /// What failed.
    pub failures: Vec<Failure>,
    /// Cases left out because a data file is absent.
    pub not_run: Vec<NotRun>,
    /// The comparison closest to its tolerance; `null` without comparisons.
    pub worst: Option<Worst>,
}

impl FileReport {
    pub(super) fn new(file: &str, schema: Schema, ledger: Ledger) -> Self {
        Self {
            file: file.into(),
            schema,
            checks: ledger.checks,
            failed: ledger.failures.len(),
            failures: ledger.failures,
            not_run: ledger.not_run,
            worst: ledger.worst,
        }
    }
}

/// All files of one call; serialises to the JSON document of `flankwright verify --json`.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct VerifySummary {
    /// One entry a file, in the order given.
    pub files: Vec<FileReport>,
    /// Failures of all files.
    pub failed: usize,
}

impl VerifySummary {
    /// Sums the files up.
    pub fn new(files: Vec<FileReport>) -> Self {
        let failed = files.iter().map(|f| f.failed).sum();
        Self { files, failed }
    }

    /// Exit status: 0 if nothing failed, else 1.
    pub fn exit_code(&self) -> u8 {
        u8::from(self.failed > 0)
    }
}
