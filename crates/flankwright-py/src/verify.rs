//! Reference files recomputed; without the feature `verify` an error that says how to get it.

use std::path::PathBuf;

#[cfg(feature = "verify")]
use ::verify::{FileReport, VerifyOptions, VerifySummary, verify_file};
use flankwright::exchange::Diagnostic;
use pyo3::prelude::*;

use crate::failure::Failure;
#[cfg(feature = "verify")]
use crate::watch::watched;

/// Raises that this build cannot verify.
#[cfg(not(feature = "verify"))]
#[pyfunction]
pub fn verify(py: Python<'_>, files: Vec<PathBuf>, data: Vec<PathBuf>) -> PyResult<String> {
    drop((files, data));
    let finding =
        Diagnostic::with_code("not-in-this-build", "this package was built without the feature `verify`")
            .way_out("build its wheel with `maturin build --release --features verify`");
    Err(Failure::bad_input(&finding).raised(py))
}

/// The summary of the command `verify --json`.
#[cfg(feature = "verify")]
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
