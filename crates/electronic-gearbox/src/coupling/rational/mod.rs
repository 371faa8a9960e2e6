//! Ratios as fractions of 62 bits (`docs/mathematics/gearbox.md#couplings`). Rotations without end need the exact fraction, since any
//! rounded ratio drifts; a lead is irrational and belongs to an axis of finite travel, where the error of a fraction is known beforehand.
//!
//! A floating number has 53 bits. A fraction of it is exact or best for that number; it says nothing about digits beyond.

mod best;
mod binary;
mod dyadic;

pub use best::{BestRational, best_rational};
pub use dyadic::{Dyadic, dyadic};

use super::Ratio;
use crate::Error;

/// The ratio in lowest terms with a positive denominator.
fn reduced(numerator: i128, denominator: i128) -> Result<Ratio, Error> {
    let divisor = greatest_common_divisor(numerator.unsigned_abs(), denominator.unsigned_abs());
    // Neither trap nor overflow: the divisor of a denominator that is not 0 is at least 1 and at most 2^126.
    let divide = |value: u128| value.checked_div(divisor).unwrap_or(value);
    let (n, d) = (divide(numerator.unsigned_abs()), divide(denominator.unsigned_abs()));
    let negative = (numerator < 0) != (denominator < 0);
    let word = |name: &'static str, value: u128| {
        i64::try_from(value).map_err(|_| Error::GearRange { name, value: i64::MAX })
    };
    let n = word("numerator n", n)?;
    Ratio::new(if negative { -n } else { n }, word("denominator d", d)?)
}

/// Ratio of two rotations without end, z_1 N_w/(z_2 N_s), exactly and in lowest terms: counts of the workpiece a count of the tool.
/// Signs (internal gear, mounting) may stand at any factor.
///
/// # Errors
/// [`Error::GearRange`] for a factor of 0, and for a fraction beyond 2^62 after reduction.
pub fn endless_ratio(
    tool_starts: i64,
    workpiece_counts: i64,
    workpiece_teeth: i64,
    tool_counts: i64,
) -> Result<Ratio, Error> {
    for (name, value) in [
        ("starts of the tool", tool_starts),
        ("counts per revolution of the workpiece", workpiece_counts),
        ("teeth of the workpiece", workpiece_teeth),
        ("counts per revolution of the tool", tool_counts),
    ] {
        if value == 0 {
            return Err(Error::GearRange { name, value });
        }
    }
    reduced(
        i128::from(tool_starts) * i128::from(workpiece_counts),
        i128::from(workpiece_teeth) * i128::from(tool_counts),
    )
}

/// Error of the follower after a metre of a leading axis, in its counts: error of the ratio (counts a count) times the counts a metre of
/// the leading axis. What that is on the flank depends on the axes.
///
/// # Errors
/// [`Error::BadParameter`] unless both and their product are finite.
pub fn error_per_metre(ratio_error: f64, leading_counts_per_metre: f64) -> Result<f64, Error> {
    let error = ratio_error * leading_counts_per_metre;
    if error.is_finite() {
        return Ok(error);
    }
    let (name, value) = if ratio_error.is_finite() {
        ("counts per metre of the leading axis", leading_counts_per_metre)
    } else {
        ("error of a ratio", ratio_error)
    };
    Err(Error::BadParameter { name, value, allowed: "finite, and so the product" })
}

fn greatest_common_divisor(mut a: u128, mut b: u128) -> u128 {
    // Every two steps halve the greater number: at most 256.
    while let Some(rest) = a.checked_rem(b) {
        (a, b) = (b, rest);
    }
    a
}

#[cfg(test)]
mod tests;
