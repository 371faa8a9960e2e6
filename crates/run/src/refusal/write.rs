//! Writes `result.json` and `report.html` of a refused job.

use super::page::{Refused, html_page};
use crate::derived::DerivedGeometry;
use crate::files::{json, write_with_report};
use crate::finding::Remark;
use crate::job_title::JobTitle;
use crate::processes::Processes;
use crate::write_error::WriteError;
use job::{AnyJob, Diagnostic};
use schemars::JsonSchema;
use serde::Serialize;
use serde_json::Value;
use std::path::{Path, PathBuf};

/// What stands in `result.json` of a job that its bodies cannot make.
#[derive(Serialize, JsonSchema)]
pub struct RefusedResult<'a> {
    /// What follows from the job: sections of quantities; null where the bodies themselves cannot be.
    bodies: Option<Value>,
    /// What was judged; null for a process that judges no candidates.
    candidates: Option<Value>,
    /// What could not be judged.
    failed_candidates: Option<Value>,
    /// No flank was made.
    flanks: NoEntries,
    /// Name of the job.
    job: &'a str,
    /// The process.
    process: &'a str,
    /// Why it cannot be made.
    reason: RefusalReason<'a>,
    /// No setting was found.
    settings: NoEntries,
    /// That it cannot be made.
    status: Refusal,
    /// Nothing was timed.
    timing_s: NoEntries,
    /// Tolerance of the job; null for a process without one.
    tolerance_um: Option<f64>,
    /// Version of flankwright.
    version: &'static str,
    /// No warnings.
    warnings: [Remark; 0],
}

/// Why a job cannot be made.
#[derive(Serialize, JsonSchema)]
struct RefusalReason<'a> {
    /// Stable code.
    code: &'static str,
    /// Key of the job.
    field: Option<&'a str>,
    /// The reason, with its numbers.
    text: &'a str,
    /// What can be done about it.
    way_out: Option<&'a str>,
}

/// How a refused job ended.
#[derive(Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Refusal {
    /// Not with these bodies.
    NotProducible,
}

/// A table without entries.
#[derive(Serialize, JsonSchema)]
struct NoEntries {}

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
    let document = RefusedResult {
        bodies: bodies.as_ref().map(DerivedGeometry::to_json),
        candidates: evidence.as_ref().map(|evidence| evidence.candidates()),
        failed_candidates: evidence.as_ref().map(|evidence| evidence.failed()),
        flanks: NoEntries {},
        job: &info.name,
        process: info.process.name(),
        reason: RefusalReason {
            code: finding.code,
            field: finding.field.as_deref(),
            text: &finding.message,
            way_out: finding.way_out.as_deref(),
        },
        settings: NoEntries {},
        status: Refusal::NotProducible,
        timing_s: NoEntries {},
        tolerance_um,
        version: env!("CARGO_PKG_VERSION"),
        warnings: [],
    };
    let files = vec![("result.json".to_owned(), "status, reason, bodies, candidates", json(&document)?)];
    let refused = Refused {
        job: JobTitle::new(info, job.language()),
        tolerance_um,
        finding,
        bodies: bodies.as_ref(),
        evidence: evidence.as_deref(),
    };
    write_with_report(files, directory, |named| html_page(&refused, named))
}
