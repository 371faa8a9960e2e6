//! Rate multiplier, hand switch and split (`docs/mathematics/gearbox.md#from-pulses-to-counts`).

#[path = "common/draw.rs"]
mod draw;
#[path = "common/slide.rs"]
mod slide;

use draw::Draw;
use electronic_gearbox::chain::{
    AdditionalRotation, Multiplier, RateRule, SharedRotation, Split, SplitRotation, passed_pulses,
};
use electronic_gearbox::pulse::Direction;
use electronic_gearbox::{Error, Sign};
use slide::Slide;

const RULES: [RateRule; 2] = [RateRule::Binary, RateRule::Bresenham];

#[test]
fn a_multiplier_passes_what_its_sum_says() {
    let mut draw = Draw::new(3);
    for rule in RULES {
        for word in (0..40).map(|_| (draw.bits() & 0x3ffff) as u32).chain([0, 1, 2, 131072, 262143]) {
            let mut multiplier = Multiplier::new(word, rule).unwrap();
            let mut passed = 0;
            for n in 1..=600_000u64 {
                passed += u64::from(multiplier.pulse());
                if n < 3000 || n % 997 == 0 || n % 262144 < 2 {
                    assert_eq!(passed, passed_pulses(word, rule, n).unwrap(), "{rule:?} B {word} n {n}");
                }
            }
        }
    }
}

#[test]
fn a_whole_period_passes_exactly_its_coefficient() {
    for rule in RULES {
        for word in [1, 3001, 123456, 262143] {
            for from in [0, 1, 77_777] {
                let passed = |n| passed_pulses(word, rule, n).unwrap();
                assert_eq!(passed(from + (1 << 18)) - passed(from), u64::from(word));
            }
        }
        // The very last pulse of a period is the one that does not pass; after 2^64 - 1 pulses it is still to come.
        let missing = u64::MAX - passed_pulses(262143, rule, u64::MAX).unwrap();
        assert_eq!(missing, (1 << 46) - u64::from(rule == RateRule::Binary));
    }
}

#[test]
fn deviation_from_the_straight_line() {
    let (mut least, mut greatest) = ([0.0f64; 2], [0.0f64; 2]);
    let mut draw = Draw::new(11);
    // The two words of the extremes of the binary rule have alternating bits.
    let words =
        (0..60).map(|_| (draw.bits() & 0x3ffff) as u32).chain([0b101010101010101010, 0b010101010101010101]);
    for word in words {
        for (k, rule) in RULES.into_iter().enumerate() {
            let mut multiplier = Multiplier::new(word, rule).unwrap();
            let mut passed = 0;
            for n in 1..=(1u64 << 18) {
                passed += i64::from(multiplier.pulse());
                let off = passed as f64 - n as f64 * f64::from(word) / 262144.0;
                (least[k], greatest[k]) = (least[k].min(off), greatest[k].max(off));
            }
        }
    }
    assert!(least[0] > -2.8889 && greatest[0] < 3.3889, "{least:?} {greatest:?}");
    assert!(greatest[0] - least[0] > 5.5, "{least:?} {greatest:?}");
    assert!(least[1] > -1.0 && greatest[1] <= 0.0);
}

/// Each line has its own counter: the error of a slide going to and fro does not add up.
#[test]
fn to_and_fro_does_not_drift() {
    let word = 0b101010101010101010;
    for hand in [Sign::Plus, Sign::Minus] {
        let mut chain = AdditionalRotation::new(word, RateRule::Binary, hand, 16).unwrap();
        let mut position = 0i64;
        for (_, direction) in Slide::new(21, 16, 100).take(3_000_000) {
            chain.pulse(direction);
            position += direction.sign();
            let sign = hand.as_f64();
            let off = chain.total() as f64 - sign * position as f64 * f64::from(word) / 262144.0;
            assert!(off.abs() < 2.8889 + 3.3889, "{off}");
        }
    }
}

#[test]
fn coarse_and_fine_are_the_number_of_pulses() {
    let mut split = Split::new(16).unwrap();
    let (mut total, mut coarse) = (0i64, 0i64);
    let mut draw = Draw::new(5);
    for _ in 0..100_000 {
        let direction = if draw.bits() & 1 == 0 { Direction::Forward } else { Direction::Backward };
        total += direction.sign();
        coarse += split.pulse(direction).map_or(0, Direction::sign);
        let at = split.position();
        assert_eq!((at.coarse, i64::from(at.fine)), (total.div_euclid(16), total.rem_euclid(16)));
        assert_eq!(at.coarse, coarse);
    }
}

#[test]
fn one_word_carries_both_halves() {
    let shared = SharedRotation::new();
    let mut near = -3;
    for (coarse, fine) in
        [(-1, 255), (0, 0), (8_388_000, 3), (16_000_000, 17), (20_000_000, 1), (12_000_000, 9)]
    {
        shared.publish(SplitRotation { coarse, fine });
        assert_eq!(shared.read(near), SplitRotation { coarse, fine });
        near = coarse;
    }
    shared.publish(SplitRotation { coarse: i64::MIN, fine: 4 });
    assert_eq!(shared.read(i64::MIN + 5), SplitRotation { coarse: i64::MIN, fine: 4 });
}

#[test]
fn bad_settings_are_refused() {
    assert!(matches!(Multiplier::new(1 << 18, RateRule::Binary), Err(Error::BadParameter { name: "B", .. })));
    assert!(matches!(Split::new(1), Err(Error::PulsesPerInterval { value: 1 })));
    assert!(matches!(
        AdditionalRotation::new(5, RateRule::Binary, Sign::Plus, 257),
        Err(Error::PulsesPerInterval { value: 257 })
    ));
}
