//! Errors of skiving as findings on keys of the job.

use super::readings_file::ReadingsFile;
use crate::SkivingError;
use foundation::geometry::GeometryError;
use job::Diagnostic;
use run::{RunFailure, geometry_finding};

/// An error of skiving: bad input, or bodies and measurements that do not go together.
pub fn failure(error: &SkivingError) -> RunFailure {
    if let SkivingError::Geometry(error) = error {
        return RunFailure::bad_input(of_geometry(error));
    }
    let finding = Diagnostic::of(error).field(field(error));
    let finding = match error {
        SkivingError::InvalidNumber { value, allowed, .. } => finding.value(value).allowed(*allowed),
        SkivingError::InvalidCentreDistance { value, internal } => {
            finding.value(value).allowed(if *internal { "< 0" } else { "> 0" })
        }
        SkivingError::AxisLimit { value, least, greatest, .. } => {
            finding.value(value).allowed(format!("{least} to {greatest}"))
        }
        SkivingError::TooFewTracks { tracks, degree } => {
            finding.value(degree).allowed(format!("less than the number of tracks, {tracks}"))
        }
        SkivingError::AxesParallel { angle } => {
            finding.value(angle.to_degrees()).allowed("an angle that is not 0")
        }
        SkivingError::AxesCrossed { tool, needed, .. } => {
            finding.value(tool.to_degrees()).allowed(format!("{:.6}", needed.to_degrees()))
        }
        SkivingError::LeverTooSmall { lever, .. } => finding.value(lever).allowed("0.1 mm/rad and more"),
        _ => finding,
    };
    if error.is_bad_input() { RunFailure::bad_input(finding) } else { RunFailure::not_producible(finding) }
}

/// The same where the readings come from a file.
pub(super) fn of_readings(error: &SkivingError, file: &ReadingsFile<'_>) -> RunFailure {
    match failure(error) {
        RunFailure::NotProducible(finding) => RunFailure::not_producible(file.named(*finding)),
        RunFailure::BadInput(finding) => RunFailure::bad_input(file.named(*finding)),
    }
}

fn field(error: &SkivingError) -> String {
    match error {
        SkivingError::InvalidNumber { field, .. } => of_number(field),
        SkivingError::Geometry(_) => "skiving_tool",
        SkivingError::BelowBaseCircle { .. } => "gear.evaluation",
        SkivingError::AxesParallel { .. } | SkivingError::CuttingDirectionAmbiguous { .. } => {
            "skiving.crossed_axes_angle_deg"
        }
        SkivingError::AxesCrossed { .. } => "skiving_tool.helix_angle_deg",
        SkivingError::InvalidCentreDistance { .. } => "skiving.centre_distance",
        SkivingError::LeadModificationNotSupported { .. } => "target.modifications",
        SkivingError::NoContact { .. } => "skiving_tool.rake",
        SkivingError::ContactOffRounding { .. } | SkivingError::RoundingTooLarge { .. } => {
            "skiving_tool.edge_radius"
        }
        SkivingError::LeverTooSmall { .. } | SkivingError::EdgeEndTouched { .. } => "measuring.tracks",
        SkivingError::PoseNotReachable { .. }
        | SkivingError::DegenerateFlankDirection { .. }
        | SkivingError::BodyTouched { .. } => "measuring.poses",
        SkivingError::AxisLimit { .. } => "measuring.travel",
        SkivingError::Shadowed { .. } => "light_barrier.radius",
        SkivingError::NoTrigger { .. }
        | SkivingError::TriggerCountMismatch { .. }
        | SkivingError::AmbiguousTooth { .. } => "tool_errors",
        SkivingError::TooFewTracks { .. } => "evaluation.curve_degree",
        SkivingError::CalibrationSingular { .. } => "calibration",
    }
    .to_owned()
}

/// The key of a number that the library calls by its own name.
fn of_number(field: &str) -> &'static str {
    match field {
        "teeth" => "gear.teeth",
        "normal_pressure_angle_deg" => "gear.normal_pressure_angle_deg",
        "helix_angle_deg" => "gear.helix_angle_deg",
        "cone_angle_deg" => "gear.cone_angle_deg",
        "length_of_roll" => "gear.evaluation",
        "tool_shift" => "skiving.tool_shift",
        "centre_distance" => "skiving.centre_distance",
        "crossed_axes_angle_deg" => "skiving.crossed_axes_angle_deg",
        "beam.x" | "beam.y" | "beam.z" => "light_barrier.point",
        "beam.tilt_x_deg" => "light_barrier.tilt_x_deg",
        "beam.tilt_y_deg" => "light_barrier.tilt_y_deg",
        "beam.direction" => "light_barrier.direction",
        "beam.radius" => "light_barrier.radius",
        "track_places" => "measuring.tracks",
        "band_um" => "evaluation.band_um",
        "wear_limit_um" => "evaluation.wear_limit_um",
        "setting_limit" => "evaluation.limits",
        "angle" => "readings.file",
        "observation" => "calibration",
        "scan.places" => "stylus.places",
        "tool.teeth" => "skiving_tool.teeth",
        "real_tool" => "tool_errors",
        "runout.orders" => "runout.orders",
        _ => "job",
    }
}

/// A fault of a body; those of the tool stand in its own table.
fn of_geometry(error: &GeometryError) -> Diagnostic {
    let GeometryError::InvalidNumber { field, .. } = error else { return geometry_finding(error, "gear") };
    let key = match *field {
        "tool.teeth" => "skiving_tool.teeth",
        "tool.helix_angle_deg" => "skiving_tool.helix_angle_deg",
        "normal_module" => "gear.normal_module",
        "rounding_radius" => "skiving_tool.edge_radius",
        "rake_chamfer_width" => "skiving_tool.rake_chamfer.width",
        "rake_chamfer_angle_deg" => "skiving_tool.rake_chamfer.angle_deg",
        "clearance_angle_deg" => "skiving_tool.clearance_angle_deg",
        "clearance_chamfer_angle_deg" => "skiving_tool.clearance_chamfer_angle_deg",
        _ => return geometry_finding(error, "gear"),
    };
    geometry_finding(error, "gear").field(key)
}
