//! Findings about a job: remarks, failures, and how errors of the layers below become findings on keys of the job. Knows
//! no file and no body.

use foundation::geometry::GeometryError;
use foundation::kinematics::LawError;
use foundation::modification::ModificationError;
use job::{AnyJob, Diagnostic, JobError, Problem};
use referee::RemovalError;
pub use verdict::Remark;

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
    pub fn amended(self, change: impl FnOnce(Diagnostic) -> Diagnostic) -> Self {
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
    pub fn no_settings() -> Self {
        let finding = Diagnostic::new(Problem::MissingKey, "the job has no settings to simulate")
            .field("settings")
            .way_out("plan the job first: `flankwright plan` writes settings.json, which `simulate` takes");
        Self::bad_input(finding)
    }

    /// A model that is asked of a job of another process than `allowed`.
    pub fn other_process(job: &AnyJob, allowed: &'static str) -> Self {
        let process = job.info().process.name();
        let finding =
            Diagnostic::new(Problem::ProcessNotAvailable, format!("this is a job of \"{process}\""));
        let finding = finding.field("job.process").value(format!("\"{process}\"")).allowed(allowed);
        Self::bad_input(finding.way_out("take a job of that process, or the model of this one"))
    }

    /// A fault of a motion law given at `field`.
    pub fn of_law(error: &LawError, field: &str) -> Self {
        Self::bad_input(Diagnostic::of(error).field(field))
    }

    /// What stopped the referee, on the table whose motion it ran.
    pub fn of_removal(error: &RemovalError, field: &str) -> Self {
        Self::not_producible(Diagnostic::of(error).field(field))
    }
}

/// A geometry error as a finding on a key of the job.
pub fn geometry_finding(error: &GeometryError, table: &str) -> Diagnostic {
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
    let finding = Diagnostic::of(error).field(field);
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

/// An error of a modification as a finding on its entry.
pub fn modification_finding(error: &ModificationError, entry: &str) -> Diagnostic {
    Diagnostic::of(error).field(entry.to_string())
}
