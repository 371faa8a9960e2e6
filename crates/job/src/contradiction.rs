//! A finding about entries of a job that are each in range and contradict each other.

use super::diagnostic::{Diagnostic, Problem};

/// Entries that are each in range and contradict each other.
pub fn contradiction(
    message: &str,
    field: impl Into<Box<str>>,
    value: String,
    allowed: &str,
    way_out: &str,
) -> Diagnostic {
    Diagnostic::new(Problem::InvalidJob, message).field(field).value(value).allowed(allowed).way_out(way_out)
}
