//! Numbers as controls read them (`docs/mathematics/programs.md#what-rounding-adds`): fixed notation, the point always there, no exponent,
//! no plus sign, no minus zero, rounded half to even from the exact binary value. Knows no word.

use std::io::Write as _;

/// 10^n as integers.
const POWERS: [u64; 20] = {
    let mut powers = [1u64; 20];
    let mut n = 1;
    while n < 20 {
        powers[n] = powers[n - 1] * 10;
        n += 1;
    }
    powers
};

/// `value` in units of 10^-`decimals`, rounded half to even from its exact binary value; none if that is no i64.
pub(super) fn units(value: f64, decimals: u8) -> Option<i64> {
    // 2^53: below, the mantissa times a power up to 10^18 stays within 113 bits and only shifts to the right remain.
    if value.is_nan() || value.abs() >= 9_007_199_254_740_992.0 || decimals > 18 {
        return None;
    }
    let bits = value.to_bits();
    let stored = (bits >> 52 & 0x7ff) as i32;
    let fraction = bits & ((1 << 52) - 1);
    let (mantissa, exponent) =
        if stored == 0 { (fraction, -1074) } else { (fraction | 1 << 52, stored - 1075) };
    let product = u128::from(mantissa) * u128::from(POWERS[usize::from(decimals)]);
    // The exponent is below 0 here; what is shifted by 127 or more is less than half a unit.
    let shift = exponent.unsigned_abs();
    if shift > 126 {
        return Some(0);
    }
    let whole = product >> shift;
    let rest = product - (whole << shift);
    let half = (1u128 << shift) >> 1;
    let up = rest > half || (rest == half && half > 0 && whole & 1 == 1);
    let size = i64::try_from(whole + u128::from(up)).ok()?;
    Some(if value < 0.0 { -size } else { size })
}

/// Appends `units` of 10^-`decimals`; without decimals the point still stands there.
pub(super) fn push_units(text: &mut Vec<u8>, units: i64, decimals: u8) {
    let mut digits = [b'0'; 24];
    let mut place = digits.len();
    let mut left = units.unsigned_abs();
    let fraction = usize::from(decimals).min(18);
    for _ in 0..fraction {
        place -= 1;
        digits[place] = b'0' + (left % 10) as u8;
        left /= 10;
    }
    place -= 1;
    digits[place] = b'.';
    loop {
        place -= 1;
        digits[place] = b'0' + (left % 10) as u8;
        left /= 10;
        if left == 0 {
            break;
        }
    }
    if units < 0 {
        place -= 1;
        digits[place] = b'-';
    }
    text.extend_from_slice(&digits[place..]);
}

/// Appends a finite number with so many decimals.
pub(super) fn push_fixed(text: &mut Vec<u8>, value: f64, decimals: u8) {
    match units(value, decimals) {
        Some(units) => push_units(text, units, decimals),
        // Beyond what an i64 holds: writing into memory does not fail.
        None => drop(write!(text, "{value:.*}", usize::from(decimals).max(1))),
    }
}

/// Appends a finite number with `digits` significant digits, an integer without a point.
pub(super) fn push_significant(text: &mut Vec<u8>, value: f64, digits: u8) {
    if value.fract() == 0.0 && value.abs() < 1e15 {
        drop(write!(text, "{}", value as i64));
        return;
    }
    let leading = value.abs().log10().floor() as i32 + 1;
    let decimals = (i32::from(digits) - leading).clamp(1, 40);
    drop(write!(text, "{value:.*}", decimals as usize));
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn fixed(value: f64, decimals: u8) -> String {
        let mut text = Vec::new();
        push_fixed(&mut text, value, decimals);
        String::from_utf8(text).unwrap()
    }

    /// What the standard library makes of it, without minus zero and with a point.
    fn reference(value: f64, decimals: u8) -> String {
        let text = format!("{value:.*}", usize::from(decimals));
        let text = if decimals == 0 { text + "." } else { text };
        if text.bytes().all(|byte| b"-0.".contains(&byte)) { text.replace('-', "") } else { text }
    }

    #[test]
    fn ties_go_to_the_even_neighbour_and_zero_has_no_sign() {
        let cases = [
            (0.5, 0, "0."),
            (1.5, 0, "2."),
            (2.5, 0, "2."),
            (-2.5, 0, "-2."),
            (0.125, 2, "0.12"),
            (0.375, 2, "0.38"),
            (-0.0, 3, "0.000"),
            (-1e-9, 6, "0.000000"),
            (5e-324, 6, "0.000000"),
            (119.999602, 6, "119.999602"),
            (-999_999.999_999, 9, "-999999.999999000"),
            (0.285, 2, "0.28"), // just below the tie in binary
            (1e300, 1, &reference(1e300, 1)),
        ];
        for (value, decimals, expected) in cases {
            assert_eq!(fixed(value, decimals), expected);
        }
    }

    #[test]
    fn significant_digits_are_kept_whatever_the_size() {
        let text = |value| {
            let mut text = Vec::new();
            push_significant(&mut text, value, 15);
            String::from_utf8(text).unwrap()
        };
        assert_eq!(
            (text(3.0), text(-40.0), text(0.5)),
            ("3".into(), "-40".into(), "0.500000000000000".into())
        );
        assert_eq!(text(123.125_818_920_741), "123.125818920741");
        assert_eq!(text(0.000_001_234_567_890_123_45), "0.00000123456789012345");
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, cases: 20_000, ..ProptestConfig::default() })]

        #[test]
        fn the_integer_path_rounds_as_the_standard_library(
            bits in any::<u64>(), small in -1e8..1e8f64, tie in -1_000_000_000i64..1_000_000_000, decimals in 0u8..=12,
        ) {
            // Ties are what half-even is about: dyadic numbers with few bits after the point.
            let dyadic = tie as f64 / 1024.0;
            for value in [f64::from_bits(bits), small, small * 1e-6, dyadic, dyadic / 4096.0] {
                if value.is_finite() && value.abs() < 1e300 && (decimals > 0 || value.abs() < 1e9) {
                    prop_assert_eq!(fixed(value, decimals), reference(value, decimals));
                }
            }
        }
    }
}
