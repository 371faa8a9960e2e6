//! The pulse interpolator: between two pulses of a slide's scale it inserts P - 1 further ones, at the pace of the interval before
//! (`docs/mathematics/gearbox.md#pulses-between-lines`). [`ClockedInterpolator`] is the machine as built, one call a clock tick;
//! [`EventInterpolator`] gives the same pulses in time proportional to their number. The rules that both obey stand in [`Mode`] and
//! `interval`.

mod clocked;
mod event;
mod interval;
mod settings;

pub use clocked::ClockedInterpolator;
pub use event::EventInterpolator;
pub use settings::{Mode, Settings};

/// Sense of a pulse: which of the two lines carries it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Direction {
    /// Towards larger positions.
    Forward,
    /// Towards smaller positions.
    Backward,
}

impl Direction {
    /// +1 or -1.
    #[inline]
    pub const fn sign(self) -> i64 {
        match self {
            Self::Forward => 1,
            Self::Backward => -1,
        }
    }

    /// The direction of a sign; `None` for anything but +1 and -1.
    pub const fn from_sign(sign: i64) -> Option<Self> {
        match sign {
            1 => Some(Self::Forward),
            -1 => Some(Self::Backward),
            _ => None,
        }
    }

    /// The other one.
    #[inline]
    pub const fn reversed(self) -> Self {
        match self {
            Self::Forward => Self::Backward,
            Self::Backward => Self::Forward,
        }
    }
}

/// Where a pulse comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PulseKind {
    /// The scale itself (R).
    Reference,
    /// Inserted at the spacing of the interval before (Z).
    Intermediate,
    /// Inserted at the clock's pace for one that the interval before lacked (K).
    Correction,
}

/// One pulse on one of the two lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Pulse {
    /// Its line.
    pub direction: Direction,
    /// Its origin.
    pub kind: PulseKind,
}

/// A pulse with the clock tick that it falls into, counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct TimedPulse {
    /// Clock tick.
    pub tick: u64,
    /// The pulse.
    pub pulse: Pulse,
}

/// What the machine shows of itself.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Status {
    /// Reference pulses seen.
    pub references: u64,
    /// Intervals that ended, with their own sense, while corrections of the one before were still owed. The supervising program stops the
    /// feed when it grows.
    pub overruns: u64,
    /// Intervals of one sense shorter than P ticks: the slide is faster than v_max = f1 p/P. The supervising program stops the feed when it
    /// grows.
    pub too_fast: u64,
    /// Intervals that ended with the other sense while corrections of the one before were still owed. No alarm: a slide that turns on a
    /// line brings them at any speed.
    pub overruns_at_reversals: u64,
    /// Intervals shorter than P ticks that ended with the other sense. No alarm: the slide came back to the line that it had passed, which
    /// tells no speed. One that is too fast before or behind it counts in `too_fast`.
    pub short_reversals: u64,
    /// Corrections still to be sent, with their sign.
    pub pending: i64,
    /// Intermediate pulses of the running interval.
    pub inserted: u32,
    /// Distance C of intermediate pulses in ticks; 0 while no interval has been measured, or the last was too short.
    pub spacing: u32,
    /// Sense of the running interval; `None` before the first reference pulse.
    pub direction: Option<Direction>,
}
