//! What rounded ratios and rounded sums do over 10^12 pulses, beside the gearbox, which does nothing. The table in docs/electronic-gearbox.md
//! has its numbers from here. Sums are computed, not waited for: between two powers of 2 a floating sum grows by the same rounded step.

use electronic_gearbox::coupling::{Gearbox, LinearTerm, Ratio};

/// z_1 N_w/(z_2 N_s) of 3 starts, 47 teeth, 36 000 and 8192 counts a revolution.
const NUMERATOR: i64 = 3 * 36_000;
const DENOMINATOR: i64 = 47 * 8192;
const PULSES: i64 = 1_000_000_000_000;

/// A sum of `pulses` equal steps in a binary format of `digits` digits, every addition rounded half to even, as the number of units
/// 2^-`scale` that the format cannot divide further at the start.
struct FloatingSum {
    digits: u32,
    /// Step in units of 2^-80.
    step: u128,
}

impl FloatingSum {
    /// Units of 2^-80 after the steps.
    fn after(&self, pulses: u64) -> u128 {
        let (mut sum, mut left) = (0u128, pulses);
        while left > 0 {
            let next = self.rounded(sum + self.step);
            if next == sum {
                return sum;
            }
            let grown = next - sum;
            // Inside a binade every further step is the same as this one, unless a tie alternates: then this is the last before it ends.
            let ulp = self.ulp(next);
            let end = (1u128 << (128 - next.leading_zeros())) - ulp;
            let again = self.rounded(next + self.step) == next + grown;
            let room = if again && self.ulp(sum.max(1)) == ulp { (end - next) / grown } else { 0 };
            let repeats = u128::from(left - 1).min(room.saturating_sub(1));
            sum = next + repeats * grown;
            left -= 1 + repeats as u64;
        }
        sum
    }

    fn ulp(&self, value: u128) -> u128 {
        let length = 128 - value.leading_zeros();
        1u128 << length.saturating_sub(self.digits)
    }

    fn rounded(&self, value: u128) -> u128 {
        let ulp = self.ulp(value);
        let (whole, rest) = (value / ulp, value % ulp);
        let up = 2 * rest > ulp || (2 * rest == ulp && whole % 2 == 1);
        (whole + u128::from(up)) * ulp
    }
}

/// Counts that a sum in units of 2^-80 lacks or has too many after the pulses.
fn drift(sum: u128) -> f64 {
    let exact = i128::from(PULSES) * i128::from(NUMERATOR);
    let whole = exact / i128::from(DENOMINATOR);
    let rest = (exact % i128::from(DENOMINATOR)) as f64 / DENOMINATOR as f64;
    let counts = (sum >> 80) as i128 - whole;
    let fraction = (sum & ((1 << 80) - 1)) as f64 / (1u128 << 80) as f64;
    counts as f64 + (fraction - rest)
}

#[test]
fn sums_are_those_of_the_processor() {
    let (single, double) =
        ((NUMERATOR as f64 / DENOMINATOR as f64) as f32, NUMERATOR as f64 / DENOMINATOR as f64);
    let (mut a, mut b) = (0f32, 0f64);
    for k in 1..=3_000_000u64 {
        a += single;
        b += double;
        if k.is_power_of_two() || k % 499_979 == 0 {
            let units = |value: f64| (value * (1u64 << 50) as f64) as u128 * (1 << 30);
            assert_eq!(
                FloatingSum { digits: 24, step: units(single.into()) }.after(k),
                units(a.into()),
                "{k}"
            );
            let step = (double * (1u64 << 56) as f64) as u128 * (1 << 24);
            let expected = (b * (1u64 << 56) as f64) as u128 * (1 << 24);
            assert_eq!(FloatingSum { digits: 53, step }.after(k), expected, "{k}");
        }
    }
}

#[test]
fn the_gearbox_does_not_drift_and_the_others_are_in_the_docs() {
    let gearbox = Gearbox::new(0, [LinearTerm::new(Ratio::new(NUMERATOR, DENOMINATOR).unwrap(), 0)]);
    let exact = i128::from(PULSES) * i128::from(NUMERATOR);
    let at = gearbox.position(&[PULSES]).unwrap();
    assert_eq!(i128::from(at.counts), exact / i128::from(DENOMINATOR));
    assert_eq!(i128::from(at.fraction), ((exact % i128::from(DENOMINATOR)) << 32) / i128::from(DENOMINATOR));

    let ratio = NUMERATOR as f64 / DENOMINATOR as f64;
    let double = FloatingSum { digits: 53, step: (ratio * (1u64 << 56) as f64) as u128 * (1 << 24) };
    let single =
        FloatingSum { digits: 24, step: (f64::from(ratio as f32) * (1u64 << 50) as f64) as u128 * (1 << 30) };
    // Eight decimals of the ratio, summed without any further error.
    let decimal = (ratio * 1e8).round() as i128 * i128::from(PULSES) / 100_000_000;
    let counts = |value: f64| if value.abs() < 100.0 { format!("{value:.4}") } else { format!("{value:.0}") };
    let drifts = [
        drift(double.after(PULSES as u64)),
        drift(single.after(PULSES as u64)),
        (decimal - exact / i128::from(DENOMINATOR)) as f64,
    ];
    let docs = include_str!("../../../docs/electronic-gearbox.md");
    let missing: Vec<String> = drifts
        .map(|value| format!("| {} |", counts(value)))
        .into_iter()
        .filter(|cell| !docs.contains(cell))
        .collect();
    assert!(missing.is_empty(), "{missing:?}");
}
