//! A finding about entries of a machine description that contradict each other.

use crate::diagnostic::{Diagnostic, Problem};

pub(super) fn contradiction(field: String, message: String, allowed: &str, way_out: &str) -> Diagnostic {
    Diagnostic::new(Problem::InvalidMachine, message).field(field).allowed(allowed).way_out(way_out)
}
