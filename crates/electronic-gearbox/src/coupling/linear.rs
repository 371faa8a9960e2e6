//! One leading axis with an exact ratio.

use super::Ratio;
use super::divisor::Quotient;
use crate::Error;

/// (n/d)(x - x_0).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LinearTerm {
    ratio: Ratio,
    zero: i64,
}

/// Greatest |x - x_0|, exclusive.
const TRAVEL: u64 = 1 << 62;

impl LinearTerm {
    /// `zero` is x_0 in counts of the leading axis.
    pub const fn new(ratio: Ratio, zero: i64) -> Self {
        Self { ratio, zero }
    }

    /// n/d.
    #[inline]
    pub const fn ratio(&self) -> &Ratio {
        &self.ratio
    }

    /// x_0.
    #[inline]
    pub const fn zero(&self) -> i64 {
        self.zero
    }

    /// floor((n/d)(x - x_0)) and the remainder in units of 1/d. Depends on x alone, not on how it was reached.
    #[inline]
    pub(super) fn at(&self, position: i64) -> Result<Quotient, Error> {
        let way = position.checked_sub(self.zero).filter(|way| way.unsigned_abs() < TRAVEL);
        let Some(way) = way else {
            return Err(Error::GearRange { name: "position x - x0 of a leading axis", value: position });
        };
        // Both below 2^62.
        self.divide(i128::from(self.ratio.numerator()) * i128::from(way), position)
    }

    #[inline]
    pub(super) fn divide(&self, product: i128, position: i64) -> Result<Quotient, Error> {
        match self.ratio.divisor.divide(product) {
            Some(quotient) => Ok(quotient),
            None => Err(Error::GearRange { name: "follower's way for a leading axis at", value: position }),
        }
    }
}
