//! Whole workpiece pulses and their rest: what counter and converter show of the additional rotation.

use crate::Error;
use crate::pulse::Direction;
use core::sync::atomic::{AtomicU32, Ordering};

/// Position in whole workpiece pulses and parts 1/P of one. coarse P + fine is the number of interpolated pulses, always.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SplitRotation {
    /// Whole workpiece pulses, rounded down.
    pub coarse: i64,
    /// Rest, 0..P; as an analogue value it is fine/P of one workpiece pulse.
    pub fine: u32,
}

/// Counter modulo P that sends a coarse pulse whenever it wraps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Split {
    parts: u32,
    position: SplitRotation,
}

impl Split {
    /// At 0, with P = `parts` to a workpiece pulse.
    ///
    /// # Errors
    /// [`Error::PulsesPerInterval`] for P outside 2..=256.
    pub fn new(parts: u32) -> Result<Self, Error> {
        if !(2..=256).contains(&parts) {
            return Err(Error::PulsesPerInterval { value: parts });
        }
        Ok(Self { parts, position: SplitRotation::default() })
    }

    /// One pulse; the coarse pulse that it sends, if any.
    #[inline]
    pub fn pulse(&mut self, direction: Direction) -> Option<Direction> {
        let SplitRotation { coarse, fine } = &mut self.position;
        let wraps = match direction {
            Direction::Forward => *fine + 1 == self.parts,
            Direction::Backward => *fine == 0,
        };
        match (direction, wraps) {
            (Direction::Forward, false) => *fine += 1,
            (Direction::Backward, false) => *fine -= 1,
            (Direction::Forward, true) => *fine = 0,
            (Direction::Backward, true) => *fine = self.parts - 1,
        }
        if !wraps {
            return None;
        }
        *coarse = coarse.wrapping_add(direction.sign());
        Some(direction)
    }

    /// Where it stands.
    #[inline]
    pub const fn position(&self) -> SplitRotation {
        self.position
    }

    /// P.
    #[inline]
    pub const fn parts(&self) -> u32 {
        self.parts
    }
}

/// Both halves of a position for a reader in another context. Read apart they would be wrong by one whole workpiece pulse at the wrap;
/// here they are one word of 32 bits, which every target writes and reads at once: 24 bits of coarse, modulo 2^24, and 8 of fine.
#[derive(Debug, Default)]
pub struct SharedRotation(AtomicU32);

impl SharedRotation {
    /// At 0.
    pub const fn new() -> Self {
        Self(AtomicU32::new(0))
    }

    /// Publishes a position.
    #[inline]
    pub fn publish(&self, position: SplitRotation) {
        // P is at most 256, so fine has 8 bits; of coarse the low 24 are kept on purpose.
        let coarse = (position.coarse & 0xff_ffff) as u32;
        self.0.store(coarse << 8 | (position.fine & 0xff), Ordering::Release);
    }

    /// The position published last, on the turn of the 24-bit counter that is nearest to `near` (the coarse position read before).
    #[inline]
    pub fn read(&self, near: i64) -> SplitRotation {
        let word = self.0.load(Ordering::Acquire);
        // Difference modulo 2^24, signed.
        let step = ((word >> 8).wrapping_sub((near & 0xff_ffff) as u32) << 8) as i32 >> 8;
        SplitRotation { coarse: near.wrapping_add(i64::from(step)), fine: word & 0xff }
    }
}
