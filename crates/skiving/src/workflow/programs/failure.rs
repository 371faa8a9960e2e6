//! Errors of the layers below as findings.

use crate::SkivingError;
use job::Diagnostic;
use machine::MachineError;
use motion::MotionError;
use nc::{Dialect, NcError};
use run::RunFailure;

/// An error of the machine at a place of the program, in words. What travel or reach forbid is no fault of the input.
pub(super) fn of_machine(error: &MachineError, place: &str) -> RunFailure {
    let finding = Diagnostic::with_code(error.code(), format!("{place}: {error}")).field("machine");
    let finding = finding.way_out(error.way_out());
    match error {
        MachineError::AxisLimit { .. } | MachineError::Unreachable { .. } => {
            RunFailure::not_producible(finding)
        }
        _ => RunFailure::bad_input(finding),
    }
}

/// An error of the motion: words of axes, blocks that cannot be followed.
pub(super) fn of_motion(error: &MotionError) -> RunFailure {
    RunFailure::bad_input(Diagnostic::of(error).field("machine.file"))
}

/// An error of a writer.
pub(super) fn of_writer(error: &NcError, dialect: Dialect) -> RunFailure {
    let text = format!("program for {}: {error}", dialect.name());
    let finding = Diagnostic::with_code(error.code(), text).field("output.programs");
    RunFailure::bad_input(finding.way_out(error.way_out()))
}

/// An error of the tool's poses.
pub(super) fn of_skiving(error: &SkivingError) -> RunFailure {
    RunFailure::not_producible(Diagnostic::of(error).field("measuring"))
}

/// A text that does not say what was planned: nothing is written then.
pub(super) fn not_proven(text: String) -> RunFailure {
    let way_out = "give the control more decimals, or take the text as it was written; nothing was written";
    let finding = Diagnostic::with_code("program-not-proven", text).field("output.programs");
    RunFailure::not_producible(finding.way_out(way_out))
}

/// A number that is out of range.
pub(super) fn invalid(field: &str, value: f64, allowed: &'static str) -> RunFailure {
    let text = format!("{field} = {value} is not usable; allowed: {allowed}");
    let finding = Diagnostic::with_code("invalid-number", text).field(field).value(value).allowed(allowed);
    RunFailure::bad_input(finding.way_out("give a number in the range"))
}
