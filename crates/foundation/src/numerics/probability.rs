//! Tail probabilities and quantiles of the normal, Student's and Fisher's law, by the regularised incomplete beta function.

use super::bisect;
use std::f64::consts::SQRT_2;

/// Rounds of the continued fraction; it needs about sqrt(max(a, b)) of them.
const ROUNDS: usize = 100_000;

/// Regularised incomplete beta function I_x(a, b) for a, b > 0 and x in 0 .. 1; NaN outside. The relative error is that of the
/// logarithms of the gamma function: about 1e-15 times their size.
pub fn incomplete_beta(a: f64, b: f64, x: f64) -> f64 {
    if !(a > 0.0 && b > 0.0 && (0.0..=1.0).contains(&x)) || a.is_infinite() || b.is_infinite() {
        return f64::NAN;
    }
    if x == 0.0 || x == 1.0 {
        return x;
    }
    let front = (a * x.ln() + b * (-x).ln_1p() - ln_beta(a, b)).exp();
    // Below its mode the continued fraction in x converges fast, above it the one in 1 - x.
    if x < (a + 1.0) / (a + b + 2.0) {
        front * continued_fraction(a, b, x) / a
    } else {
        1.0 - front * continued_fraction(b, a, 1.0 - x) / b
    }
}

/// ln B(a, b).
fn ln_beta(a: f64, b: f64) -> f64 {
    libm::lgamma(a) + libm::lgamma(b) - libm::lgamma(a + b)
}

/// The continued fraction of the incomplete beta function (DLMF 8.17.22) by the method of Lentz.
fn continued_fraction(a: f64, b: f64, x: f64) -> f64 {
    // Stands in for a zero in the recurrences; far below any term that counts.
    const TINY: f64 = 1e-300;
    let nonzero = |y: f64| if y.abs() < TINY { TINY } else { y };
    let mut c = 1.0;
    let mut d = nonzero(1.0 - (a + b) * x / (a + 1.0)).recip();
    let mut value = d;
    for m in 1..ROUNDS {
        let m = m as f64;
        let even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
        let odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        let mut factor = 1.0;
        for term in [even, odd] {
            d = nonzero(1.0 + term * d).recip();
            c = nonzero(1.0 + term / c);
            factor = c * d;
            value *= factor;
        }
        if (factor - 1.0).abs() <= f64::EPSILON {
            return value;
        }
    }
    f64::NAN
}

/// Probability that Student's t with `freedom` > 0 degrees of freedom lies farther from 0 than `t`, on both sides; NaN for a
/// `freedom` without meaning.
pub fn student_two_sided(t: f64, freedom: f64) -> f64 {
    if t.is_infinite() && freedom > 0.0 {
        return 0.0;
    }
    let square = t * t;
    if square < freedom {
        // x is near 1: its distance from 1 is the exact one.
        1.0 - incomplete_beta(0.5, 0.5 * freedom, square / (freedom + square))
    } else {
        incomplete_beta(0.5 * freedom, 0.5, freedom / (freedom + square))
    }
}

