//! Why a file could not be checked at all.

use finding::Finding;
use thiserror::Error;

use job::Diagnostic;

/// A reference file that cannot be checked. Disagreeing numbers are no errors; they stand in the report.
#[derive(Clone, Debug, PartialEq, Eq, Error, Finding)]
pub enum VerifyError {
    /// The file cannot be read, is too large, or is no text.
    #[error("{}", .finding.message)]
    #[finding(code = finding.code)]
    #[way_out(with = reread(finding))]
    Unreadable {
        /// File as given.
        file: String,
        /// What is wrong with it.
        finding: Box<Diagnostic>,
    },
    /// The file is not JSON.
    #[error("{file} is not JSON (line {line}): {cause}")]
    #[finding(code = "invalid-json")]
    #[way_out("correct the file at this line")]
    NotJson {
        /// File as given.
        file: String,
        /// Line, from 1.
        line: usize,
        /// What the parser says.
        cause: String,
    },
    /// The content belongs to no schema of reference files.
    #[error("{file} is no reference file of a known schema (top level: {found})")]
    #[finding(code = "unknown-schema")]
    #[way_out("give one of the reference files (tests/reference in the source), or one of the same form")]
    UnknownSchema {
        /// File as given.
        file: String,
        /// Keys found on the top level.
        found: String,
    },
}

/// What helps where a file cannot be read.
fn reread(finding: &Diagnostic) -> String {
    match finding.code {
        // What the reader says of an absent file is meant for jobs.
        "unreadable-file" => "check the path and the permissions",
        _ => finding.way_out.as_deref().unwrap_or("check that this is the right file"),
    }
    .to_owned()
}
