//! Floating numbers taken apart into integers.

use crate::Error;

/// |b| = mantissa 2^exponent exactly, with an odd mantissa below 2^53, or 0.
pub(super) struct Binary {
    pub mantissa: u64,
    pub exponent: i32,
}

impl Binary {
    pub(super) fn of(b: f64) -> Result<Self, Error> {
        if !b.is_finite() {
            return Err(Error::BadParameter { name: "ratio", value: b, allowed: "finite" });
        }
        let bits = b.to_bits();
        let field = (bits >> 52 & 0x7ff) as i32;
        let fraction = bits & ((1 << 52) - 1);
        // Subnormal numbers have no leading one and the exponent of the first normal ones.
        let (mantissa, exponent) =
            if field == 0 { (fraction, -1074) } else { (fraction | 1 << 52, field - 1075) };
        if mantissa == 0 {
            return Ok(Self { mantissa, exponent: 0 });
        }
        let zeros = mantissa.trailing_zeros();
        Ok(Self { mantissa: mantissa >> zeros, exponent: exponent + zeros as i32 })
    }
}

pub(super) fn out_of_range(b: f64) -> Error {
    // The cast saturates.
    Error::GearRange { name: "ratio", value: b as i64 }
}

/// 2^-places for up to 1022 places.
pub(super) fn power_of_two(places: u32) -> f64 {
    libm::scalbn(1.0, -(places as i32))
}
