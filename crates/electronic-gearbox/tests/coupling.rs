//! The gearbox of several axes: exact, free of history, free of drift (`docs/mathematics/gearbox.md#couplings`).

#[path = "common/draw.rs"]
mod draw;

use draw::Draw;
use electronic_gearbox::Error;
use electronic_gearbox::coupling::{
    Bresenham, Gearbox, IncrementalGearbox, LinearTerm, Ratio, WrappingCounter,
};
use electronic_gearbox::pulse::Direction;
use proptest::prelude::*;

fn term(numerator: i64, denominator: i64, zero: i64) -> LinearTerm {
    LinearTerm::new(Ratio::new(numerator, denominator).unwrap(), zero)
}

/// A ratio of random size whose follower stays within range for ways up to 2^40.
fn ratio() -> impl Strategy<Value = (i64, i64)> {
    (1u32..=62, any::<u64>(), any::<u64>(), any::<bool>()).prop_map(|(bits, a, b, negative)| {
        let d = 1i64.max((b >> (64 - bits)) as i64);
        let n = (a >> 2) as i64 % d.saturating_mul(1 << 18).clamp(1, (1 << 62) - 1);
        (if negative { -n } else { n }, d)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn increments_give_the_position_of_the_sum(
        ratios in [ratio(), ratio(), ratio()],
        zeros in [-1_000_000i64..1_000_000, -1_000_000i64..1_000_000, -1_000_000i64..1_000_000],
        steps in prop::collection::vec([-70_000i64..70_000, -1i64..2, -1_000_000_000i64..1_000_000_000], 1..60),
    ) {
        let terms = [0, 1, 2].map(|k| term(ratios[k].0, ratios[k].1, zeros[k]));
        let gearbox = Gearbox::new(12_345, terms);
        let mut leading = [5, -7, 900];
        let mut running = IncrementalGearbox::new(gearbox, &leading).unwrap();
        for step in steps {
            for (x, dx) in leading.iter_mut().zip(step) {
                *x += dx;
            }
            running.advance(&step).unwrap();
            let at = gearbox.position(&leading).unwrap();
            prop_assert_eq!(running.position().unwrap(), at);
            // Against plain integers: the sum of the floors, and of the fractions rounded down.
            let (mut counts, mut fractions) = (12_345i128, 0i128);
            for k in 0..3 {
                let (n, d) = (i128::from(ratios[k].0), i128::from(ratios[k].1));
                let v = n * i128::from(leading[k] - zeros[k]);
                counts += v.div_euclid(d);
                fractions += (v.rem_euclid(d) << 32) / d;
            }
            let expected = (counts + (fractions >> 32), fractions & 0xffff_ffff);
            prop_assert_eq!((i128::from(at.counts), i128::from(at.fraction)), expected);
        }
    }

    #[test]
    fn single_pulses_give_the_position_of_the_ratio(bits in 1u32..=62, a in any::<u64>(), b in any::<u64>(),
                                                      negative in any::<bool>(), start in any::<u64>()) {
        let d = 1i64.max((b >> (64 - bits)) as i64);
        let n = (a % (d as u64 + 1)) as i64;
        let ratio = Ratio::new(if n == 1 << 62 { n - 1 } else if negative { -n } else { n }, d).unwrap();
        let mut line = Bresenham::new(ratio).unwrap();
        let gearbox = Gearbox::new(0, [LinearTerm::new(ratio, 0)]);
        let mut draw = Draw::new(start);
        let (mut x, mut y) = (0, 0);
        for k in 0..2000 {
            // Runs of one sense, then the other.
            let forward = (k / 300) % 2 == 0 || draw.bits().is_multiple_of(5);
            let direction = if forward { Direction::Forward } else { Direction::Backward };
            x += direction.sign();
            y += line.pulse(direction).map_or(0, Direction::sign);
            prop_assert_eq!(y, gearbox.position(&[x]).unwrap().counts);
            prop_assert!(0 <= line.remainder() && line.remainder() < ratio.denominator());
        }
    }
}

/// After 10^12 pulses of the tool the workpiece is where the integers say, in whatever portions they came; rounded ratios are not.
#[test]
fn no_drift_after_a_million_million_pulses() {
    // z_1/z_2 = 3/40, 8192 counts a revolution of the tool, 36 000 of the workpiece.
    let gearbox = Gearbox::new(0, [term(3 * 36_000, 40 * 8192, 0)]);
    let pulses = 1_000_000_000_000i64;
    let exact = gearbox.position(&[pulses]).unwrap();
    let v = i128::from(pulses) * 108_000;
    assert_eq!(i128::from(exact.counts), v / 327_680);

    let mut draw = Draw::new(8);
    let mut running = IncrementalGearbox::new(gearbox, &[0]).unwrap();
    let mut left = pulses;
    while left > 0 {
        let step = left.min((draw.bits() % 4_000_000) as i64 + 1);
        running.advance(&[step]).unwrap();
        left -= step;
    }
    assert_eq!(running.position().unwrap(), exact);
    // And back again by another way.
    running.advance(&[-pulses]).unwrap();
    assert_eq!(running.position().unwrap(), gearbox.position(&[0]).unwrap());
}

#[test]
fn closing_the_coupling_moves_nothing_and_bars_changes() {
    let mut gearbox = Gearbox::new(0, [term(7, 30, 0), term(-1, 3, 100)]);
    gearbox.engage(&[1000, 2000], 777).unwrap();
    assert!(gearbox.is_engaged());
    assert_eq!(gearbox.position(&[1000, 2000]).unwrap().counts, 777);
    assert_eq!(gearbox.engage(&[0, 0], 0), Err(Error::Busy));
    assert_eq!(gearbox.replace([term(1, 2, 0), term(1, 2, 0)]), Err(Error::Busy));
    assert_eq!(gearbox.terms()[0].ratio().numerator(), 7);
    gearbox.release();
    gearbox.replace([term(1, 2, 0), term(1, 2, 0)]).unwrap();
    gearbox.engage(&[10, 20], -5).unwrap();
    assert_eq!(gearbox.position(&[12, 22]).unwrap().counts, -3);
    assert_eq!(gearbox.speed(&[3.0, 4.0]), 3.5);
}

#[test]
fn beyond_the_range_is_an_error() {
    for (n, d) in [(1 << 62, 1), (-(1 << 62), 1), (i64::MIN, 1), (1, 0), (1, -3), (1, (1 << 62) + 1)] {
        assert!(matches!(Ratio::new(n, d), Err(Error::GearRange { .. })), "{n}/{d}");
    }
    let wide = Gearbox::new(0, [term((1 << 62) - 1, 1, 0)]);
    assert_eq!(wide.position(&[1]).unwrap().counts, (1 << 62) - 1);
    assert_eq!(wide.position(&[-2]).unwrap().counts, i64::MIN + 2);
    assert!(matches!(wide.position(&[3]), Err(Error::GearRange { .. })));
    let plain = Gearbox::new(i64::MAX, [term(1, 1, 0)]);
    assert!(matches!(plain.position(&[1]), Err(Error::GearRange { .. })));
    let travel = Gearbox::new(0, [term(1, 1 << 62, -10)]);
    assert!(matches!(travel.position(&[(1 << 62) - 10]), Err(Error::GearRange { .. })));
    assert!(matches!(travel.position(&[i64::MAX]), Err(Error::GearRange { .. })));
    let mut running = IncrementalGearbox::new(plain, &[0]).unwrap();
    let before = running;
    assert!(matches!(running.advance(&[i64::MAX]), Err(Error::GearRange { .. })));
    assert_eq!(running, before);
    assert!(matches!(Bresenham::new(Ratio::new(3, 2).unwrap()), Err(Error::GearRange { .. })));
    let mut open = Gearbox::new(0, [term(1, 1, 0)]);
    assert!(matches!(open.engage(&[100], i64::MIN), Err(Error::GearRange { .. })));
    assert!(!open.is_engaged());
}

#[test]
fn counters_wrap() {
    for bits in [2, 16, 24, 32, 63, 64] {
        let mask = u64::MAX >> (64 - bits);
        let mut counter = WrappingCounter::new(bits, mask).unwrap();
        assert_eq!(counter.read(0), Ok(1), "{bits}");
        assert_eq!(counter.read(mask), Ok(-1), "{bits}");
        let half = 1u64 << (bits - 1);
        let error = counter.read(half.wrapping_sub(1) & mask).unwrap_err();
        assert!(matches!(error, Error::EncoderJump { .. }), "{bits} {error}");
        assert_eq!(error.code(), "encoder-jump");
    }
    let mut counter = WrappingCounter::new(32, 0).unwrap().with_largest_step(100);
    assert_eq!(counter.read(100), Ok(100));
    assert!(counter.read(201).is_err());
    assert_eq!(counter.read(150), Ok(-51));
    assert!(WrappingCounter::new(1, 0).is_err() && WrappingCounter::new(65, 0).is_err());
}
