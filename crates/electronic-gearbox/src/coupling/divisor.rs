//! Division by a divisor known beforehand, in a fixed number of instructions: two multiplications instead of the library routine for 128
//! bits, whose loops depend on the data. The reciprocal and the step are those of Moeller and Granlund, "Improved division by invariant
//! integers", IEEE Trans. Computers 60 (2011).

/// A divisor d, 0 < d <= 2^62, with its reciprocal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Divisor {
    /// d shifted left until its highest bit is set.
    normalised: u64,
    /// floor((2^128 - 1)/normalised) - 2^64.
    reciprocal: u64,
    shift: u32,
}

/// Floor quotient and remainder, 0 <= remainder < d.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Quotient {
    pub quotient: i64,
    pub remainder: u64,
}

impl Divisor {
    /// `None` unless 0 < d <= 2^62.
    pub const fn new(d: i64) -> Option<Self> {
        if d <= 0 || d > 1 << 62 {
            return None;
        }
        let shift = d.leading_zeros();
        let normalised = (d as u64) << shift;
        // At construction only; the low word of the quotient is the reciprocal, its high word is 1.
        match u128::MAX.checked_div(normalised as u128) {
            Some(quotient) => Some(Self { normalised, reciprocal: quotient as u64, shift }),
            None => None,
        }
    }

    pub const fn value(&self) -> u64 {
        self.normalised >> self.shift
    }

    /// floor(value/d) and the rest; `None` if the quotient is beyond +-(2^63 - 1).
    #[inline]
    pub fn divide(&self, value: i128) -> Option<Quotient> {
        let magnitude = value.unsigned_abs();
        // Below d 2^63 the shifted value has 127 bits and its high word is less than half of the divisor: one step is enough.
        if (magnitude >> 63) as u64 >= self.value() || magnitude >> 127 != 0 {
            return None;
        }
        let shifted = magnitude << self.shift;
        let (quotient, rest) = self.step((shifted >> 64) as u64, shifted as u64);
        let rest = rest >> self.shift;
        // The quotient is below 2^63. Floor for negative values: -q - 1 and d - rest where there is a rest.
        let (quotient, negative) = (quotient as i64, value < 0);
        let carry = negative & (rest != 0);
        Some(Quotient {
            quotient: if negative { -quotient - i64::from(carry) } else { quotient },
            remainder: if carry { self.value() - rest } else { rest },
        })
    }

    /// floor(remainder 2^32/d) for a remainder below d.
    #[inline]
    pub fn fraction(&self, remainder: u64) -> u32 {
        let shifted = remainder << self.shift;
        let (quotient, _) = self.step(shifted >> 32, shifted << 32);
        quotient as u32
    }

    /// Two words by the normalised divisor; `high` below it.
    #[inline]
    const fn step(&self, high: u64, low: u64) -> (u64, u64) {
        let estimate =
            (self.reciprocal as u128 * high as u128).wrapping_add((high as u128) << 64 | low as u128);
        let (mut quotient, fraction) = (((estimate >> 64) as u64).wrapping_add(1), estimate as u64);
        let mut rest = low.wrapping_sub(quotient.wrapping_mul(self.normalised));
        if rest > fraction {
            quotient = quotient.wrapping_sub(1);
            rest = rest.wrapping_add(self.normalised);
        }
        if rest >= self.normalised {
            quotient = quotient.wrapping_add(1);
            rest = rest.wrapping_sub(self.normalised);
        }
        (quotient, rest)
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        #[test]
        fn divides_as_the_library_does(bits in 1u32..=62, low in any::<u64>(), value in any::<i128>(), less in 0u32..127) {
            let d = (1i64 << (bits - 1)) | (low as i64 & ((1 << (bits - 1)) - 1));
            let value = value >> less;
            let divisor = Divisor::new(d).unwrap();
            let (quotient, rest) = (value.div_euclid(i128::from(d)), value.rem_euclid(i128::from(d)));
            match divisor.divide(value) {
                Some(found) => {
                    prop_assert_eq!((i128::from(found.quotient), found.remainder as i128), (quotient, rest));
                    prop_assert_eq!(i128::from(divisor.fraction(found.remainder)), (rest << 32) / i128::from(d));
                }
                None => prop_assert!(value.unsigned_abs() / d as u128 >= 1 << 63),
            }
        }
    }

    #[test]
    fn ends_of_the_range() {
        assert_eq!(Divisor::new(0), None);
        assert_eq!(Divisor::new(-1), None);
        assert_eq!(Divisor::new((1 << 62) + 1), None);
        let greatest = Divisor::new(1 << 62).unwrap();
        assert_eq!(greatest.divide(-1), Some(Quotient { quotient: -1, remainder: (1 << 62) - 1 }));
        assert_eq!(Divisor::new(1).unwrap().divide(i128::from(i64::MAX)).unwrap().quotient, i64::MAX);
        assert_eq!(Divisor::new(1).unwrap().divide(1 << 63), None);
        assert_eq!(Divisor::new(1 << 62).unwrap().divide(i128::MIN), None);
    }
}
