//! The threads of the work. A process that was forked has none of its parent's: it makes its own.

use std::mem::forget;
use std::process::id;
use std::sync::{Arc, Mutex, PoisonError};

use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};

/// The process that made the threads, and they.
static MADE: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// The threads of this process, `count` where they are made anew (0: as many as there are processors).
///
/// # Errors
/// The system gives no threads.
pub fn threads(count: Option<usize>) -> Result<Arc<ThreadPool>, ThreadPoolBuildError> {
    let mut made = MADE.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((by, there)) = made.as_ref()
        && *by == id()
        && count.is_none_or(|count| count == there.current_num_threads())
    {
        return Ok(there.clone());
    }
    let built = Arc::new(ThreadPoolBuilder::new().num_threads(count.unwrap_or(0)).build()?);
    if let Some((by, there)) = made.replace((id(), built.clone()))
        && by != id()
    {
        // Nobody is there to answer a farewell.
        forget(there);
    }
    Ok(built)
}

/// Carries work out on the threads of this process; returns where no thread can be had.
///
/// # Errors
/// The system gives no threads.
pub fn on_threads<T: Send>(work: impl FnOnce() -> T + Send) -> Result<T, ThreadPoolBuildError> {
    Ok(threads(None)?.install(work))
}
