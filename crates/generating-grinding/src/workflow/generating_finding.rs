//! What planning of generating grinding refuses, as a finding on a key of the job.

use dressing::DressingError;
use generating::GeneratingError;
use job::Diagnostic;
use run::{RunFailure, geometry_finding};

/// A planning error on the key that it has by itself.
pub fn failure(error: &GeneratingError) -> RunFailure {
    classed(error, generating_finding(error))
}

/// A planning error that belongs to `field`, whatever key it has by itself.
pub fn on_field(error: &GeneratingError, field: &str) -> RunFailure {
    classed(error, finding(error, field))
}

fn classed(error: &GeneratingError, finding: Diagnostic) -> RunFailure {
    if error.is_bad_input() { RunFailure::bad_input(finding) } else { RunFailure::not_producible(finding) }
}

/// A planning error as a finding on a key of the job.
pub fn generating_finding(error: &GeneratingError) -> Diagnostic {
    match error {
        GeneratingError::Geometry(e) => geometry_finding(e, "gear"),
        GeneratingError::Modification(_) => finding(error, "target.modifications"),
        GeneratingError::WormTooShort { .. } => finding(error, "worm.width"),
        GeneratingError::DegenerateDirection { .. }
        | GeneratingError::DirectionAlongPath { .. }
        | GeneratingError::WormDirectionDegenerate { .. }
        | GeneratingError::Law(_)
        | GeneratingError::AreasOverlap { .. }
        | GeneratingError::WormLinesShared { .. } => finding(error, "grinding.diagonal_ratio"),
        GeneratingError::ConicalWormWithoutWidth { .. } => finding(error, "worm.width"),
        GeneratingError::NotDressed | GeneratingError::ToolBelowBase { .. } => finding(error, "worm.tool"),
        GeneratingError::ToolUndefined { .. } => finding(error, "worm.modifications"),
        GeneratingError::NoCommonSwivel { .. } => finding(error, "grinding.gauge"),
        GeneratingError::NoFlank => finding(error, "grinding.flanks"),
        GeneratingError::Stroke { .. } | GeneratingError::Dressing(DressingError::Gap { .. }) => {
            finding(error, "dressing.strokes")
        }
        GeneratingError::Dressing(_) => finding(error, "dressing"),
        _ => finding(error, "grinding"),
    }
}

fn finding(error: &GeneratingError, field: &str) -> Diagnostic {
    Diagnostic::of(error).field(field)
}
