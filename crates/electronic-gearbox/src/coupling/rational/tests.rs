//! Fractions against searches and known numbers.

use proptest::prelude::*;

use super::{Ratio, best_rational, dyadic, endless_ratio, error_per_metre};
use crate::Error;

fn of(numerator: i64, denominator: i64) -> Ratio {
    Ratio::new(numerator, denominator).unwrap()
}

fn parts(b: f64) -> (i64, u32) {
    let found = dyadic(b).unwrap();
    (found.numerator(), found.shift())
}

#[test]
fn endless_ratios_are_reduced_and_carry_one_sign() {
    assert_eq!(endless_ratio(3, 36_000, 40, 8_192), Ok(of(675, 2048)));
    assert_eq!(endless_ratio(-3, 36_000, 40, 8_192), Ok(of(-675, 2048)));
    assert_eq!(endless_ratio(3, 36_000, -40, 8_192), Ok(of(-675, 2048)));
    assert_eq!(endless_ratio(-3, 36_000, -40, 8_192), Ok(of(675, 2048)));
    assert_eq!(endless_ratio(1, 1, 1 << 31, 1 << 31), Ok(of(1, 1 << 62)));
}

#[test]
fn ratios_beyond_62_bits_are_refused() {
    let big = (1i64 << 61) - 1;
    assert!(matches!(endless_ratio(big, 7, 2, 1), Err(Error::GearRange { value: i64::MAX, .. })));
    assert!(matches!(endless_ratio(1 << 31, 1 << 31, 1, 1), Err(Error::GearRange { .. })));
    assert!(matches!(endless_ratio(1, 1, big, 3), Err(Error::GearRange { .. })));
    assert_eq!(endless_ratio(i64::MIN, i64::MIN, i64::MIN, i64::MIN), Ok(of(1, 1)));
    for zero in 0..4 {
        let mut factors = [1; 4];
        factors[zero] = 0;
        let [starts, workpiece, teeth, tool] = factors;
        assert!(matches!(
            endless_ratio(starts, workpiece, teeth, tool),
            Err(Error::GearRange { value: 0, .. })
        ));
    }
}

#[test]
fn a_dyadic_ratio_keeps_all_bits_of_the_number() {
    assert_eq!(parts(0.0), (0, 61));
    assert_eq!(parts(0.5), (1 << 60, 61));
    assert_eq!(parts(1.0), (1 << 60, 60));
    assert_eq!(parts(-3.25), (-13 << 57, 59));
    let greatest = ((1u64 << 61) as f64).next_down();
    assert_eq!(parts(greatest), (greatest as i64, 0));
    assert!(matches!(dyadic((1u64 << 61) as f64), Err(Error::GearRange { .. })));
    assert!(matches!(dyadic(f64::NAN), Err(Error::BadParameter { .. })));
    assert_eq!(dyadic(-3.25).unwrap().ratio(), of(-13, 4));
    assert_eq!(dyadic(0.0).unwrap().ratio(), of(0, 1));
    assert_eq!(dyadic(8.0).unwrap().ratio(), of(8, 1));
}

#[test]
fn a_dyadic_ratio_rounds_halves_to_even() {
    let unit = 2f64.powi(-61);
    for (multiple, numerator) in [(0.5, 0), (1.5, 2), (2.5, 2), (2.5000001, 3), (-3.5, -4), (0.49, 0)] {
        assert_eq!(parts(multiple * unit), (numerator, 61), "{multiple}");
    }
    assert_eq!(dyadic(f64::MIN_POSITIVE / 8.0).unwrap().numerator(), 0);
    assert_eq!(dyadic(unit / 2.0).unwrap().error_bound(), unit / 2.0);
}

#[test]
fn known_rationals_are_found() {
    let best = |b, most| best_rational(b, most).unwrap().ratio();
    assert_eq!(best(core::f64::consts::PI, 10), of(22, 7));
    assert_eq!(best(core::f64::consts::PI, 1000), of(355, 113));
    assert_eq!(best(-core::f64::consts::PI, 100), of(-311, 99));
    assert_eq!(best(0.75, 1 << 62), of(3, 4));
    assert_eq!(best(0.75, 3), of(2, 3));
    assert_eq!(best(0.5, 1), of(0, 1));
    assert_eq!(best(-0.5, 1), of(0, 1));
    assert_eq!(best(1.5, 1), of(1, 1));
    assert_eq!(best(0.0, 5), of(0, 1));
    assert_eq!(best(1e15, 5), of(1_000_000_000_000_000, 1));
    assert_eq!(best(2f64.powi(-100), 1 << 62), of(0, 1));
    assert_eq!(best(2f64.powi(-61), 1 << 62), of(1, 1 << 61));
    assert_eq!(best(2f64.powi(-62).next_up(), 1 << 62), of(1, (1 << 62) - 1024));
    assert_eq!(best(f64::MIN_POSITIVE, 1 << 62), of(0, 1));
}

