//! From a file to a checked job: text, tree, shape, types, contradictions. The only way to a `Job` from
//! outside, so that whoever holds one need not check it again.

use std::path::{Path, PathBuf};

use serde::Deserialize;

use super::diagnostic::{Diagnostic, JobError, Problem};
use super::document::Document;
use super::job::{Job, Process};
use super::node::Kind;
use super::source::Source;
use super::{checks, schema, shape};

const SUBJECT: shape::Subject = shape::Subject {
    document: "the job",
    example: "`flankwright new generating-grinding` prints a complete example",
};

/// A checked job and the document it came from.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadedJob {
    /// The job.
    pub job: Job,
    /// Text and places, for messages about this job from other layers.
    pub document: Document,
}

impl LoadedJob {
    /// The path of a file that the job names: beside the job file unless absolute.
    pub fn beside(&self, file: &str) -> PathBuf {
        let job_file = Path::new(self.document.source().name());
        job_file.parent().map_or_else(|| PathBuf::from(file), |directory| directory.join(file))
    }

    /// An error about this job found by another layer; `diagnostic.field` decides its place.
    pub fn error(&self, diagnostic: Diagnostic) -> JobError {
        JobError::single(self.document.source().clone(), placed(&self.document, diagnostic))
    }
}

/// Reads, parses and checks a job file (TOML or JSON).
///
/// # Errors
/// All findings of the first stage that has any: text, keys and types and ranges, contradictions.
pub fn read_job(path: &Path) -> Result<LoadedJob, JobError> {
    parse_job(Source::read(path)?)
}

/// As [`read_job`], from a text.
///
/// # Errors
/// As [`read_job`].
pub fn parse_job(source: Source) -> Result<LoadedJob, JobError> {
    let document = Document::parse(source)?;
    let refuse = |document: Document, findings| Err(JobError::new(document.source().clone(), findings));
    if let Some(finding) = process_not_available(&document) {
        return refuse(document, vec![finding]);
    }
    let mut findings = shape::check(document.root(), schema::shared(), SUBJECT);
    findings.extend(no_tool(&document));
    if !findings.is_empty() {
        return refuse(document, findings);
    }
    let job = match Job::deserialize(document.to_value()) {
        Ok(job) => job,
        // The shape check admits what the types take; this is the net below it.
        Err(error) => {
            let finding = Diagnostic::new(Problem::InvalidJob, format!("the job cannot be read: {error}"))
                .way_out("compare with `flankwright new generating-grinding`");
            return refuse(document, vec![finding]);
        }
    };
    let findings: Vec<Diagnostic> = checks::check(&job).into_iter().map(|d| placed(&document, d)).collect();
    if !findings.is_empty() {
        return refuse(document, findings);
    }
    Ok(LoadedJob { job, document })
}

fn placed(document: &Document, diagnostic: Diagnostic) -> Diagnostic {
    if diagnostic.span.is_some() {
        return diagnostic;
    }
    let span = diagnostic.field.as_ref().and_then(|field| document.nearest_span(field));
    diagnostic.span(span)
}

/// Each table may be absent because the other is there.
fn no_tool(document: &Document) -> Option<Diagnostic> {
    let has = |table: &str| document.root().follow(table).is_some();
    (!has("worm") && !has("catalogue")).then(|| {
        Diagnostic::new(Problem::MissingKey, "the table `[worm]` is missing")
            .field("worm")
            .allowed("a table [worm], or a table [catalogue] to choose worm and dresser from")
            .way_out(format!("add `[worm]`; {}", SUBJECT.example))
            .span(Some(document.root().span.clone()))
    })
}

/// Jobs of the other processes have other tables; one message about the process says more than many about them.
fn process_not_available(document: &Document) -> Option<Diagnostic> {
    let (node, _) = document.root().follow("job.process")?;
    let Kind::Text(name) = &node.kind else { return None };
    if !Process::NOT_AVAILABLE.contains(&name.as_str()) {
        return None;
    }
    let available: Vec<String> = Process::ALL.iter().map(|p| format!("\"{}\"", p.name())).collect();
    Some(
        Diagnostic::new(Problem::ProcessNotAvailable, format!("the process \"{name}\" is not available yet"))
            .field("job.process")
            .value(node.shown())
            .allowed(available.join(", "))
            .way_out("choose one of the available processes")
            .span(Some(node.span.clone())),
    )
}
