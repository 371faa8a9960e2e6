//! A computation that may be cancelled: its progress is asked for often, and where the user has cancelled, the stack is unwound from there to
//! where the computation was begun. No other code has to know.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicBool, Ordering};

use foundation::numerics::Progress;

/// What unwinds a cancelled computation; no hook of panics sees it.
struct Cancelled;

/// How a computation has ended.
pub enum Ended<T> {
    /// With a value.
    Done(T),
    /// The user has cancelled it.
    Cancelled,
    /// A fault of the program, in words.
    Failed(String),
}

/// Carries a computation out under a progress that ends it once `cancelled` is set.
pub fn run<T>(
    cancelled: &AtomicBool,
    told: &dyn Progress,
    work: impl FnOnce(&dyn Progress) -> T,
) -> Ended<T> {
    let progress = Cancelling { cancelled, told };
    match catch_unwind(AssertUnwindSafe(|| work(&progress))) {
        Ok(value) => Ended::Done(value),
        Err(payload) if payload.is::<Cancelled>() => Ended::Cancelled,
        Err(payload) => {
            let text = payload.downcast_ref::<&str>().map(|text| (*text).to_owned());
            let text = text.or_else(|| payload.downcast_ref::<String>().cloned());
            Ended::Failed(text.unwrap_or_else(|| "a fault without words".into()))
        }
    }
}

struct Cancelling<'a> {
    cancelled: &'a AtomicBool,
    told: &'a dyn Progress,
}

impl Cancelling<'_> {
    fn ask(&self) {
        if self.cancelled.load(Ordering::Relaxed) {
            resume_unwind(Box::new(Cancelled));
        }
    }
}

impl Progress for Cancelling<'_> {
    fn start(&self, stage: &str, total: u64) {
        self.ask();
        self.told.start(stage, total);
    }

    fn advance(&self, n: u64) {
        self.ask();
        self.told.advance(n);
    }

    fn finish(&self) {
        self.told.finish();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use foundation::numerics::Silent;

    #[test]
    fn a_cancelled_computation_ends_at_its_next_step() {
        let cancelled = AtomicBool::new(false);
        let ended = run(&cancelled, &Silent, |progress| {
            for k in 0..10 {
                progress.advance(1);
                if k == 3 {
                    cancelled.store(true, Ordering::Relaxed);
                }
            }
            unreachable!("it was cancelled")
        });
        assert!(matches!(ended, Ended::<()>::Cancelled));
    }
}
