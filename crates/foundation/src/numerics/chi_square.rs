//! The chi-square law, by the regularised incomplete gamma function: how far a standard deviation of a few values can be off.

use super::bisect;

/// Terms and steps beyond which series and continued fraction would not converge.
const ROUNDS: usize = 100_000;

/// The regularised lower incomplete gamma function P(a, x). NaN for a <= 0 or x < 0.
pub fn incomplete_gamma(a: f64, x: f64) -> f64 {
    if !(a > 0.0 && x >= 0.0) || a.is_infinite() {
        return f64::NAN;
    }
    if x == 0.0 || x.is_infinite() {
        return if x == 0.0 { 0.0 } else { 1.0 };
    }
    let front = (a * x.ln() - x - libm::lgamma(a)).exp();
    if x < a + 1.0 { front * series(a, x) } else { 1.0 - front * fraction(a, x) }
}

/// 1/a + x/(a (a+1)) + x^2/(a (a+1) (a+2)) + ...
fn series(a: f64, x: f64) -> f64 {
    let mut term = a.recip();
    let mut sum = term;
    for k in 1..ROUNDS {
        term *= x / (a + k as f64);
        sum += term;
        if term <= f64::EPSILON * sum {
            return sum;
        }
    }
    f64::NAN
}

/// The continued fraction of the upper function, by Lentz's method.
fn fraction(a: f64, x: f64) -> f64 {
    // Stands in for a zero in the recurrences; far below any term that counts.
    const TINY: f64 = 1e-300;
    let nonzero = |y: f64| if y.abs() < TINY { TINY } else { y };
    let mut b = x + 1.0 - a;
    let mut c = 1.0 / TINY;
    let mut d = nonzero(b).recip();
    let mut value = d;
    for k in 1..ROUNDS {
        let k = k as f64;
        let numerator = -k * (k - a);
        b += 2.0;
        d = nonzero(numerator * d + b).recip();
        c = nonzero(b + numerator / c);
        value *= c * d;
        if (c * d - 1.0).abs() <= f64::EPSILON {
            return value;
        }
    }
    f64::NAN
}

/// The value below which a chi-square number of these degrees of freedom lies with this probability. NaN for a probability that is not
/// between 0 and 1, or no degree of freedom.
pub fn chi_square_quantile(probability: f64, freedom: f64) -> f64 {
    if !(probability > 0.0 && probability < 1.0 && freedom > 0.0) {
        return f64::NAN;
    }
    let below = |x: f64| incomplete_gamma(0.5 * freedom, 0.5 * x) - probability;
    let mut high = freedom;
    while below(high) < 0.0 && high < f64::MAX / 2.0 {
        high *= 2.0;
    }
    bisect(0.0, high, below).unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_incomplete_gamma_function_has_its_closed_forms() {
        for x in [1e-9, 0.3, 1.0, 2.4, 9.0, 40.0] {
            assert!((incomplete_gamma(1.0, x) + (-x).exp_m1()).abs() < 1e-14, "{x}");
            let two = 1.0 - (-x).exp() * (1.0 + x);
            assert!((incomplete_gamma(2.0, x) - two).abs() < 1e-14, "{x}");
            assert!((incomplete_gamma(0.5, x) - libm::erf(x.sqrt())).abs() < 1e-14, "{x}");
        }
        assert_eq!([0.0, f64::INFINITY].map(|x| incomplete_gamma(3.0, x)), [0.0, 1.0]);
        for [a, x] in [[0.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [1.0, f64::NAN], [f64::NAN, 1.0]] {
            assert!(incomplete_gamma(a, x).is_nan(), "{a} {x}");
        }
    }

    #[test]
    fn quantiles_are_those_of_the_tables() {
        for (probability, freedom, table) in [
            (0.95, 1.0, 3.841_458_820_694),
            (0.95, 10.0, 18.307_038_053_275),
            (0.025, 10.0, 3.246_972_780_237),
            (0.975, 24.0, 39.364_077_026_603),
            (0.5, 2.0, 2.0 * std::f64::consts::LN_2),
        ] {
            let found = chi_square_quantile(probability, freedom);
            assert!((found - table).abs() < 1e-9, "{found} {table}");
        }
        assert!(chi_square_quantile(0.0, 3.0).is_nan() && chi_square_quantile(0.5, 0.0).is_nan());
    }
}
