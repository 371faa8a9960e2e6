//! The chain behind the interpolator: multipliers of both lines, hand switch, split.

use super::{Multiplier, RateRule, Split, SplitRotation};
use crate::pulse::Direction;
use crate::{Error, Sign};

/// The additional rotation as counted. Each line has a multiplier with a counter of its own, so that the error of a slide that goes to
/// and fro stays below twice the deviation of one multiplier for ever.
#[derive(Clone, Copy, Debug)]
pub struct AdditionalRotation {
    forward: Multiplier,
    backward: Multiplier,
    hand: Sign,
    split: Split,
    total: i64,
}

impl AdditionalRotation {
    /// At 0, with coefficient B = `word` and P = `parts` to a workpiece pulse. The hand switch is `Plus` where the forward line turns the
    /// workpiece forward; with `Minus` the lines change places.
    ///
    /// # Errors
    /// As [`Multiplier::new`] and [`Split::new`].
    pub fn new(word: u32, rule: RateRule, hand: Sign, parts: u32) -> Result<Self, Error> {
        let line = Multiplier::new(word, rule)?;
        Ok(Self { forward: line, backward: line, hand, split: Split::new(parts)?, total: 0 })
    }

    /// One pulse of the interpolator; the sense in which it turns the workpiece, or `None` if it does not pass.
    #[inline]
    pub fn pulse(&mut self, direction: Direction) -> Option<Direction> {
        let passes = match direction {
            Direction::Forward => self.forward.pulse(),
            Direction::Backward => self.backward.pulse(),
        };
        if !passes {
            return None;
        }
        let turned = match self.hand {
            Sign::Plus => direction,
            Sign::Minus => direction.reversed(),
        };
        self.total = self.total.wrapping_add(turned.sign());
        self.split.pulse(turned);
        Some(turned)
    }

    /// Signed sum W of the pulses that passed.
    #[inline]
    pub const fn total(&self) -> i64 {
        self.total
    }

    /// The same as whole workpiece pulses and their rest.
    #[inline]
    pub const fn position(&self) -> SplitRotation {
        self.split.position()
    }
}
