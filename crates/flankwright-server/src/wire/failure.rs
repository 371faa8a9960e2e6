//! Errors of a request, in the form that the command prints: code, key, value, what is allowed, a way out, and the place in the text.

use std::io;

use flankwright::exchange::{Diagnostic, JobError, Source};
use flankwright::workflow::{JobFailure, RunFailure};
use flankwright_store::StoreError;
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

use crate::shelf::{JOB, Shelf, ShelfError};

/// One finding.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Finding {
    /// Stable code, e.g. `unknown-key`.
    pub code: String,
    /// The cause in one sentence.
    pub message: String,
    /// Path of the key, e.g. `target.modifications[1].amount_um`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub field: Option<String>,
    /// The value as given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub value: Option<String>,
    /// What would be allowed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub allowed: Option<String>,
    /// What to do about it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub way_out: Option<String>,
    /// The file, where it is not the job itself.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// Line, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<usize>,
    /// Column in characters, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub column: Option<usize>,
    /// Where it begins in the text of the job, in units of UTF-16.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub start: Option<usize>,
    /// Where it ends.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub end: Option<usize>,
}

/// Why a request has no result.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Failure {
    /// The exit status that the command would have: 1 a fault of the program, 2 bad input, 4 these bodies cannot make the target.
    pub exit: u8,
    /// What was found, never empty.
    pub errors: Vec<Finding>,
    /// Further findings that were not kept.
    pub omitted: usize,
}

impl Finding {
    /// A finding of the server itself.
    pub fn new(code: &str, message: impl Into<String>, way_out: &str) -> Self {
        Self {
            code: code.to_owned(),
            message: message.into(),
            field: None,
            value: None,
            allowed: None,
            way_out: Some(way_out.to_owned()),
            file: None,
            line: None,
            column: None,
            start: None,
            end: None,
        }
    }

    /// With the key that it is about.
    pub fn field(mut self, field: &str) -> Self {
        self.field = Some(field.to_owned());
        self
    }

    /// With what would be allowed.
    pub fn allowed(mut self, allowed: impl Into<String>) -> Self {
        self.allowed = Some(allowed.into());
        self
    }

    /// `plain` removes from a text what the client must not see.
    fn of(diagnostic: &Diagnostic, source: Option<&Source>, plain: &dyn Fn(&str) -> String) -> Self {
        let tell = |text: &Option<Box<str>>| text.as_ref().map(|text| plain(text));
        let place = diagnostic.span.as_ref().zip(source);
        let line_column = place.as_ref().map(|(span, source)| source.line_column(span.start));
        let of_job = source.is_some_and(|source| source.name() == JOB);
        let offset =
            |at: usize| place.as_ref().filter(|_| of_job).map(|(_, source)| utf16(source.text(), at));
        Self {
            code: diagnostic.code.to_owned(),
            message: plain(&diagnostic.message),
            field: tell(&diagnostic.field),
            value: tell(&diagnostic.value),
            allowed: tell(&diagnostic.allowed),
            way_out: tell(&diagnostic.way_out),
            file: source.filter(|_| !of_job).map(|source| plain(source.name())),
            line: line_column.map(|(line, _)| line),
            column: line_column.map(|(_, column)| column),
            start: diagnostic.span.as_ref().and_then(|span| offset(span.start)),
            end: diagnostic.span.as_ref().and_then(|span| offset(span.end)),
        }
    }
}

/// A place in a text in units of UTF-16, in which browsers count.
fn utf16(text: &str, at: usize) -> usize {
    let mut at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    text[..at].encode_utf16().count()
}

impl Failure {
    /// Of one finding of the server itself.
    pub fn single(finding: Finding) -> Self {
        Self { exit: 2, errors: vec![finding], omitted: 0 }
    }

    /// An internal error: one finding that the client did not cause.
    fn fault(finding: Finding) -> Self {
        Self { exit: 1, ..Self::single(finding) }
    }

    /// A fault of the program.
    pub fn internal(message: impl Into<String>) -> Self {
        let way_out = "this is a fault of flankwright: please report it with the job file";
        Self::fault(Finding::new("internal-error", message, way_out))
    }

    /// The store refuses.
    pub fn store(error: &StoreError) -> Self {
        Self::fault(Finding::new(error.code(), error.to_string(), &error.way_out()))
    }

    /// The disk of the server refuses. Its paths are not shown to the client.
    pub fn disk(error: &io::Error) -> Self {
        let message = format!("the server cannot put files down: {}", error.kind());
        let way_out = "ask who runs the server whether its disk is full, and try again";
        Self::fault(Finding::new("server-disk", message, way_out))
    }

    /// Everything that is wrong with a job or a file.
    pub fn of_error(error: &JobError, shelf: &Shelf) -> Self {
        Self::told(error, &|text| shelf.tell(text))
    }

    /// A finding about a request, which names no file of the server.
    pub fn of_finding(finding: &Diagnostic) -> Self {
        Self::single(Finding::of(finding, None, &str::to_owned))
    }

    /// Everything that is wrong with a text that names no files.
    pub fn of_text(error: &JobError) -> Self {
        Self::told(error, &str::to_owned)
    }

    fn told(error: &JobError, plain: &dyn Fn(&str) -> String) -> Self {
        let errors = error.diagnostics.iter().map(|d| Finding::of(d, Some(&error.source), plain)).collect();
        Self { exit: 2, errors, omitted: error.omitted }
    }
}

/// Files that cannot be put on a shelf.
pub fn unshelved(error: &ShelfError) -> Failure {
    match error {
        ShelfError::Name(_) | ShelfError::Folder(_) | ShelfError::TooMany(_) => {
            let way_out = "rename the file, or leave it out";
            Failure::single(Finding::new("invalid-file-name", error.to_string(), way_out).field("files"))
        }
        ShelfError::Disk(error) => Failure::disk(error),
    }
}

/// An option that is none.
pub fn wrong_option(key: &str, allowed: &str) -> Failure {
    let finding =
        Finding::new("invalid-option", format!("the option {key} takes {allowed}"), "choose one of these");
    Failure::single(finding.field(key).allowed(allowed))
}

/// Why a job has no result; `text` is its text, so that the place of the key can be given.
pub fn refused_run(failure: &JobFailure, text: &str, shelf: &Shelf) -> Failure {
    match failure {
        JobFailure::File(error) => Failure::of_error(error, shelf),
        JobFailure::Job(RunFailure::BadInput(finding)) => of_job(2, finding, text, shelf),
        JobFailure::Job(RunFailure::NotProducible(finding)) => of_job(4, finding, text, shelf),
    }
}

fn of_job(exit: u8, finding: &Diagnostic, text: &str, shelf: &Shelf) -> Failure {
    let source = shelf.source(text);
    let placed = told_of(finding.clone(), &source);
    Failure { exit, errors: vec![Finding::of(&placed, Some(&source), &|text| shelf.tell(text))], omitted: 0 }
}

/// A finding with the place of its key in the text.
fn told_of(finding: Diagnostic, source: &Source) -> Diagnostic {
    use flankwright::exchange::Document;
    if finding.span.is_some() {
        return finding;
    }
    let document = Document::parse(source.clone()).ok();
    let span =
        finding.field.as_ref().zip(document).and_then(|(field, document)| document.nearest_span(field));
    finding.span(span)
}
