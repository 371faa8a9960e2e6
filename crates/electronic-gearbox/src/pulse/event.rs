//! The same pulses without ticking every clock: between two reference pulses all others are known in closed form
//! (`docs/mathematics/gearbox.md#pulses-between-lines`, event form). Work is proportional to the pulses that go out.

use super::interval::Interval;
use super::{Direction, Pulse, PulseKind, Settings, Status, TimedPulse};
use crate::Error;

/// The event form. Pulses go to a sink in the order of their ticks, the same as those of
/// [`ClockedInterpolator`](super::ClockedInterpolator).
#[derive(Clone, Debug)]
pub struct EventInterpolator {
    settings: Settings,
    interval: Interval,
    /// Tick of the last reference pulse, 0 before it.
    base: u64,
    /// Tick up to which pulses have been sent.
    now: u64,
    /// Tick of the next intermediate pulse, if no correction is in the way and the interval still has one.
    next_intermediate: u64,
}

impl EventInterpolator {
    /// At rest, before the first reference pulse.
    pub const fn new(settings: Settings) -> Self {
        Self { settings, interval: Interval::START, base: 0, now: 0, next_intermediate: 0 }
    }

    /// Sends what falls before `tick`, then the reference pulse of this sign (+1 or -1) at it.
    ///
    /// # Errors
    /// [`Error::BadReferenceTrain`] for a tick that is not later than all before, or a sign that is neither +1 nor -1. Nothing has been
    /// sent then.
    pub fn reference(&mut self, tick: u64, sign: i64, mut sink: impl FnMut(TimedPulse)) -> Result<(), Error> {
        let refused = |fault| Error::BadReferenceTrain { index: self.interval.references, fault };
        let least = self.now.saturating_add(1);
        if tick < least {
            return Err(refused(crate::TrainFault::Tick { tick, least }));
        }
        let Some(direction) = Direction::from_sign(sign) else {
            return Err(refused(crate::TrainFault::Sign { sign }));
        };
        self.send_until(tick - 1, &mut sink);
        let limit = self.settings.counter_limit();
        // P is never 0, which not every compiler sees.
        let ticks = (tick - self.base).checked_div(u64::from(self.settings.pulses_per_interval()));
        let period = ticks.and_then(|ticks| u32::try_from(ticks).ok()).unwrap_or(limit).min(limit);
        self.interval.end(&self.settings, direction, period);
        self.base = tick;
        self.now = tick;
        self.next_intermediate = tick.saturating_add(u64::from(self.interval.spacing));
        sink(TimedPulse { tick, pulse: Pulse { direction, kind: PulseKind::Reference } });
        Ok(())
    }

    /// Time passes up to and including `tick` without a reference pulse; a tick of the past changes nothing.
    pub fn advance(&mut self, tick: u64, mut sink: impl FnMut(TimedPulse)) {
        self.send_until(tick, &mut sink);
    }

    /// Tick of the next pulse if no reference pulse comes before it; `None` if there is none.
    pub fn next_tick(&self) -> Option<u64> {
        if self.interval.pending != 0 {
            return self.now.checked_add(1);
        }
        self.intermediate_left().then_some(self.next_intermediate)
    }

    /// Counters and state as of the tick reached.
    pub const fn status(&self) -> Status {
        self.interval.status()
    }

    /// Tick up to which everything has been sent.
    pub const fn now(&self) -> u64 {
        self.now
    }

    /// The settings.
    pub const fn settings(&self) -> &Settings {
        &self.settings
    }

    #[inline]
    fn intermediate_left(&self) -> bool {
        self.interval.spacing > 0 && self.interval.inserted < self.settings.pulses_per_interval() - 1
    }

    fn send_until(&mut self, end: u64, sink: &mut impl FnMut(TimedPulse)) {
        if end <= self.now {
            return;
        }
        if let Some(direction) = self.interval.correction() {
            let pulse = Pulse { direction, kind: PulseKind::Correction };
            let count = self.interval.pending.unsigned_abs().min(end - self.now);
            for k in 1..=count {
                sink(TimedPulse { tick: self.now + k, pulse });
            }
            // As a magnitude no larger than `pending` it has the range of i64.
            self.interval.pending -= direction.sign() * (count as i64);
            self.now += count;
            // Intermediate pulses of the burst have merged into it.
            let spacing = u64::from(self.interval.spacing);
            if let Some(passed) = (self.now - self.base).checked_div(spacing) {
                self.next_intermediate = self.base.saturating_add((passed + 1).saturating_mul(spacing));
            }
        }
        if let Some(direction) = self.interval.direction {
            let pulse = Pulse { direction, kind: PulseKind::Intermediate };
            while self.intermediate_left() && self.next_intermediate <= end {
                sink(TimedPulse { tick: self.next_intermediate, pulse });
                self.interval.inserted += 1;
                self.next_intermediate =
                    self.next_intermediate.saturating_add(u64::from(self.interval.spacing));
            }
        }
        self.now = end;
    }
}
