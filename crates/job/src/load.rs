//! From a file to a checked job: text, tree, process, shape, types, contradictions. The only way to a job from outside, so
//! that a holder of one need not check it again.

use super::any::Loaded;
use super::diagnostic::{Diagnostic, JobError, Problem};
use super::document::Document;
use super::format::{JobFormat, JobFormats, ProcessJob, not_available};
use super::node::Kind;
use super::shape;
use super::source::Source;
use serde_json::Value;
use std::any::TypeId;
use std::collections::HashMap;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

/// Reads, parses and checks a job file of one process (TOML or JSON).
///
/// # Errors
/// All findings of the first stage that has any; `process-not-available` for a job of another process.
pub fn read_job_of<J: ProcessJob>(path: &Path) -> Result<Loaded<J>, JobError> {
    parse_job_of(Source::read(path)?)
}

/// As [`read_job_of`], from a text.
///
/// # Errors
/// As [`read_job_of`].
pub fn parse_job_of<J: ProcessJob>(source: Source) -> Result<Loaded<J>, JobError> {
    let document = Document::parse(source)?;
    let formats = alone::<J>();
    // A word that is nearly the name is left to the check of the shape, which says what it must be.
    if let Some((node, _)) = document.root().follow("job.process")
        && let Kind::Text(name) = &node.kind
        && shape::nearest(name, [J::NAME]).is_none()
    {
        return Err(not_available(&document, name, J::NAME));
    }
    typed(document, formats.schema(), formats.tables(0))
}

/// The format of a process alone, made once.
fn alone<J: ProcessJob>() -> &'static JobFormats {
    static KNOWN: Mutex<Option<HashMap<TypeId, &'static JobFormats>>> = Mutex::new(None);
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    known
        .get_or_insert_default()
        .entry(TypeId::of::<J>())
        .or_insert_with(|| Box::leak(Box::new(JobFormats::new(vec![JobFormat::of::<J>()]))))
}

/// The typed job of a document whose process is known; `tables` is what `schema` says of its process.
pub(super) fn typed<J: ProcessJob>(
    document: Document,
    schema: &Value,
    tables: &Value,
) -> Result<Loaded<J>, JobError> {
    let refuse = |document: Document, findings| Err(JobError::new(document.source().clone(), findings));
    let example = format!("`flankwright new {}` prints a complete example", J::NAME);
    let subject = shape::Subject { document: "the job", example: &example };
    let mut findings = shape::check(document.root(), schema, tables, subject);
    findings.extend(J::shape(&document));
    if !findings.is_empty() {
        return refuse(document, findings);
    }
    let job = match J::deserialize(document.to_value()) {
        Ok(job) => job,
        // The shape check admits what the types take; this is the net below it.
        Err(error) => {
            let finding = Diagnostic::new(Problem::InvalidJob, format!("the job cannot be read: {error}"))
                .way_out(format!("compare with an example: {example}"));
            return refuse(document, vec![finding]);
        }
    };
    let findings: Vec<Diagnostic> = job.contradictions().into_iter().map(|d| document.placed(d)).collect();
    if !findings.is_empty() {
        return refuse(document, findings);
    }
    Ok(Loaded { job, document })
}
