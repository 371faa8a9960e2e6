//! Errors of milling as findings on keys of the job.

use crate::{Along, MillingError};
use job::Diagnostic;
use run::{RunFailure, geometry_finding};

/// A planning error: bad input where the job contradicts itself, else a limit of these bodies.
pub fn failure(error: &MillingError) -> RunFailure {
    let (field, bad_input) = match error {
        MillingError::Geometry(error) => return RunFailure::bad_input(geometry_finding(error, "cutter")),
        MillingError::DensityInput { .. } => ("milling.density", true),
        MillingError::DensitySize { .. } => ("milling.density", true),
        MillingError::HeightCount { .. } => ("milling.contact_height", true),
        MillingError::HeightOutside { .. } => ("milling.contact_height", false),
        MillingError::ContactOffTool { .. } | MillingError::WearWindow { .. } => {
            ("milling.contact_height", false)
        }
        MillingError::RootTool => ("milling.root", true),
        MillingError::RootCorner { .. }
        | MillingError::RootOverlap { .. }
        | MillingError::RootBottom { .. } => ("milling.root", false),
        MillingError::Approach { .. } => ("milling.lead_in", false),
        MillingError::ColumnKink { along: Along::Axis, .. } => ("gear.double_helical", false),
        MillingError::ColumnKink { along: Along::Rays, .. } => ("bevel.double_helical", false),
        MillingError::ToolShort { .. } => ("cutter.cutting_length", false),
        MillingError::RoughingNowhere { .. } => ("milling.roughing", false),
        MillingError::ColumnNoSection { .. } => ("milling.overrun", false),
        MillingError::AxisNone { .. }
        | MillingError::GougeLocal { .. }
        | MillingError::ToolGap { .. }
        | MillingError::InternalAccess { .. }
        | MillingError::RingMet { .. } => ("cutter", false),
        _ => ("milling", false),
    };
    let finding = Diagnostic::of(error).field(field);
    if bad_input { RunFailure::bad_input(finding) } else { RunFailure::not_producible(finding) }
}
