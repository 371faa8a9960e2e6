//! Pulse by pulse: where the leading axis moves one count at a time and the ratio is at most one, the division is one comparison.

use super::Ratio;
use crate::Error;
use crate::pulse::Direction;

/// A ratio |n/d| <= 1 driven by single pulses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bresenham {
    denominator: i64,
    /// 0..d.
    remainder: i64,
    forward: Step,
    backward: Step,
}

/// What a pulse of one sense adds to the remainder: n, less d where it can carry, so that a negative sum always means "d back".
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Step {
    added: i64,
    /// 1 where it can carry, 0 where it can borrow.
    unit: i64,
}

impl Step {
    const fn new(numerator: i64, denominator: i64) -> Self {
        if numerator >= 0 {
            Self { added: numerator - denominator, unit: 1 }
        } else {
            Self { added: numerator, unit: 0 }
        }
    }
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
        let (forward, backward) = (Step::new(numerator, denominator), Step::new(-numerator, denominator));
        Ok(Self { denominator, remainder: 0, forward, backward })
    }

    /// One pulse of the leading axis; the follower's pulse, if floor((n/d) x) changes.
    #[inline]
    pub fn pulse(&mut self, direction: Direction) -> Option<Direction> {
        let Step { added, unit } = match direction {
            Direction::Forward => self.forward,
            Direction::Backward => self.backward,
        };
        // By the sign of the sum, without a branch: senses of pulses are not predictable.
        let sum = self.remainder + added;
        let negative = sum >> 63;
        self.remainder = sum + (self.denominator & negative);
        Direction::from_sign(unit + negative)
    }

    /// The rest in units of 1/d, 0..d.
    pub const fn remainder(&self) -> i64 {
        self.remainder
    }
}
