//! Progress bars on standard error: only on a terminal, only for work that lasts, never with `--quiet`.

use std::io::IsTerminal;
use std::sync::RwLock;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

impl flankwright::numerics::Progress for Bars {
    fn start(&self, stage: &str, total: u64) {
        Bars::start(self, stage, total);
    }

    fn advance(&self, n: u64) {
        Bars::advance(self, n);
    }

    fn finish(&self) {
        Bars::finish(self);
    }
}

/// Work shorter than this shows no bar.
const PATIENCE: Duration = Duration::from_millis(500);

/// The stages of a run as bars, one after the other. Can be advanced from any thread.
#[derive(Debug)]
pub struct Bars {
    visible: bool,
    begun: Instant,
    bar: RwLock<Option<ProgressBar>>,
}

impl Bars {
    /// Bars for a run that begins now.
    pub fn new(quiet: bool) -> Self {
        Self::with_visibility(!quiet && std::io::stderr().is_terminal())
    }

    fn with_visibility(visible: bool) -> Self {
        Self { visible, begun: Instant::now(), bar: RwLock::new(None) }
    }

    /// Begins a stage of `total` steps; a stage still open ends.
    pub fn start(&self, stage: &str, total: u64) {
        self.finish();
        if !self.visible {
            return;
        }
        let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template("{msg:<28} {wide_bar} {percent:>3} % {eta:>4}") {
            bar.set_style(style);
        }
        bar.set_message(stage.to_owned());
        self.show_when_due(&bar);
        if let Ok(mut place) = self.bar.write() {
            *place = Some(bar);
        }
    }

    /// `n` more steps are done.
    pub fn advance(&self, n: u64) {
        if let Ok(place) = self.bar.read()
            && let Some(bar) = place.as_ref()
        {
            self.show_when_due(bar);
            bar.inc(n);
        }
    }

    /// The stage is done; its bar goes.
    pub fn finish(&self) {
        if let Ok(mut place) = self.bar.write()
            && let Some(bar) = place.take()
        {
            bar.finish_and_clear();
        }
    }

    fn show_when_due(&self, bar: &ProgressBar) {
        if bar.is_hidden() && self.begun.elapsed() >= PATIENCE {
            bar.set_draw_target(ProgressDrawTarget::stderr());
        }
    }
}

impl Drop for Bars {
    fn drop(&mut self) {
        self.finish();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn position(bars: &Bars) -> Option<u64> {
        bars.bar.read().unwrap().as_ref().map(ProgressBar::position)
    }

    #[test]
    fn counts_from_many_threads_and_ends() {
        let bars = Bars::with_visibility(true);
        bars.start("rays", 400);
        std::thread::scope(|scope| {
            for _ in 0..4 {
                scope.spawn(|| (0..100).for_each(|_| bars.advance(1)));
            }
        });
        assert_eq!(position(&bars), Some(400));
        bars.finish();
        assert_eq!(position(&bars), None);
    }

    #[test]
    fn quiet_runs_have_no_bar() {
        let bars = Bars::new(true);
        bars.start("rays", 10);
        bars.advance(1);
        assert_eq!(position(&bars), None);
    }
}
