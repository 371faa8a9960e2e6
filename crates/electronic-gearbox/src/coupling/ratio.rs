//! An exact ratio of counts.

use super::divisor::Divisor;
use crate::Error;

/// n/d with |n| < 2^62 and 0 < d <= 2^62.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ratio {
    numerator: i64,
    pub(super) divisor: Divisor,
}

impl Ratio {
    /// Any fraction within the limits; it need not be in lowest terms.
    ///
    /// # Errors
    /// [`Error::GearRange`] for a numerator or denominator beyond its limit.
    pub const fn new(numerator: i64, denominator: i64) -> Result<Self, Error> {
        if numerator.unsigned_abs() >= 1 << 62 {
            return Err(Error::GearRange { name: "numerator n", value: numerator });
        }
        match Divisor::new(denominator) {
            Some(divisor) => Ok(Self { numerator, divisor }),
            None => Err(Error::GearRange { name: "denominator d", value: denominator }),
        }
    }

    /// n.
    #[inline]
    pub const fn numerator(&self) -> i64 {
        self.numerator
    }

    /// d.
    #[inline]
    pub const fn denominator(&self) -> i64 {
        // At most 2^62.
        self.divisor.value() as i64
    }

    /// n/d as a floating number, for speeds; positions never use it.
    pub const fn as_f64(&self) -> f64 {
        self.numerator as f64 / self.denominator() as f64
    }
}