/// Probability that a standard normal number exceeds `x`; relative accuracy also far out.
pub fn normal_upper_tail(x: f64) -> f64 {
    0.5 * libm::erfc(x / SQRT_2)
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
    incomplete_beta(0.5 * below, 0.5 * above, below / (below + above * f))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn close(got: f64, want: f64, relative: f64) {
        assert!((got - want).abs() <= relative * want.abs(), "{got:e} {want:e}");
    }

    #[test]
    fn the_incomplete_beta_function_has_its_closed_forms() {
        for x in [1e-6, 0.1, 0.3, 0.5, 0.77, 0.999] {
            close(incomplete_beta(1.0, 1.0, x), x, 1e-14);
            close(incomplete_beta(2.0, 3.0, x), x * x * (6.0 - 8.0 * x + 3.0 * x * x), 1e-13);
            close(incomplete_beta(0.5, 0.5, x), 2.0 / PI * x.sqrt().asin(), 1e-13);
            close(incomplete_beta(7.5, 1.0, x), x.powf(7.5), 1e-13);
            close(incomplete_beta(4.5, 2.5, x) + incomplete_beta(2.5, 4.5, 1.0 - x), 1.0, 1e-13);
        }
        assert_eq!([0.0, 1.0].map(|x| incomplete_beta(3.0, 0.5, x)), [0.0, 1.0]);
        for [a, b, x] in [[0.0, 1.0, 0.5], [1.0, -1.0, 0.5], [1.0, 1.0, 1.1], [1.0, 1.0, f64::NAN]] {
            assert!(incomplete_beta(a, b, x).is_nan(), "{a} {b} {x}");
        }
    }

    #[test]
    fn students_law_has_its_closed_forms() {
        for t in [0.0_f64, 0.01, 0.4, 1.0, 2.5, 40.0, 1e6] {
            // 1 and 2 degrees of freedom; the complements are written without cancellation.
            let one = if t == 0.0 { 1.0 } else { 2.0 / PI * (1.0 / t).atan() };
            close(student_two_sided(t, 1.0), one, 1e-12);
            let root = (2.0 + t * t).sqrt();
            close(student_two_sided(t, 2.0), 2.0 / (root * (root + t)), 1e-12);
            assert_eq!(student_two_sided(t, 7.0), student_two_sided(-t, 7.0));
        }
        assert_eq!(student_two_sided(f64::NEG_INFINITY, 3.0), 0.0);
        assert!(student_two_sided(1.0, 0.0).is_nan() && student_two_sided(f64::NAN, 4.0).is_nan());
    }

    #[test]
    fn many_degrees_of_freedom_come_to_the_normal_law() {
        for t in [0.3, 1.96, 4.0] {
            close(student_two_sided(t, 1e8), 2.0 * normal_upper_tail(t), 1e-6);
        }
    }

    #[test]
    fn the_normal_tail_is_right_far_out() {
        close(normal_upper_tail(0.0), 0.5, 1e-16);
        close(normal_upper_tail(-1.0) + normal_upper_tail(1.0), 1.0, 1e-15);
        // Abramowitz and Stegun 26.2, and Mills' ratio at 12 by its asymptotic series.
        close(normal_upper_tail(1.0), 0.158_655_253_931_457_05, 1e-14);
        let x = 12.0_f64;
        let mills = (1.0 - 1.0 / 144.0 + 3.0 / 144f64.powi(2) - 15.0 / 144f64.powi(3)) / x;
        close(normal_upper_tail(x), (-0.5 * x * x).exp() / (2.0 * PI).sqrt() * mills, 3e-7);
    }

    #[test]
    fn fishers_law_has_its_closed_forms() {
        for t in [0.1_f64, 1.0, 3.0, 40.0] {
            // F with 2 degrees above: (1 + 2 f/n)^(-n/2).
            close(fisher_upper(t, 2.0, 7.0), (1.0 + 2.0 * t / 7.0).powf(-3.5), 1e-13);
            // t^2 with n is F with 1 and n.
            close(student_two_sided(t, 9.0), fisher_upper(t * t, 1.0, 9.0), 1e-13);
        }
        assert_eq!((fisher_upper(0.0, 2.0, 3.0), fisher_upper(f64::INFINITY, 2.0, 3.0)), (1.0, 0.0));
    }

    #[test]
    fn quantiles_are_those_of_the_tables() {
        for (level, freedom, table) in
            [(0.95, 1.0, 12.7062047364), (0.95, 10.0, 2.2281388520), (0.99, 30.0, 2.7499956536)]
        {
            let t = student_quantile(level, freedom);
            assert!((t - table).abs() < 1e-9, "{t} {table}");
            assert!((student_two_sided(t, freedom) - (1.0 - level)).abs() < 1e-12);
        }
        // Many degrees of freedom: the normal distribution.
        assert!((student_quantile(0.95, 1e7) - 1.959963985).abs() < 1e-6);
        assert!(student_quantile(1.0, 3.0).is_nan() && student_quantile(0.95, 0.0).is_nan());
    }
}
