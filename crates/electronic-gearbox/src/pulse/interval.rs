//! What happens when a reference pulse ends an interval, the same for both forms: corrections owed, and the counters of the status.

use super::{Direction, Mode, Settings, Status};

/// State that lives as long as an interval and is settled at its end.
#[derive(Clone, Copy, Debug)]
pub(super) struct Interval {
    /// Its sense, `None` before the first reference pulse.
    pub direction: Option<Direction>,
    /// Intermediate pulses so far.
    pub inserted: u32,
    /// Corrections owed, signed.
    pub pending: i64,
    /// Distance of intermediate pulses in ticks, 0 for none.
    pub spacing: u32,
    pub references: u64,
    /// Of intervals that end with their own sense, and of those that end with the other one.
    pub overruns: [u64; 2],
    /// The same.
    pub too_fast: [u64; 2],
}

impl Interval {
    pub const START: Self = Self {
        direction: None,
        inserted: 0,
        pending: 0,
        spacing: 0,
        references: 0,
        overruns: [0; 2],
        too_fast: [0; 2],
    };

    /// A reference pulse arrives; `period` is the content of the period counter, floor(L/P) saturated.
    #[inline]
    pub fn end(&mut self, settings: &Settings, reference: Direction, period: u32) {
        if let Some(ended) = self.direction {
            let owed = correction(settings, ended, reference, self.inserted);
            // The slide came back to the line that it had passed: how long that took tells no speed.
            let reversal = usize::from(reference != ended);
            if self.pending != 0 && owed != 0 {
                self.overruns[reversal] = self.overruns[reversal].wrapping_add(1);
            }
            self.pending = self.pending.saturating_add(owed);
            self.spacing = period;
            if period == 0 {
                self.too_fast[reversal] = self.too_fast[reversal].wrapping_add(1);
            }
        }
        self.references = self.references.wrapping_add(1);
        self.direction = Some(reference);
        self.inserted = 0;
    }

    pub const fn status(&self) -> Status {
        Status {
            references: self.references,
            overruns: self.overruns[0],
            too_fast: self.too_fast[0],
            overruns_at_reversals: self.overruns[1],
            short_reversals: self.too_fast[1],
            pending: self.pending,
            inserted: self.inserted,
            spacing: self.spacing,
            direction: self.direction,
        }
    }

    /// Sense of the next correction; `None` if none is owed.
    #[inline]
    pub fn correction(&self) -> Option<Direction> {
        match self.pending {
            0 => None,
            1.. => Some(Direction::Forward),
            _ => Some(Direction::Backward),
        }
    }

    /// One correction in this sense has been sent.
    #[inline]
    pub fn corrected(&mut self, sense: Direction) {
        self.pending = self.pending.wrapping_sub(sense.sign());
    }
}

/// Signed number of corrections for an ended interval (`docs/mathematics/gearbox.md#pulses-between-lines`, table of modes).
#[inline]
fn correction(settings: &Settings, ended: Direction, reference: Direction, inserted: u32) -> i64 {
    let lacking = i64::from(settings.pulses_per_interval()) - 1 - i64::from(inserted);
    match settings.mode() {
        Mode::Literal => reference.sign() * lacking,
        Mode::NoBacklash if reference != ended => reference.sign() * i64::from(inserted),
        Mode::OneWay | Mode::NoBacklash => ended.sign() * lacking,
    }
}
