//! Tasks on jobs, one by one and many at once.

use flankwright::numerics::{Progress, Silent};
use flankwright::workflow::{Preview, Task, carry_out, preview_job};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyList;

use crate::beside::beside;
use crate::failure::Failure;
use crate::job::CoreJob;
use crate::outcome::{CoreResult, Held};
use crate::watch::{on_each, watched};

fn task_of(name: &str) -> PyResult<Task> {
    let known = Task::ALL.into_iter().find(|task| task.name() == name);
    known.ok_or_else(|| PyValueError::new_err(format!("there is no task {name:?}")))
}

fn carried_out(task: Task, job: &CoreJob, progress: &dyn Progress) -> Result<CoreResult, Failure> {
    let done = CoreResult::of(|| carry_out(task, &job.job, progress).map(Held::Completed));
    done.map_err(|failure| Failure::of_task(&failure, &job.job))
}

/// Carries a task out on a job.
#[pyfunction]
#[pyo3(signature = (task, job, progress=None))]
pub fn run(
    py: Python<'_>,
    task: &str,
    job: &Bound<'_, CoreJob>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<CoreResult> {
    let (task, job) = (task_of(task)?, job.get());
    let done = watched(py, progress, |progress| carried_out(task, job, progress))?;
    done.map_err(|failure| failure.raised(py))
}

/// Works on many jobs, on all cores; results and exceptions in the order of the jobs.
fn many<'py, T: Send>(
    py: Python<'py>,
    jobs: &[Bound<'py, CoreJob>],
    progress: Option<&Bound<'py, PyAny>>,
    work: impl Fn(&CoreJob) -> Result<T, Failure> + Sync + Send,
    made: impl Fn(T) -> PyResult<Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyList>> {
    let shared: Vec<&CoreJob> = jobs.iter().map(Bound::get).collect();
    let list = PyList::empty(py);
    for one in on_each(py, progress, "jobs", &shared, |_, job| work(job))? {
        match one {
            Ok(value) => list.append(made(value)?)?,
            Err(failure) => list.append(failure.raised(py).into_value(py))?,
        }
    }
    Ok(list)
}

/// Carries a task out on many jobs.
#[pyfunction]
#[pyo3(signature = (task, jobs, progress=None))]
pub fn run_many<'py>(
    py: Python<'py>,
    task: &str,
    jobs: Vec<Bound<'py, CoreJob>>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyList>> {
    let task = task_of(task)?;
    let work = |job: &CoreJob| carried_out(task, job, &Silent);
    many(py, &jobs, progress, work, |result| Ok(Bound::new(py, result)?.into_any()))
}

fn document(job: &CoreJob) -> Result<String, Failure> {
    let preview: Preview = preview_job(&job.job).map_err(|failure| Failure::from(&failure))?;
    serde_json::to_string(&preview).map_err(|error| Failure::internal(error.to_string()))
}

/// A plan without its referee, as JSON.
#[pyfunction]
pub fn preview(py: Python<'_>, job: &Bound<'_, CoreJob>) -> PyResult<String> {
    let job = job.get();
    beside(py, || document(job))?.map_err(|failure| failure.raised(py))
}

/// Plans of many jobs without their referee, as JSON.
#[pyfunction]
#[pyo3(signature = (jobs, progress=None))]
pub fn preview_many<'py>(
    py: Python<'py>,
    jobs: Vec<Bound<'py, CoreJob>>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyList>> {
    many(py, &jobs, progress, document, |text| Ok(text.into_pyobject(py)?.into_any()))
}
