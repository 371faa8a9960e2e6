//! Errors of the layers below as findings on the keys of a milling job.

use crate::MillingError;
use job::Diagnostic;
use motion::MotionError;
use nc::{Dialect, NcError};
use referee::RemovalError;
use run::RunFailure;

/// Where the cutter is, in words.
pub(super) fn in_pass(what: &str, space: usize, path: usize) -> String {
    format!("{what}, space {}, path {}", space + 1, path + 1)
}

/// An error of the motion. What the travels or the reach of the machine forbid belongs to how the workpiece sits on it.
pub fn of_motion(error: &MotionError, place: &str) -> RunFailure {
    let finding = |field: &str| {
        let text = if place.is_empty() { error.to_string() } else { format!("{place}: {error}") };
        Diagnostic::with_code(error.code(), text).field(field).way_out(error.way_out())
    };
    match error {
        MotionError::Place { .. } => RunFailure::not_producible(finding("machine.mount")),
        MotionError::CutterMissed { .. } => {
            RunFailure::not_producible(finding("machine.position_tolerance_um"))
        }
        MotionError::HoldNeedsBall => RunFailure::bad_input(finding("machine.pole")),
        MotionError::NoTilt { .. } => RunFailure::not_producible(finding("machine.pole")),
        MotionError::NoMotion { .. } => RunFailure::not_producible(finding("milling")),
        MotionError::InvalidNumber { field: "pole_cap_deg", .. } => {
            RunFailure::bad_input(finding("machine.pole_cap_deg"))
        }
        MotionError::InvalidNumber { field, .. } if field.contains("tolerance") => {
            RunFailure::bad_input(finding("machine.position_tolerance_um"))
        }
        MotionError::InvalidNumber { field: "contact_feed_mm_per_min", .. } => {
            RunFailure::bad_input(finding("milling.feed_mm_per_min"))
        }
        MotionError::InvalidNumber { .. } => RunFailure::bad_input(finding("machine.mount")),
        _ => RunFailure::bad_input(finding("machine.file")),
    }
}

/// An error of the path itself.
pub(super) fn of_milling(error: &MillingError, place: &str) -> RunFailure {
    let finding = Diagnostic::with_code(error.code(), format!("{place}: {error}"));
    RunFailure::not_producible(finding.field("milling").way_out(error.way_out()))
}

/// An error of a writer or a reader.
pub(super) fn of_writer(error: &NcError, dialect: Option<Dialect>) -> RunFailure {
    let (what, field) = match dialect {
        Some(dialect) => (format!("program for {}", dialect.name()), "output.programs"),
        None => ("cutter locations".to_owned(), "output.cl"),
    };
    let finding = Diagnostic::with_code(error.code(), format!("{what}: {error}"));
    RunFailure::bad_input(finding.field(field).way_out(error.way_out()))
}

/// An error of the rays.
pub(super) fn of_removal(error: &RemovalError) -> RunFailure {
    RunFailure::not_producible(Diagnostic::of(error).field("simulation"))
}

/// A text that does not say what was planned: nothing is written then.
pub(super) fn not_proven(text: String) -> RunFailure {
    let way_out =
        "give the control more decimals or lower machine.position_tolerance_um; nothing was written";
    let finding = Diagnostic::with_code("program-not-proven", text).field("output.programs");
    RunFailure::not_producible(finding.way_out(way_out))
}

/// A number of the work that is out of range.
pub(super) fn invalid(field: &str, value: f64, allowed: &'static str) -> RunFailure {
    let text = format!("{field} = {value} is not usable; allowed: {allowed}");
    let finding = Diagnostic::with_code("invalid-number", text).field(field).value(value).allowed(allowed);
    RunFailure::bad_input(finding.way_out("give a number in the range"))
}
