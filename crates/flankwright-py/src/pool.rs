//! The threads of the work. A process that was forked has none of its parent's: it makes its own.

use std::mem::forget;
use std::process::id;
use std::sync::{Arc, Mutex, PoisonError};

use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::failure::Failure;

/// The process that made the threads, and they.
static MADE: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// The threads of this process, `count` where they are made anew (0: as many as there are processors).
fn threads(count: Option<usize>) -> Result<Arc<ThreadPool>, Failure> {
    let mut made = MADE.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((by, there)) = made.as_ref()
        && *by == id()
        && count.is_none_or(|count| count == there.current_num_threads())
    {
        return Ok(there.clone());
    }
    let built = ThreadPoolBuilder::new().num_threads(count.unwrap_or(0)).build();
    let built = Arc::new(built.map_err(|error| Failure::internal(error.to_string()))?);
    if let Some((by, there)) = made.replace((id(), built.clone()))
        && by != id()
    {
        // Nobody is there to answer a farewell.
        forget(there);
    }
    Ok(built)
}

/// Computes on so many threads from now on: workers of a cluster share their machine.
#[pyfunction]
pub fn use_threads(py: Python<'_>, count: usize) -> PyResult<()> {
    threads(Some(count)).map(drop).map_err(|failure| failure.raised(py))
}

/// Carries work out on the threads of this process; returns where no thread can be had.
///
/// # Errors
/// The system gives no threads.
pub fn on_threads<T: Send>(work: impl FnOnce() -> T + Send) -> Result<T, Failure> {
    Ok(threads(None)?.install(work))
}

/// Carries short work out without the interpreter.
///
/// # Errors
/// As [`on_threads`].
pub fn beside<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    py.detach(|| on_threads(work)).map_err(|failure| failure.raised(py))
}
