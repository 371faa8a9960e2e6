//! Ratios over a power of two: cheap to divide by, and next to any number within half a unit of their last place.

use super::Ratio;
use super::binary::{Binary, out_of_range, power_of_two};
use crate::Error;

/// n/2^shift next to a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dyadic {
    numerator: i64,
    shift: u32,
    ratio: Ratio,
}

impl Dyadic {
    /// n.
    pub const fn numerator(&self) -> i64 {
        self.numerator
    }

    /// s.
    pub const fn shift(&self) -> u32 {
        self.shift
    }

    /// Greatest error against the number that it stands for: 2^-(s+1).
    pub fn error_bound(&self) -> f64 {
        power_of_two(self.shift + 1)
    }

    /// The same in lowest terms.
    pub const fn ratio(&self) -> Ratio {
        self.ratio
    }
}

/// n = b 2^s rounded half to even with s = 61 - bitlen(floor|b|), from the bits of b, without a floating rounding.
///
/// # Errors
/// [`Error::BadParameter`] for a number that is not finite, [`Error::GearRange`] from |b| = 2^61 on.
pub fn dyadic(b: f64) -> Result<Dyadic, Error> {
    let Binary { mantissa, exponent } = Binary::of(b)?;
    // Length of the whole part: that of the mantissa, moved by the exponent.
    let length = if mantissa == 0 { 0 } else { (64 - mantissa.leading_zeros() as i32 + exponent).max(0) };
    let Some(shift) = 61u32.checked_sub(length.unsigned_abs()) else {
        return Err(out_of_range(b));
    };
    let move_up = exponent + shift as i32;
    let magnitude = if move_up >= 0 {
        // b 2^s < 2^61: nothing is lost.
        mantissa.checked_shl(move_up.unsigned_abs()).unwrap_or(0)
    } else {
        halves_to_even(mantissa, move_up.unsigned_abs())
    };
    let magnitude = magnitude as i64;
    let numerator = if b < 0.0 { -magnitude } else { magnitude };
    let halvings = numerator.trailing_zeros().min(shift);
    Ok(Dyadic { numerator, shift, ratio: Ratio::new(numerator >> halvings, 1 << (shift - halvings))? })
}

/// mantissa/2^places, rounded half to even, for a mantissa of 53 bits.
fn halves_to_even(mantissa: u64, places: u32) -> u64 {
    match places {
        0 => mantissa,
        1..=53 => {
            let whole = mantissa >> places;
            let rest = mantissa & ((1 << places) - 1);
            let half = 1 << (places - 1);
            whole + u64::from(rest > half || (rest == half && whole & 1 == 1))
        }
        // Below a half.
        _ => 0,
    }
}
