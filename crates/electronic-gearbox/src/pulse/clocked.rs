//! The interpolator as the clocked machine it is built as: dividers, period counter, period memory, adjustment counter. One call a
//! tick, a fixed number of steps in each.

use super::interval::Interval;
use super::{Direction, Pulse, PulseKind, Settings, Status};

/// The clocked form. Every tick counts, compares and clears in the order of `docs/mathematics/gearbox.md#pulses-between-lines`, A to D.
#[derive(Clone, Debug)]
pub struct ClockedInterpolator {
    settings: Settings,
    /// Divider by P.
    divider: u32,
    /// Ticks of the running interval over P, saturating: a slide at rest must not wrap it, a small content would insert at once.
    period: u32,
    /// Divider by C.
    spacing: u32,
    interval: Interval,
}

impl ClockedInterpolator {
    /// At rest, before the first reference pulse.
    pub const fn new(settings: Settings) -> Self {
        Self { settings, divider: 0, period: 0, spacing: 0, interval: Interval::START }
    }

    /// One tick of the clock with the reference pulse that falls into it, if any; the pulse that goes out.
    #[inline]
    pub fn tick(&mut self, reference: Option<Direction>) -> Option<Pulse> {
        // A: divider by P and period counter.
        self.divider += 1;
        if self.divider == self.settings.pulses_per_interval() {
            self.divider = 0;
            self.period += u32::from(self.period < self.settings.counter_limit());
        }
        // B: divider by C. The comparison is >=, so that a smaller C can be loaded at any time.
        let mut due = false;
        if self.interval.spacing > 0 {
            self.spacing += 1;
            if self.spacing >= self.interval.spacing {
                self.spacing = 0;
                due = true;
            }
        }
        // C: latch and clear.
        if let Some(direction) = reference {
            self.interval.end(&self.settings, direction, self.period);
            self.divider = 0;
            self.period = 0;
            self.spacing = 0;
            return Some(Pulse { direction, kind: PulseKind::Reference });
        }
        // D: corrections go first. An intermediate pulse of the same tick merges into one and is not counted: the next reference pulse
        // makes up for it.
        if let Some(direction) = self.interval.correction() {
            self.interval.corrected(direction);
            return Some(Pulse { direction, kind: PulseKind::Correction });
        }
        let direction = self.interval.direction?;
        if due && self.interval.inserted < self.settings.pulses_per_interval() - 1 {
            self.interval.inserted += 1;
            return Some(Pulse { direction, kind: PulseKind::Intermediate });
        }
        None
    }

    /// Counters and state as of the last tick.
    pub const fn status(&self) -> Status {
        self.interval.status()
    }

    /// The settings.
    pub const fn settings(&self) -> &Settings {
        &self.settings
    }
}
