//! Work that takes a moment: a few pieces at once, the others wait their turn. What asks its progress ends when no client waits for it any
//! more.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use flankwright::exchange::Source;
use flankwright::numerics::{Progress, Silent};
use flankwright::workflow::cancel::{self, Ended};

use super::error::{Answer, Refused};
use crate::app::App;
use crate::shelf::{JOB, Shelf};
use crate::wire::{Failure, Job, unshelved};

/// Somebody waits as long as this is not dropped.
struct Waiting(Arc<AtomicBool>);

impl Drop for Waiting {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

/// Computes what takes a moment. With the progress that it is given it ends at its next step once the client is gone or the time is over.
pub(super) async fn short<T: Send + 'static>(
    app: &App,
    work: impl FnOnce(&dyn Progress) -> Answer<T> + Send + 'static,
) -> Answer<T> {
    let Ok(room) = app.short.clone().acquire_owned().await else {
        return Err(Refused::busy("there is no room for short work"));
    };
    let waiting = Waiting(Arc::default());
    let (gone, threads) = (waiting.0.clone(), app.threads.clone());
    let done = tokio::task::spawn_blocking(move || {
        // The room is free only when the work is done, though nobody may wait for it.
        let _room = room;
        match threads.install(|| cancel::run(&gone, &Silent, work)) {
            Ended::Done(answer) => answer,
            Ended::Cancelled => Err(Refused::busy("no client waits for the answer")),
            Ended::Failed(words) => Err(Refused::bad(Failure::internal(words))),
        }
    });
    done.await.unwrap_or_else(|fault| Err(Refused::bad(Failure::internal(fault.to_string()))))
}

/// A shelf with the files of a job.
pub(super) fn shelved(app: &App, job: &Job) -> Answer<Shelf> {
    Shelf::of_job(&app.scratch, &job.text, &job.files).map_err(|error| Refused::bad(unshelved(&error)))
}

/// Whether a job can be taken in: its size, and the names of its files.
pub(super) fn fit(job: &Job) -> Answer<()> {
    Source::from_bytes(JOB, job.text.as_bytes()).map_err(|error| Refused::bad(Failure::of_text(&error)))?;
    crate::shelf::fit(&job.files).map_err(|error| Refused::bad(unshelved(&error)))
}
