//! Jobs: checked when they are made.

use std::path::PathBuf;

use flankwright::exchange::{
    AnyJob, Diagnostic, Document, JobError, Source, job_schema, job_template, parse_any_job,
};
use flankwright::processes;
use flankwright::workflow::{AnyProcess, derived_geometry};
use pyo3::prelude::*;
use serde_json::{Value, json};

use crate::beside::beside;
use crate::failure::Failure;

/// A checked job of any process.
#[pyclass(frozen, module = "flankwright._core")]
pub struct CoreJob {
    /// The job.
    pub job: AnyJob,
    source: Source,
}

fn loaded(source: Result<Source, JobError>) -> Result<(AnyJob, Source), Failure> {
    let made = || {
        let source = source?;
        Ok((parse_any_job(source.clone())?, source))
    };
    made().map_err(|error: JobError| Failure::from(&error))
}

fn new(py: Python<'_>, source: impl FnOnce() -> Result<Source, JobError> + Send) -> PyResult<CoreJob> {
    let (job, source) = beside(py, || loaded(source()))?.map_err(|failure| failure.raised(py))?;
    Ok(CoreJob { job, source })
}

#[pymethods]
impl CoreJob {
    /// From a text, TOML or JSON; files that it names are looked for beside `name`.
    #[new]
    fn parse(py: Python<'_>, text: &str, name: &str) -> PyResult<Self> {
        new(py, || Source::from_bytes(name, text.as_bytes()))
    }

    /// From a file.
    #[staticmethod]
    fn read(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        new(py, || Source::read(&path))
    }

    #[getter]
    fn text(&self) -> &str {
        self.source.text()
    }

    #[getter]
    fn source(&self) -> &str {
        self.source.name()
    }

    #[getter]
    fn name(&self) -> &str {
        &self.job.info().name
    }

    #[getter]
    fn process(&self) -> &str {
        self.job.info().process.name()
    }

    /// The job as JSON.
    fn tree(&self, py: Python<'_>) -> PyResult<String> {
        let document =
            Document::parse(self.source.clone()).map_err(|error| Failure::from(&error).raised(py))?;
        Ok(document.to_value().to_string())
    }

    /// What follows from the job, as JSON: sections of quantities, and warnings.
    fn derived(&self, py: Python<'_>) -> PyResult<String> {
        let found = beside(py, || {
            let (derived, warnings) =
                derived_geometry(&self.job).map_err(|failure| Failure::from(&failure))?;
            let quantity = |q: &flankwright::workflow::DerivedQuantity| json!({ "key": q.key, "label": q.label, "value": q.value, "unit": q.unit });
            let sections = derived.sections().iter().map(|section| {
                let quantities: Vec<Value> = section.quantities.iter().map(quantity).collect();
                json!({ "title": section.title, "quantities": quantities })
            });
            Ok(json!({ "sections": sections.collect::<Vec<_>>(), "warnings": warnings }).to_string())
        })?;
        found.map_err(|failure: Failure| failure.raised(py))
    }
}

/// The JSON schema of jobs.
#[pyfunction]
pub fn schema() -> String {
    job_schema().to_string()
}

/// A commented job of a process.
#[pyfunction]
pub fn template(py: Python<'_>, process: &str) -> PyResult<&'static str> {
    job_template(process).ok_or_else(|| {
        let names = processes().all().map(AnyProcess::name).collect::<Vec<_>>().join(", ");
        let finding = Diagnostic::with_code("unknown-value", format!("there is no process \"{process}\""));
        let finding = finding.field("process").value(process.to_owned()).allowed(names);
        Failure::bad_input(&finding.way_out("choose one of these")).raised(py)
    })
}
