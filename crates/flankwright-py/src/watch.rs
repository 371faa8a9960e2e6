//! Long computations under Python: they run beside the interpreter, tell how far they are, and end when the user presses Ctrl-C.

use std::panic::resume_unwind;
use std::sync::Mutex;
use std::sync::PoisonError;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use flankwright::numerics::Progress;
use flankwright::workflow::cancel::{self, Ended};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::failure::Failure;
use crate::pool::on_threads;

/// How often the interpreter is asked whether to go on, and how often it is sent the progress.
const BREATH: Duration = Duration::from_millis(50);

/// How far a computation is.
#[derive(Default)]
struct Told {
    stage: String,
    done: u64,
    total: u64,
}

/// Keeps the last word for the interpreter: no thread of the work waits for it.
#[derive(Default)]
struct Kept(Mutex<Told>);

impl Kept {
    fn with<T>(&self, change: impl FnOnce(&mut Told) -> T) -> T {
        change(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

impl Progress for Kept {
    fn start(&self, stage: &str, total: u64) {
        self.with(|told| *told = Told { stage: stage.to_owned(), done: 0, total });
    }

    fn advance(&self, n: u64) {
        self.with(|told| told.done += n);
    }

    fn finish(&self) {
        self.with(|told| told.done = told.total);
    }
}

/// Carries work out without the interpreter. `listener` is called with stage, steps done and steps of it, now and then.
///
/// # Errors
/// What the listener raises; Ctrl-C; a fault of the program.
pub fn watched<T: Send>(
    py: Python<'_>,
    listener: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&dyn Progress) -> T + Send,
) -> PyResult<T> {
    let (cancelled, kept) = (AtomicBool::new(false), Kept::default());
    let listener = listener.map(|listener| listener.clone().unbind());
    let asked = |py: Python<'_>| -> PyResult<()> {
        py.check_signals()?;
        if let Some(listener) = &listener {
            let (stage, done, total) = kept.with(|told| (told.stage.clone(), told.done, told.total));
            if !stage.is_empty() {
                listener.call1(py, (stage, done, total))?;
            }
        }
        Ok(())
    };
    let (ended, refused) = py.detach(|| {
        thread::scope(|scope| {
            let (tell, heard) = channel();
            let (cancelled, kept) = (&cancelled, &kept);
            scope.spawn(move || drop(tell.send(on_threads(|| cancel::run(cancelled, kept, work)))));
            let mut refused = None;
            loop {
                match heard.recv_timeout(BREATH) {
                    Ok(ended) => return (ended, refused),
                    Err(RecvTimeoutError::Timeout) if refused.is_none() => {
                        if let Err(error) = Python::attach(asked) {
                            cancelled.store(true, Ordering::Relaxed);
                            refused = Some(error);
                        }
                    }
                    Err(RecvTimeoutError::Timeout) => {}
                    Err(RecvTimeoutError::Disconnected) => resume_unwind(Box::new("the work is gone")),
                }
            }
        })
    });
    if let Some(error) = refused {
        return Err(error);
    }
    match ended.map_err(|error| Failure::from(&error).raised(py))? {
        Ended::Done(value) => Ok(value),
        Ended::Cancelled => Err(PyKeyboardInterrupt::new_err(())),
        Ended::Failed(words) => Err(Failure::internal(words).raised(py)),
    }
}

/// Works on every item, on all cores; what they give, in their order. The work can be ended between any two of them.
///
/// # Errors
/// As [`watched`].
pub fn on_each<I: Sync, T: Send>(
    py: Python<'_>,
    listener: Option<&Bound<'_, PyAny>>,
    stage: &str,
    items: &[I],
    work: impl Fn(usize, &I) -> T + Sync + Send,
) -> PyResult<Vec<T>> {
    watched(py, listener, |progress| {
        progress.start(stage, items.len() as u64);
        let one = |(k, item): (usize, &I)| {
            // Asks as well whether to go on.
            progress.advance(0);
            let done = work(k, item);
            progress.advance(1);
            done
        };
        let done = items.par_iter().enumerate().map(one).collect();
        progress.finish();
        done
    })
}
