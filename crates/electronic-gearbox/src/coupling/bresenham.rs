//! Pulse by pulse: where the leading axis moves one count at a time and the ratio is at most one, the division is one comparison.

use super::Ratio;
use crate::Error;
use crate::pulse::Direction;

/// A ratio |n/d| <= 1 driven by single pulses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bresenham {
    numerator: i64,
    denominator: i64,
    /// 0..d.
    remainder: i64,
}

impl Bresenham {
    /// Starts with remainder 0, as floor((n/d) x) does at x = 0.
    ///
    /// # Errors
    /// [`Error::GearRange`] for |n| > d.
    pub const fn new(ratio: Ratio) -> Result<Self, Error> {
        let (numerator, denominator) = (ratio.numerator(), ratio.denominator());
        if numerator.abs() > denominator {
            return Err(Error::GearRange { name: "numerator n of a ratio up to 1", value: numerator });
        }
        Ok(Self { numerator, denominator, remainder: 0 })
    }

    /// One pulse of the leading axis; the follower's pulse, if floor((n/d) x) changes.
    #[inline]
    pub fn pulse(&mut self, direction: Direction) -> Option<Direction> {
        let sum = match direction {
            Direction::Forward => self.remainder + self.numerator,
            Direction::Backward => self.remainder - self.numerator,
        };
        // Both outcomes are at hand before the comparison, so that it becomes a selection: senses of pulses are not predictable.
        let (above, below) = (sum - self.denominator, sum.wrapping_add(self.denominator));
        let inside = if sum < 0 { below } else { sum };
        self.remainder = if above >= 0 { above } else { inside };
        if above >= 0 { Some(Direction::Forward) } else { (sum < 0).then_some(Direction::Backward) }
    }

    /// The rest in units of 1/d, 0..d.
    pub const fn remainder(&self) -> i64 {
        self.remainder
    }
}
