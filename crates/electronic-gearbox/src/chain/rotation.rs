//! The chain behind the interpolator: multipliers of both lines, hand switch, split.

use super::{Multiplier, RateRule, Split, SplitRotation};
use crate::Error;
use crate::pulse::Direction;

/// Position of the hand switch: which line turns the workpiece forward.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Hand {
    /// The forward line turns forward (h = +1).
    #[default]
    Direct,
    /// The lines change places (h = -1).
    Crossed,
}

/// The additional rotation as counted. Each line has a multiplier with a counter of its own, so that the error of a slide that goes to
/// and fro stays below twice the deviation of one multiplier for ever.
#[derive(Clone, Copy, Debug)]
pub struct AdditionalRotation {
    forward: Multiplier,
    backward: Multiplier,
    hand: Hand,
    split: Split,
    total: i64,
}

impl AdditionalRotation {
    /// At 0, with coefficient B = `word` and P = `parts` to a workpiece pulse.
    ///
    /// # Errors
    /// As [`Multiplier::new`] and [`Split::new`].
    pub fn new(word: u32, rule: RateRule, hand: Hand, parts: u32) -> Result<Self, Error> {
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
            Hand::Direct => direction,
            Hand::Crossed => direction.reversed(),
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
