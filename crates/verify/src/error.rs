//! Why a file could not be checked at all.

use thiserror::Error;

use job::Diagnostic;

/// A reference file that cannot be checked. Disagreeing numbers are no errors; they stand in the report.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum VerifyError {
    /// The file cannot be read, is too large, or is no text.
    #[error("{}", .finding.message)]
    Unreadable {
        /// File as given.
        file: String,
        /// What is wrong with it.
        finding: Box<Diagnostic>,
    },
    /// The file is not JSON.
    #[error("{file} is not JSON (line {line}): {cause}")]
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
    UnknownSchema {
        /// File as given.
        file: String,
        /// Keys found on the top level.
        found: String,
    },
}

impl VerifyError {
    /// Stable kebab-case code (`README.md#references-exit-status`).
    pub fn code(&self) -> &'static str {
        match self {
            Self::Unreadable { finding, .. } => finding.code,
            Self::NotJson { .. } => "invalid-json",
            Self::UnknownSchema { .. } => "unknown-schema",
        }
    }

    /// What the user can do about it, in one sentence.
    pub fn way_out(&self) -> &str {
        match self {
            Self::Unreadable { finding, .. } => match finding.code {
                // What the reader says of an absent file is meant for jobs.
                "unreadable-file" => "check the path and the permissions",
                _ => finding.way_out.as_deref().unwrap_or("check that this is the right file"),
            },
            Self::NotJson { .. } => "correct the file at this line",
            Self::UnknownSchema { .. } => {
                "give one of the reference files (tests/reference in the source), or one of the same form"
            }
        }
    }
}
