//! Work beside the interpreter: on the threads of the process, with exceptions where there are none.

use pyo3::prelude::*;

use crate::failure::Failure;
use crate::pool::{on_threads, threads};

/// Computes on so many threads from now on: workers of a cluster share their machine.
#[pyfunction]
pub fn use_threads(py: Python<'_>, count: usize) -> PyResult<()> {
    threads(Some(count)).map(drop).map_err(|error| Failure::from(&error).raised(py))
}

/// Carries short work out without the interpreter.
///
/// # Errors
/// As [`on_threads`].
pub fn beside<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    py.detach(|| on_threads(work)).map_err(|error| Failure::from(&error).raised(py))
}
