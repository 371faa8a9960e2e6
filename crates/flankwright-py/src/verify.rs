//! Reference files recomputed.

use std::path::PathBuf;

use ::verify::{FileReport, VerifyOptions, VerifySummary, verify_file};
use flankwright::exchange::Diagnostic;
use pyo3::prelude::*;

use crate::failure::Failure;
use crate::watch::watched;

/// The summary of the command `verify --json`.
#[pyfunction]
pub fn verify(py: Python<'_>, files: Vec<PathBuf>, data: Vec<PathBuf>) -> PyResult<String> {
    let options = VerifyOptions { data_directories: data };
    let reports: Result<Vec<FileReport>, Failure> = watched(py, None, |_| {
        let one = |file: &PathBuf| {
            verify_file(file, &options).map_err(|error| Failure::bad_input(&Diagnostic::of(&error)))
        };
        files.iter().map(one).collect()
    })?;
    let reports = reports.map_err(|failure| failure.raised(py))?;
    serde_json::to_string(&VerifySummary::new(reports))
        .map_err(|error| Failure::internal(error.to_string()).raised(py))
}
