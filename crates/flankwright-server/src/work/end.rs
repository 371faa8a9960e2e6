//! How the end of a run comes into the store, also where that refuses for a while.

use std::time::Duration;

use flankwright_store::{RunEnd, RunState, StoreError};

use super::live::Live;
use super::{Work, ended};
use crate::log::say;
use crate::wire::Failure;

/// After so long an end is reported again.
const AGAIN: [Duration; 3] = [Duration::from_secs(1), Duration::from_secs(3), Duration::from_secs(10)];

/// The end of a run whose store has refused.
pub(super) fn refused(error: &StoreError) -> RunEnd {
    failed(&Failure::store(error))
}

/// The end of a run that has no result.
pub(super) fn failed(failure: &Failure) -> RunEnd {
    RunEnd { document: serde_json::to_value(failure).ok(), ..ended(RunState::Failed) }
}

impl Work {
    /// Ends a run. Where the store does not take its result, it takes the reason; where it takes nothing, that is reported again with the
    /// next beat.
    pub(super) async fn end_run(&self, id: i64, live: &Live, end: RunEnd) {
        let mut told = self.store.end_run(id, &end).await;
        for pause in AGAIN {
            if told.is_ok() || self.is_ending() {
                break;
            }
            tokio::time::sleep(pause).await;
            told = self.store.end_run(id, &end).await;
        }
        let state = match told {
            Ok(true) => end.state,
            // Somebody else has ended it, or taken it out.
            Ok(false) => {
                let run = self.store.run_summary(id).await.ok().flatten();
                run.map_or(RunState::Interrupted, |run| run.state)
            }
            Err(error) => {
                say(format!("run {id}: the store refuses its end: {error}"));
                // It stays among the living ones, so that its state is not asked of the store, which knows of no end yet.
                self.owe(id, refused(&error));
                live.end(RunState::Failed);
                self.settle().await;
                return;
            }
        };
        self.all().remove(&id);
        live.end(state);
    }
}
