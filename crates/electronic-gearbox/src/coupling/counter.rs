//! Counters of limited width wrap; their difference tells the way as long as it is less than half their range.

use crate::Error;

/// Reads a counter of 2 to 64 bits and adds up its ways.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WrappingCounter {
    bits: u32,
    /// Greatest way between two readings.
    largest_step: i64,
    last: u64,
}

impl WrappingCounter {
    /// A counter of this width that reads `first` now; between two readings it moves by less than half its range.
    ///
    /// # Errors
    /// [`Error::BadParameter`] for a width outside 2..=64.
    pub fn new(bits: u32, first: u64) -> Result<Self, Error> {
        if !(2..=64).contains(&bits) {
            let (value, allowed) = (f64::from(bits), "2 to 64 bits");
            return Err(Error::BadParameter { name: "width of the counter", value, allowed });
        }
        Ok(Self { bits, largest_step: i64::MAX >> (64 - bits), last: first })
    }

    /// Refuses more than `step` counts between two readings: what the greatest speed of the axis admits tells a lost counter long before
    /// half the range does.
    pub fn with_largest_step(self, step: u32) -> Self {
        Self { largest_step: self.largest_step.min(i64::from(step)), ..self }
    }

    /// Reads the counter; the signed way since the reading before.
    ///
    /// # Errors
    /// [`Error::EncoderJump`] for a way of half the range or beyond the largest step. The counter is taken as it is, the next reading
    /// starts from there.
    #[inline]
    pub fn read(&mut self, value: u64) -> Result<i64, Error> {
        let unused = 64 - self.bits;
        let difference = (value.wrapping_sub(self.last) << unused) as i64 >> unused;
        self.last = value;
        if difference.unsigned_abs() > self.largest_step.unsigned_abs() {
            return Err(Error::EncoderJump { difference, bits: self.bits });
        }
        Ok(difference)
    }
}
