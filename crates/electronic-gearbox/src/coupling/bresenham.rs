//! Pulse by pulse: where the leading axis moves one count at a time and the ratio is at most one, the division is one comparison.

use super::Ratio;
use crate::Error;
use crate::pulse::Direction;

/// A ratio |n/d| <= 1 driven by single pulses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bresenham {
    /// |n|.
    step: i64,
    denominator: i64,
    /// 0..d.
    remainder: i64,
    crossed: bool,
}

impl Bresenham {
    /// Starts with remainder 0, as floor((n/d) x) does at x = 0.
    ///
    /// # Errors
    /// [`Error::GearRange`] for |n| > d.
    pub const fn new(ratio: Ratio) -> Result<Self, Error> {
        let (step, denominator) = (ratio.numerator().abs(), ratio.denominator());
        if step > denominator {
            return Err(Error::GearRange {
                name: "numerator n of a ratio up to 1",
                value: ratio.numerator(),
            });
        }
        Ok(Self { step, denominator, remainder: 0, crossed: ratio.numerator() < 0 })
    }

    /// One pulse of the leading axis; the follower's pulse, if floor((n/d) x) changes.
    #[inline]
    pub fn pulse(&mut self, direction: Direction) -> Option<Direction> {
        let turned = if self.crossed { direction.reversed() } else { direction };
        let sum = match turned {
            Direction::Forward => self.remainder + self.step,
            Direction::Backward => self.remainder - self.step,
        };
        let carried = match turned {
            Direction::Forward => sum >= self.denominator,
            Direction::Backward => sum < 0,
        };
        self.remainder = if carried { sum - turned.sign() * self.denominator } else { sum };
        carried.then_some(turned)
    }

    /// The rest in units of 1/d, 0..d.
    pub const fn remainder(&self) -> i64 {
        self.remainder
    }
}
