//! Writes `result.json` and `report.html` of a refused job.

use super::page::{Refused, html_page};
use crate::files::{WriteError, json, write_with_report};
use crate::processes::Processes;
use job::{AnyJob, Diagnostic};
use std::path::{Path, PathBuf};

/// Writes what a job that these bodies cannot make hands over: `result.json` with status, reason, bodies and candidates, and the
/// report with the picture of what limits; returns their paths, the report last. For generating grinding the candidates are judged
/// once more.
///
/// # Errors
/// [`WriteError`].
pub fn write_refusal(
    processes: &Processes,
    job: &AnyJob,
    finding: &Diagnostic,
    directory: &Path,
) -> Result<Vec<PathBuf>, WriteError> {
    let info = job.info();
    let process = processes.of(job).ok();
    let tolerance_um = process.and_then(|process| process.tolerance_um(job));
    // Bodies that cannot be put together are the reason itself.
    let bodies = processes.derived_geometry(job).ok().map(|(bodies, _)| bodies);
    let evidence = process.and_then(|process| process.evidence(job, finding));
    let document = serde_json::json!({
        "job": info.name,
        "process": info.process.name(),
        "version": env!("CARGO_PKG_VERSION"),
        "status": "not_producible",
        "tolerance_um": tolerance_um,
        "reason": { "code": finding.code, "text": finding.message, "way_out": finding.way_out, "field": finding.field },
        "bodies": bodies.as_ref().map(|bodies| bodies.to_json()),
        "candidates": evidence.as_ref().map(|evidence| evidence.candidates()),
        "failed_candidates": evidence.as_ref().map(|evidence| evidence.failed()),
        "warnings": [],
        "settings": {},
        "flanks": {},
        "timing_s": {},
    });
    let files = vec![("result.json".to_owned(), "status, reason, bodies, candidates", json(&document)?)];
    let refused =
        Refused { job: info, tolerance_um, finding, bodies: bodies.as_ref(), evidence: evidence.as_deref() };
    write_with_report(files, directory, |named| html_page(&refused, named))
}
