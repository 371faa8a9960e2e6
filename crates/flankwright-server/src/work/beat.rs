//! Tells the store from time to time that this server lives, so that its runs are not taken for those of a dead one, and hands in what the
//! store did not take before.

use std::sync::{Arc, PoisonError};
use std::time::Duration;

use flankwright_store::{RunEnd, StoreError};
use tokio::sync::watch;

use super::{Work, now};
use crate::log::say;

/// Between two beats.
const BEAT: Duration = Duration::from_secs(15);
/// A server that was silent for so long is gone: several beats, and the patience of a writer.
const SILENCE: Duration = Duration::from_secs(120);

/// Beats until the server ends.
pub async fn keep_beating(work: Arc<Work>, mut ending: watch::Receiver<bool>) {
    loop {
        tokio::select! {
            () = tokio::time::sleep(BEAT) => {}
            _ = ending.wait_for(|ending| *ending) => return,
        }
        if let Err(error) = work.beat(&[]).await {
            say(format!("the store does not hear that this server lives: {error}"));
        }
        work.settle().await;
    }
}

impl Work {
    /// Tells that this server lives and that others are gone.
    ///
    /// # Errors
    /// Those of the store.
    pub async fn beat(&self, gone: &[String]) -> Result<(), StoreError> {
        self.store.beat(self.scratch.owner(), gone, SILENCE, &now()).await.map(drop)
    }

    /// Keeps an end for later.
    pub(super) fn owe(&self, id: i64, end: RunEnd) {
        self.owed.lock().unwrap_or_else(PoisonError::into_inner).push((id, end));
    }

    /// Hands in what is owed.
    pub(super) async fn settle(&self) {
        let owed = std::mem::take(&mut *self.owed.lock().unwrap_or_else(PoisonError::into_inner));
        let mut refuses = false;
        for (id, end) in owed {
            // Each may wait long: where the first is refused, the others wait for the next beat.
            refuses = refuses || self.store.end_run(id, &end).await.is_err();
            if refuses {
                self.owe(id, end);
            } else {
                self.all().remove(&id);
            }
        }
    }
}
