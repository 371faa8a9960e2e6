//! Findings about a job: remarks, failures, and how errors of the layers below become findings on keys of the job. Knows
//! no file and no body.

use crate::exchange::{AnyJob, Diagnostic, JobError, Problem};
use crate::geometry::GeometryError;
use crate::kinematics::LawError;
use crate::modification::ModificationError;
use crate::process::dressing::DressingError;
use crate::process::generating::GeneratingError;
use crate::process::tangential_dressing::TangentialError;
use crate::removal::RemovalError;
pub use crate::verdict::Remark;

/// Why a job has no result.
#[derive(Clone, Debug)]
pub enum RunFailure {
    /// The input itself is wrong (exit 2).
    BadInput(Box<Diagnostic>),
    /// Each part is possible, but these bodies cannot make the target (exit 4).
    NotProducible(Box<Diagnostic>),
}

/// Why a job that names files of its own has no result.
#[derive(Clone, Debug)]
pub enum JobFailure {
    /// A file that it names is at fault.
    File(Box<JobError>),
    /// An entry of the job is, or the bodies are.
    Job(RunFailure),
}

impl From<JobError> for JobFailure {
    fn from(error: JobError) -> Self {
        Self::File(Box::new(error))
    }
}

impl From<RunFailure> for JobFailure {
    fn from(failure: RunFailure) -> Self {
        Self::Job(failure)
    }
}

impl RunFailure {
    /// The same failure with another finding.
    pub(super) fn amended(self, change: impl FnOnce(Diagnostic) -> Diagnostic) -> Self {
        match self {
            Self::BadInput(finding) => Self::bad_input(change(*finding)),
            Self::NotProducible(finding) => Self::not_producible(change(*finding)),
        }
    }

    /// A fault of the input.
    pub fn bad_input(finding: Diagnostic) -> Self {
        Self::BadInput(Box::new(finding))
    }

    /// A limit of the bodies.
    pub fn not_producible(finding: Diagnostic) -> Self {
        Self::NotProducible(Box::new(finding))
    }

    /// A job without the settings that `simulate` runs.
    pub(super) fn no_settings() -> Self {
        let finding = Diagnostic::new(Problem::MissingKey, "the job has no settings to simulate")
            .field("settings")
            .way_out("plan the job first: `flankwright plan` writes settings.json, which `simulate` takes");
        Self::bad_input(finding)
    }

    /// A model that is asked of a job of another process than `allowed`.
    pub(super) fn other_process(job: &AnyJob, allowed: &'static str) -> Self {
        let process = job.info().process.name();
        let finding =
            Diagnostic::new(Problem::ProcessNotAvailable, format!("this is a job of \"{process}\""));
        let finding = finding.field("job.process").value(format!("\"{process}\"")).allowed(allowed);
        Self::bad_input(finding.way_out("take a job of that process, or the model of this one"))
    }

    /// A planning error that belongs to `field`, whatever key it has by itself.
    pub(super) fn on_field(error: &GeneratingError, field: &str) -> Self {
        Self::of_generating(error, finding(error, field))
    }

    /// A fault of a motion law given at `field`.
    pub(super) fn of_law(error: &LawError, field: &str) -> Self {
        let finding = Diagnostic::with_code(error.code(), error.to_string());
        Self::bad_input(finding.field(field).way_out(error.way_out()))
    }

    /// What stopped the referee, on the table whose motion it ran.
    pub(super) fn of_removal(error: &RemovalError, field: &str) -> Self {
        let finding = Diagnostic::with_code(error.code(), error.to_string());
        Self::not_producible(finding.field(field).way_out(error.way_out().to_string()))
    }

    /// A fault of tangential dressing that belongs to `field`.
    pub(super) fn of_tangential_on(error: &TangentialError, field: &str) -> Self {
        let finding = Diagnostic::with_code(error.code(), error.to_string());
        let finding = finding.field(field.to_owned()).way_out(error.way_out());
        if error.is_bad_input() { Self::bad_input(finding) } else { Self::not_producible(finding) }
    }

