//! The nearest fraction with a bounded denominator, by continued fractions in integers.

use super::Ratio;
use super::binary::{Binary, out_of_range, power_of_two};
use crate::Error;

/// The fraction next to a number among all with denominators up to a limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BestRational {
    ratio: Ratio,
    error: f64,
}

impl BestRational {
    /// The fraction, in lowest terms.
    pub const fn ratio(&self) -> Ratio {
        self.ratio
    }

    /// Fraction minus number. It comes from integers, so that it has all its digits although the two are almost equal.
    pub const fn error(&self) -> f64 {
        self.error
    }
}

/// Divisions of the Euclidean algorithm on a mantissa below 2^53 and a power of two: Fibonacci numbers are the slowest case, the 79th
/// exceeds 2^53.
const MOST_DIVISIONS: usize = 80;

/// From 2^-126 on: 2^t and all products below stay within 127 bits. A number that needs more places is below 2^-73, and with
/// denominators up to 2^62 no fraction but 0 is near.
const MOST_PLACES: u32 = 126;

/// The fraction nearest to b with a denominator of at most `greatest_denominator`, by continued fractions with their intermediate
/// fractions. Of two equally near the one with the smaller denominator, and of two whole numbers the one nearer to 0.
///
/// # Errors
/// [`Error::BadParameter`] for a number that is not finite; [`Error::GearRange`] for a limit outside 1..=2^62, and for a fraction with a
/// numerator of 2^62 or more.
pub fn best_rational(b: f64, greatest_denominator: i64) -> Result<BestRational, Error> {
    if !(1..=1 << 62).contains(&greatest_denominator) {
        return Err(Error::GearRange { name: "greatest denominator", value: greatest_denominator });
    }
    let Binary { mantissa, exponent } = Binary::of(b)?;
    let sign = if b < 0.0 { -1 } else { 1 };
    if exponent >= 0 {
        // A whole number.
        let length = 64 - mantissa.leading_zeros() as i32 + exponent;
        if mantissa != 0 && length > 62 {
            return Err(out_of_range(b));
        }
        let whole = mantissa.checked_shl(exponent.unsigned_abs()).unwrap_or(0) as i64;
        return Ok(BestRational { ratio: Ratio::new(sign * whole, 1)?, error: 0.0 });
    }
    let places = exponent.unsigned_abs();
    if places > MOST_PLACES {
        return Ok(BestRational { ratio: Ratio::new(0, 1)?, error: -b });
    }
    let nearest =
        nearest_convergent(u128::from(mantissa), places, greatest_denominator.unsigned_abs().into());
    // Denominators go up to 2^62, numerators stay below 2^53, the mantissa.
    let ratio = Ratio::new(sign * nearest.numerator as i64, nearest.denominator as i64)?;
    let distance = nearest.remainder as f64 / nearest.denominator as f64 * power_of_two(places);
    let above = nearest.below == (sign < 0);
    Ok(BestRational { ratio, error: if above { distance } else { -distance } })
}

/// p/q with remainder = |mantissa q - p 2^places|, which is the error times q 2^places.
#[derive(Clone, Copy)]
struct Convergent {
    numerator: u128,
    denominator: u128,
    remainder: u128,
    /// Whether p/q is below the number, or equal.
    below: bool,
}

/// Walks along the convergents p_k/q_k. Their remainders are those of the Euclidean algorithm on mantissa and 2^places. They obey
/// remainder_(k-1) q_k + remainder_k q_(k-1) = 2^places, so that the products of the comparison stay below 2^127.
fn nearest_convergent(mantissa: u128, places: u32, most: u128) -> Convergent {
    let mut before = Convergent { numerator: 0, denominator: 1, remainder: mantissa, below: true };
    let mut last = Convergent { numerator: 1, denominator: 0, remainder: 1 << places, below: false };
    for _ in 0..MOST_DIVISIONS {
        let Some(term) = before.remainder.checked_div(last.remainder) else {
            // The last one is the number itself.
            return last;
        };
        // As many as fit. For the first, the whole part, the denominator stays 1.
        let fitting = (most - before.denominator).checked_div(last.denominator).unwrap_or(term).min(term);
        let next = Convergent {
            numerator: before.numerator + fitting * last.numerator,
            denominator: before.denominator + fitting * last.denominator,
            remainder: before.remainder - fitting * last.remainder,
            below: before.below,
        };
        if fitting < term {
            let nearer = next.remainder * last.denominator < last.remainder * next.denominator;
            return if nearer { next } else { last };
        }
        (before, last) = (last, next);
    }
    last
}
