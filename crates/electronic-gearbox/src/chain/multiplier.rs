//! Passing the share B/2^18 of a pulse train, by bits as a binary rate multiplier does or by carry as Bresenham's line does.

use crate::Error;

/// Bits of the coefficient.
const BITS: u32 = 18;
const RANGE: u32 = 1 << BITS;

/// Which pulses pass.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum RateRule {
    /// Pulse n passes if bit 17 - t of B is set, t being the trailing zeros of n. Up to 3.39 pulses off the straight line.
    Binary,
    /// Pulse n passes if floor(n B/2^18) grows. Less than one pulse off the straight line, and one addition. The recommended rule.
    #[default]
    Bresenham,
}

/// A rate multiplier of 18 bits for one line. Any 2^18 consecutive pulses of its input give exactly B.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Multiplier {
    word: u32,
    rule: RateRule,
    /// Pulses seen, or the sum of B, modulo 2^18.
    count: u32,
}

impl Multiplier {
    /// With coefficient `word` = B, 0..2^18.
    ///
    /// # Errors
    /// [`Error::BadParameter`] for a B of 2^18 or more.
    pub fn new(word: u32, rule: RateRule) -> Result<Self, Error> {
        if word >= RANGE {
            let allowed = "0 to 2^18 - 1";
            return Err(Error::BadParameter { name: "B", value: f64::from(word), allowed });
        }
        Ok(Self { word, rule, count: 0 })
    }

    /// One pulse arrives; whether it passes.
    #[inline]
    pub fn pulse(&mut self) -> bool {
        match self.rule {
            RateRule::Binary => {
                self.count = (self.count + 1) & (RANGE - 1);
                // Of 2^18 there are 18 trailing zeros and more: blocked.
                let zeros = self.count.trailing_zeros();
                zeros < BITS && (self.word << zeros) & (RANGE >> 1) != 0
            }
            RateRule::Bresenham => {
                let sum = self.count + self.word;
                self.count = sum & (RANGE - 1);
                sum >= RANGE
            }
        }
    }
}

/// How many of the first `pulses` pulses a multiplier passes, without running it.
///
/// # Errors
/// As [`Multiplier::new`].
pub fn passed_pulses(word: u32, rule: RateRule, pulses: u64) -> Result<u64, Error> {
    Multiplier::new(word, rule)?;
    let passed: u128 = match rule {
        RateRule::Binary => (0..BITS)
            .filter(|zeros| word >> (BITS - 1 - zeros) & 1 == 1)
            .map(|zeros| (u128::from(pulses) + (1 << zeros)) >> (zeros + 1))
            .sum(),
        RateRule::Bresenham => (u128::from(pulses) * u128::from(word)) >> BITS,
    };
    // At most one pulse passes for each that arrives.
    Ok(u64::try_from(passed).unwrap_or(pulses))
}
