//! A run that waits or is under way: how far it is, for everybody who listens, and whether it is to end. Who does not listen holds nothing
//! up: only the last word is kept.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use flankwright::numerics::Progress;
use flankwright_store::RunState;
use tokio::sync::watch;

use crate::wire::Advance;

/// What is known of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Told {
    /// Its state.
    pub state: RunState,
    /// How far it is.
    pub advance: Advance,
}

/// A run that has not ended.
#[derive(Debug)]
pub struct Live {
    cancelled: AtomicBool,
    interrupted: AtomicBool,
    done: AtomicU64,
    told: watch::Sender<Told>,
}

impl Default for Live {
    fn default() -> Self {
        let told = Told { state: RunState::Queued, advance: Advance::default() };
        Self {
            cancelled: AtomicBool::new(false),
            interrupted: AtomicBool::new(false),
            done: AtomicU64::new(0),
            told: watch::Sender::new(told),
        }
    }
}

/// Parts of a stage that are reported.
const PARTS: u64 = 100;

impl Live {
    /// Has it end at its next step.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// The same, because the server ends.
    pub fn interrupt(&self) {
        self.interrupted.store(true, Ordering::Relaxed);
        self.cancel();
    }

    /// The state of a run that was made to end.
    pub fn ended_as(&self) -> RunState {
        if self.interrupted.load(Ordering::Relaxed) { RunState::Interrupted } else { RunState::Cancelled }
    }

    /// Whether it is to end.
    pub fn cancelled(&self) -> &AtomicBool {
        &self.cancelled
    }

    /// The same, as it is now.
    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }

    /// What is known now.
    pub fn told(&self) -> Told {
        self.told.borrow().clone()
    }

    /// What is known, and everything that will be.
    pub fn listen(&self) -> watch::Receiver<Told> {
        self.told.subscribe()
    }

    /// It has begun.
    pub fn begin(&self) {
        self.told.send_modify(|told| told.state = RunState::Running);
    }

    /// It has ended.
    pub fn end(&self, state: RunState) {
        self.told.send_modify(|told| told.state = state);
    }
}

impl Progress for Live {
    fn start(&self, stage: &str, total: u64) {
        self.done.store(0, Ordering::Relaxed);
        self.told.send_modify(|told| told.advance = Advance { stage: stage.to_owned(), done: 0, total });
    }

    fn advance(&self, n: u64) {
        let done = self.done.fetch_add(n, Ordering::Relaxed) + n;
        self.told.send_if_modified(|told| {
            let total = told.advance.total.max(1);
            let moves = done.min(total) * PARTS / total > told.advance.done * PARTS / total;
            if moves {
                told.advance.done = done.min(total);
            }
            moves
        });
    }

    fn finish(&self) {
        self.told.send_modify(|told| told.advance.done = told.advance.total);
    }
}