#[test]
fn errors_have_their_sign_and_their_digits() {
    let third = best_rational(1.0 / 3.0, 100).unwrap();
    assert_eq!(third.ratio(), of(1, 3));
    // 1/3 rounds down to 6004799503160661/2^54; a third of 2^-54 is missing.
    assert_eq!(third.error(), 2f64.powi(-54) / 3.0);
    assert_eq!(best_rational(-1.0 / 3.0, 100).unwrap().error(), -(2f64.powi(-54) / 3.0));
    assert_eq!(best_rational(0.4, 1).unwrap().error(), -0.4);
    assert_eq!(best_rational(0.6, 1).unwrap().error(), 0.4);
    assert_eq!(best_rational(1e-200, 7).unwrap().error(), -1e-200);
}

#[test]
fn limits_that_are_none_are_refused() {
    for limit in [0, -1, i64::MAX] {
        assert!(matches!(best_rational(0.3, limit), Err(Error::GearRange { .. })));
    }
    assert!(matches!(best_rational(1e300, 5), Err(Error::GearRange { value: i64::MAX, .. })));
    assert!(matches!(best_rational((1u64 << 62) as f64, 5), Err(Error::GearRange { .. })));
    assert!(matches!(best_rational(f64::INFINITY, 5), Err(Error::BadParameter { .. })));
}

#[test]
fn an_error_grows_with_the_way() {
    assert_eq!(error_per_metre(1e-12, 1e6), Ok(1e-6));
    assert!(error_per_metre(f64::NAN, 1.0).is_err());
    assert!(error_per_metre(1e300, 1e300).is_err());
}

/// |p/q - b| times q 2^t for b = mantissa/2^t, as a pair to compare crosswise.
fn distance(p: i64, q: i64, mantissa: i128, places: u32) -> (i128, i128) {
    ((mantissa * i128::from(q) - (i128::from(p) << places)).abs(), i128::from(q))
}

proptest! {
    #[test]
    fn the_best_rational_is_that_of_a_search(mantissa in -(1i64 << 20)..1i64 << 20, places in 1u32..24, most in 1i64..400) {
        let b = mantissa as f64 / (1u64 << places) as f64;
        let found = best_rational(b, most).unwrap();
        let mut best = (0, 0, (i128::MAX, 1));
        for q in 1..=most {
            let floor = (b * q as f64).floor() as i64;
            for p in [floor, floor + 1] {
                let error = distance(p, q, mantissa.into(), places);
                if best.1 == 0 || error.0 * best.2.1 < best.2.0 * error.1 {
                    best = (p, q, error);
                }
            }
        }
        let mine = found.ratio();
        let error = distance(mine.numerator(), mine.denominator(), mantissa.into(), places);
        prop_assert_eq!(error.0 * best.2.1, best.2.0 * error.1);
        prop_assert_eq!(mine.denominator(), best.1);
        let exact = error.0 as f64 / error.1 as f64 / (1u64 << places) as f64;
        prop_assert!((found.error().abs() - exact).abs() <= 1e-15 * exact);
        let difference = mine.numerator() as f64 / mine.denominator() as f64 - b;
        prop_assert!((found.error() - difference).abs() <= 4.0 * f64::EPSILON * (b.abs() + 1.0));
    }

    #[test]
    fn any_number_and_limit_gives_a_fraction_within_its_bound(
        mantissa in -(1i64 << 53)..=1 << 53, exponent in -1100i32..=8, most in prop_oneof![1i64..=1 << 62, 1i64..1 << 20],
    ) {
        let b = mantissa as f64 * 2f64.powi(exponent);
        let found = best_rational(b, most).unwrap();
        prop_assert!((1..=most).contains(&found.ratio().denominator()));
        // Multiples of 1/most alone come as near.
        prop_assert!(found.error().abs() <= 0.5 / most as f64 * (1.0 + 1e-14));
    }

    #[test]
    fn a_dyadic_ratio_is_within_its_bound(b in prop_oneof![-2.0f64..2.0, -1e18f64..1e18, -1e-12f64..1e-12]) {
        let found = dyadic(b).unwrap();
        prop_assert!(found.numerator().unsigned_abs() < (1 << 62));
        // The difference of two neighbouring numbers is exact.
        let value = found.numerator() as f64 * 2f64.powi(-(found.shift() as i32));
        prop_assert!((value - b).abs() <= found.error_bound());
        let length = 64 - (b.abs().floor() as u64).leading_zeros();
        prop_assert_eq!(found.shift(), 61 - length);
    }

    #[test]
    fn endless_ratios_equal_their_factors(
        starts in 1i64..1000, workpiece in 1i64..1 << 30, teeth in prop_oneof![-2000i64..0, 1i64..2000], tool in 1i64..1 << 30,
    ) {
        let ratio = endless_ratio(starts, workpiece, teeth, tool).unwrap();
        let (n, d) = (i128::from(ratio.numerator()), i128::from(ratio.denominator()));
        prop_assert_eq!(n * i128::from(teeth * tool), d * i128::from(starts * workpiece));
        let (mut a, mut b) = (n.abs(), d);
        while b != 0 {
            (a, b) = (b, a % b);
        }
        prop_assert_eq!(a, 1);
    }
}
