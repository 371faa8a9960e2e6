//! From a document whose process is known to the checked job of that process.

use super::any::Loaded;
use super::checks::machine_named_twice;
use super::diagnostic::{Diagnostic, Problem};
use super::document::Document;
use super::job_error::JobError;
use super::process_job::ProcessJob;
use super::shape;
use serde_json::Value;

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
    findings.extend(machine_named_twice(&document));
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