    fn of_generating(error: &GeneratingError, finding: Diagnostic) -> Self {
        if error.is_bad_input() { Self::bad_input(finding) } else { Self::not_producible(finding) }
    }
}

impl From<&GeneratingError> for RunFailure {
    fn from(error: &GeneratingError) -> Self {
        Self::of_generating(error, generating_finding(error))
    }
}

impl From<&TangentialError> for RunFailure {
    fn from(error: &TangentialError) -> Self {
        let field = match error {
            TangentialError::Geometry(e) => return Self::bad_input(geometry_finding(e, "gear")),
            TangentialError::InvalidNumber { field, .. } => match *field {
                "shift_ratio" | "shift_offset" | "shift_width" => {
                    return Self::of_tangential_on(error, &format!("grinding.{field}"));
                }
                "start radius" => "gear.evaluation.start_diameter",
                "end radius" => "gear.evaluation.end_diameter",
                "face_width" => "gear.face_width",
                "normal_pressure_angle" => "gear.normal_pressure_angle_deg",
                "pitch diameter of the worm" | "pitch radius of the worm" => "worm.pitch_diameter",
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
        Self::of_tangential_on(error, field)
    }
}

/// A geometry error as a finding on a key of the job.
pub(super) fn geometry_finding(error: &GeometryError, table: &str) -> Diagnostic {
    let field = match error {
        GeometryError::InvalidNumber { field, .. } if field.contains('.') => (*field).to_string(),
        GeometryError::InvalidNumber { field, .. } => format!("{table}.{field}"),
        GeometryError::DiametersInconsistent { inner, .. } if inner.contains('.') => (*inner).to_string(),
        GeometryError::DiametersInconsistent { inner, .. } => format!("{table}.{inner}"),
        GeometryError::RadiusBelowBaseCircle { .. } => format!("{table}.form_diameter"),
        GeometryError::ToothPointed { .. } => format!("{table}.tip_diameter"),
        GeometryError::WormTooSmall { .. } => "worm.threads".to_string(),
        GeometryError::NoRack { .. } => "worm.normal_pressure_angle_deg".to_string(),
        GeometryError::BallTooSmall { .. } | GeometryError::BallTooLarge { .. } => {
            format!("{table}.over_balls")
        }
        GeometryError::SpanUndefined { .. } => format!("{table}.span"),
        GeometryError::PressureAngleNotPositive { .. } | GeometryError::InternalConicalUnsupported { .. } => {
            format!("{table}.cone_angle_deg")
        }
        _ => table.to_string(),
    };
    let finding =
        Diagnostic::with_code(error.code(), error.to_string()).field(field).way_out(error.way_out());
    match error {
        GeometryError::InvalidNumber { value, allowed, .. } => finding.value(value).allowed(*allowed),
        GeometryError::InvalidGeometry { value, allowed, .. } => {
            finding.value(value).allowed(allowed.clone())
        }
        GeometryError::DiametersInconsistent { inner_value, outer, outer_value, .. } => {
            finding.value(inner_value).allowed(format!("below {outer} = {outer_value} mm"))
        }
        GeometryError::RadiusBelowBaseCircle { radius, base_radius, .. } => {
            finding.value(2.0 * radius).allowed(format!("from {:.6} mm", 2.0 * base_radius))
        }
        GeometryError::WormTooSmall { diameter, least, .. } => {
            finding.value(diameter).allowed(format!("pitch diameter above {least} mm"))
        }
        _ => finding,
    }
}

/// A planning error as a finding on a key of the job.
pub(super) fn generating_finding(error: &GeneratingError) -> Diagnostic {
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
    Diagnostic::with_code(error.code(), error.to_string()).field(field).way_out(error.way_out())
}

/// An error of a modification as a finding on its entry.
pub(super) fn modification_finding(error: &ModificationError, entry: &str) -> Diagnostic {
    Diagnostic::with_code(error.code(), error.to_string()).field(entry.to_string()).way_out(error.way_out())
}
