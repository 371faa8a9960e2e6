//! What tangential dressing refuses, as a finding on a key of the job.

use crate::TangentialError;
use job::Diagnostic;
use run::{RunFailure, geometry_finding};

/// A fault of tangential dressing that belongs to `field`.
pub(super) fn on_field(error: &TangentialError, field: &str) -> RunFailure {
    let finding = Diagnostic::of(error);
    let finding = finding.field(field.to_owned());
    if error.is_bad_input() { RunFailure::bad_input(finding) } else { RunFailure::not_producible(finding) }
}

impl From<&TangentialError> for RunFailure {
    fn from(error: &TangentialError) -> Self {
        let field = match error {
            TangentialError::Geometry(e) => return Self::bad_input(geometry_finding(e, "gear")),
            TangentialError::InvalidNumber { field, .. } => match *field {
                "shift_ratio" | "shift_offset" | "shift_width" => {
                    return on_field(error, &format!("grinding.{field}"));
                }
                "start radius" => "gear.evaluation.start_diameter",
                "end radius" => "gear.evaluation.end_diameter",
                "face_width" => "gear.face_width",
                "normal_pressure_angle" => "gear.normal_pressure_angle_deg",
                "pitch diameter of the worm" | "pitch radius of the worm" => "worm.pitch_diameter",
                "profile of the dresser at the length of roll" => "dresser.modification",
                "pitch radius of the dresser" => "dresser.pitch_diameter",
                "target" => "target",
                _ => "dressing",
            },
            TangentialError::Contact(_) => "worm",
            TangentialError::Dressing(_) | TangentialError::OutsideTool { .. } => "dresser",
            TangentialError::UnknownVariable { .. } | TangentialError::NoLiveVariable { .. } => {
                "dressing.variables"
            }
            TangentialError::Undercut { .. } | TangentialError::NotSettled { .. } => "target",
            TangentialError::NotConverged { .. } => "dressing.method",
        };
        on_field(error, field)
    }
}
