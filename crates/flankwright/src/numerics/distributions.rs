//! Tails of Student's t and Fisher's F distribution by the incomplete beta function. Knows no measurements.

use super::bisect;

/// Stirling's series is used above this argument; its first term left out is below 1e-17 there.
const STIRLING: f64 = 16.0;
/// Terms of the continued fraction at most; some tens are usual.
const TERMS: usize = 10_000;

/// ln Gamma(x) for x > 0.
fn ln_gamma(mut x: f64) -> f64 {
    let mut shift = 1.0_f64;
    let mut moved = 0.0;
    while x < STIRLING {
        shift *= x;
        x += 1.0;
        if shift > 1e200 {
            moved += shift.ln();
            shift = 1.0;
        }
    }
    let r = 1.0 / (x * x);
    let series =
        (1.0 / 12.0 - r * (1.0 / 360.0 - r * (1.0 / 1260.0 - r * (1.0 / 1680.0 - r * (1.0 / 1188.0))))) / x;
    (x - 0.5) * x.ln() - x + 0.5 * std::f64::consts::TAU.ln() + series - shift.ln() - moved
}

/// The continued fraction of the incomplete beta function by the method of Lentz.
fn beta_fraction(x: f64, a: f64, b: f64) -> f64 {
    let away_from_zero = |value: f64| if value.abs() < 1e-300 { 1e-300 } else { value };
    let mut c = 1.0;
    let mut d = 1.0 / away_from_zero(1.0 - (a + b) * x / (a + 1.0));
    let mut fraction = d;
    for k in 1..TERMS {
        let m = k as f64;
        let even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
        let odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        let mut change = 1.0;
        for term in [even, odd] {
            d = 1.0 / away_from_zero(1.0 + term * d);
            c = away_from_zero(1.0 + term / c);
            change = c * d;
            fraction *= change;
        }
        if (change - 1.0).abs() < 1e-16 {
            break;
        }
    }
    fraction
}

/// The regularised incomplete beta function I_x(a, b) for 0 <= x <= 1 and a, b > 0; NaN elsewhere.
pub fn incomplete_beta(x: f64, a: f64, b: f64) -> f64 {
    if !((0.0..=1.0).contains(&x) && a > 0.0 && b > 0.0) {
        return f64::NAN;
    }
    if x == 0.0 || x == 1.0 {
        return x;
    }
    let front = (ln_gamma(a + b) - ln_gamma(a) - ln_gamma(b) + a * x.ln() + b * (-x).ln_1p()).exp();
    if x < (a + 1.0) / (a + b + 2.0) {
        front * beta_fraction(x, a, b) / a
    } else {
        1.0 - front * beta_fraction(1.0 - x, b, a) / b
    }
}

/// Probability that |t| of Student's distribution with `freedom` > 0 degrees of freedom exceeds |`t`|.
pub fn student_two_sided(t: f64, freedom: f64) -> f64 {
    if t.is_infinite() {
        return 0.0;
    }
    incomplete_beta(freedom / (freedom + t * t), 0.5 * freedom, 0.5)
}

/// The t that |t| of Student's distribution with `freedom` > 0 degrees of freedom stays below with probability `level`, 0 < level < 1
/// (two-sided quantile); NaN elsewhere.
pub fn student_quantile(level: f64, freedom: f64) -> f64 {
    if !(level > 0.0 && level < 1.0 && freedom > 0.0) {
        return f64::NAN;
    }
    let beyond = |t: f64| student_two_sided(t, freedom) - (1.0 - level);
    let mut high = 1.0;
    while beyond(high) > 0.0 && high < f64::MAX / 2.0 {
        high *= 2.0;
    }
    bisect(0.0, high, beyond).unwrap_or(f64::NAN)
}

/// Probability that F of Fisher's distribution with `above` and `below` > 0 degrees of freedom exceeds `f` >= 0.
pub fn fisher_upper(f: f64, above: f64, below: f64) -> f64 {
    if f.is_infinite() {
        return 0.0;
    }
    incomplete_beta(below / (below + above * f), 0.5 * below, 0.5 * above)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn closed_forms_are_met() {
        // One and two degrees of freedom have closed forms.
        for t in [0.1_f64, 1.0, 3.0, 40.0] {
            let one = 1.0 - 2.0 / std::f64::consts::PI * t.atan();
            let two = 1.0 - t / (2.0 + t * t).sqrt();
            assert!((student_two_sided(t, 1.0) - one).abs() < 1e-14, "{t}");
            assert!((student_two_sided(t, 2.0) - two).abs() < 1e-14, "{t}");
            // F with 2 degrees above: (1 + 2 f/n)^(-n/2).
            let f = (1.0 + 2.0 * t / 7.0).powf(-3.5);
            assert!((fisher_upper(t, 2.0, 7.0) / f - 1.0).abs() < 1e-13, "{t}");
            // t^2 with n is F with 1 and n.
            let same = student_two_sided(t, 9.0) / fisher_upper(t * t, 1.0, 9.0);
            assert!((same - 1.0).abs() < 1e-13, "{t}");
        }
    }

    #[test]
    fn quantiles_are_those_of_the_tables() {
        for (level, freedom, table) in
            [(0.95, 1.0, 12.7062047364), (0.95, 10.0, 2.2281388520), (0.99, 30.0, 2.7499956536)]
        {
            let t = student_quantile(level, freedom);
            assert!((t - table).abs() < 1e-9, "{t} {table}");
            assert!((student_two_sided(t, freedom) - (1.0 - level)).abs() < 1e-14);
        }
        // Many degrees of freedom: the normal distribution.
        assert!((student_quantile(0.95, 1e7) - 1.959963985).abs() < 1e-6);
    }

    #[test]
    fn arguments_without_a_meaning_are_nan() {
        assert!(incomplete_beta(1.5, 1.0, 1.0).is_nan() && incomplete_beta(0.5, 0.0, 1.0).is_nan());
        assert!(student_quantile(1.0, 3.0).is_nan() && student_quantile(0.95, 0.0).is_nan());
        assert!(student_two_sided(f64::NAN, 3.0).is_nan());
        assert_eq!((fisher_upper(0.0, 2.0, 3.0), fisher_upper(f64::INFINITY, 2.0, 3.0)), (1.0, 0.0));
    }
}
