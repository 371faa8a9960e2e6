//! Findings of the library as exceptions of Python. Which class they are is decided there, from the exit status that the command would have.

use std::path::PathBuf;
use std::sync::Arc;

use flankwright::exchange::{AnyJob, Diagnostic, JobError, Source};
use flankwright::geometry::GeometryError;
use flankwright::workflow::{JobFailure, RunFailure, write_refusal};
use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;
use rayon::ThreadPoolBuildError;
use serde_json::{Value, json};

use crate::pool::on_threads;

/// Why something has no result: the exit status that the command would have, and what was found.
#[derive(Clone, Debug)]
pub struct Failure {
    exit: u8,
    findings: Vec<Value>,
    omitted: usize,
    /// A job that its bodies cannot make, of which a report can be written.
    refusal: Option<Arc<Refusal>>,
}

/// A job that its bodies cannot make, and why.
#[derive(Debug)]
struct Refusal {
    job: AnyJob,
    finding: Diagnostic,
}

/// Writes the report of a refused job.
#[pyclass(frozen, module = "flankwright._core")]
pub struct CoreRefusal {
    refusal: Arc<Refusal>,
}

#[pymethods]
impl CoreRefusal {
    /// Writes all files; their paths, the page last.
    fn write(&self, py: Python<'_>, directory: PathBuf) -> PyResult<Vec<PathBuf>> {
        let Refusal { job, finding } = &*self.refusal;
        let written = py.detach(|| on_threads(|| write_refusal(job, finding, &directory)));
        let written = written.map_err(|error| Failure::from(&error).raised(py))?;
        written.map_err(|error| PyOSError::new_err(error.to_string()))
    }
}

impl Failure {
    /// A task on a job that has no result; what the bodies cannot make can be reported.
    pub fn of_task(failure: &JobFailure, job: &AnyJob) -> Self {
        let refusal = match failure {
            JobFailure::Job(RunFailure::NotProducible(finding)) => {
                Some(Arc::new(Refusal { job: job.clone(), finding: (**finding).clone() }))
            }
            JobFailure::Job(RunFailure::BadInput(_)) | JobFailure::File(_) => None,
        };
        Self { refusal, ..Self::from(failure) }
    }

    /// Wrong input, in one finding.
    pub fn bad_input(finding: &Diagnostic) -> Self {
        Self::one(2, finding)
    }

    /// Wrong input, or a limit of the bodies.
    pub fn of_bodies(is_bad_input: bool, finding: &Diagnostic) -> Self {
        Self::one(if is_bad_input { 2 } else { 4 }, finding)
    }

    /// A fault of the program.
    pub fn internal(message: impl Into<String>) -> Self {
        let way_out = "this is a fault of flankwright: please report it with the job";
        let finding = json!({ "code": "internal-error", "message": message.into(), "way_out": way_out });
        Self { exit: 1, findings: vec![finding], omitted: 0, refusal: None }
    }

    fn one(exit: u8, finding: &Diagnostic) -> Self {
        Self { exit, findings: vec![told(finding, None)], omitted: 0, refusal: None }
    }

    /// The same, for one of many samples.
    pub fn on_sample(mut self, sample: usize) -> Self {
        for entries in self.findings.iter_mut().filter_map(Value::as_object_mut) {
            entries.insert("sample".into(), sample.into());
        }
        self
    }

    /// The exception.
    pub fn raised(&self, py: Python<'_>) -> PyErr {
        let made = || -> PyResult<PyErr> {
            let findings = Value::from(self.findings.clone()).to_string();
            let raised = py.import("flankwright._errors")?.getattr("raised")?;
            let exception = raised.call1((self.exit, findings, self.omitted))?;
            if let Some(refusal) = &self.refusal {
                exception.setattr("_refusal", Bound::new(py, CoreRefusal { refusal: refusal.clone() })?)?;
            }
            Ok(PyErr::from_value(exception))
        };
        made().unwrap_or_else(|error| error)
    }
}

fn told(finding: &Diagnostic, source: Option<&Source>) -> Value {
    let mut told = serde_json::to_value(finding).unwrap_or_default();
    let place = finding.span.as_ref().zip(source);
    if let (Some((span, source)), Some(entries)) = (place, told.as_object_mut()) {
        let (line, column) = source.line_column(span.start);
        entries.insert("file".into(), source.name().into());
        entries.insert("line".into(), line.into());
        entries.insert("column".into(), column.into());
    }
    told
}

impl From<&ThreadPoolBuildError> for Failure {
    fn from(error: &ThreadPoolBuildError) -> Self {
        Self::internal(error.to_string())
    }
}

impl From<&JobError> for Failure {
    fn from(error: &JobError) -> Self {
        let findings = error.diagnostics.iter().map(|finding| told(finding, Some(&error.source))).collect();
        Self { exit: 2, findings, omitted: error.omitted, refusal: None }
    }
}

impl From<&RunFailure> for Failure {
    fn from(failure: &RunFailure) -> Self {
        match failure {
            RunFailure::BadInput(finding) => Self::one(2, finding),
            RunFailure::NotProducible(finding) => Self::one(4, finding),
        }
    }
}

impl From<&JobFailure> for Failure {
    fn from(failure: &JobFailure) -> Self {
        match failure {
            JobFailure::File(error) => Self::from(&**error),
            JobFailure::Job(failure) => Self::from(failure),
        }
    }
}

impl From<&GeometryError> for Failure {
    fn from(error: &GeometryError) -> Self {
        let finding = Diagnostic::of(error);
        Self::bad_input(&match error {
            GeometryError::InvalidNumber { field, value, allowed, .. } => {
                finding.field(*field).value(value).allowed(*allowed)
            }
            GeometryError::InvalidGeometry { value, allowed, .. } => {
                finding.value(value).allowed(allowed.clone())
            }
            _ => finding,
        })
    }
}
