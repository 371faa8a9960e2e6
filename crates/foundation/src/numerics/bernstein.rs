//! Bernstein coefficients of cubics: a polynomial over an interval stays between the least and the largest of them.

/// A cubic (ascending powers of the distance from an origin) about another origin, `by` further on.
#[inline]
pub(super) fn shifted([a, b, c, d]: [f64; 4], by: f64) -> [f64; 4] {
    [a + by * (b + by * (c + by * d)), b + by * (2.0 * c + by * 3.0 * d), c + 3.0 * by * d, d]
}

/// The derivative of a cubic, as a cubic.
#[inline]
pub(super) fn derivative([_, b, c, d]: [f64; 4]) -> [f64; 4] {
    [b, 2.0 * c, 3.0 * d, 0.0]
}

/// The Bernstein coefficients of degree 3 of a cubic between its origin and `width`.
#[inline]
pub(super) fn bernstein([a, b, c, d]: [f64; 4], width: f64) -> [f64; 4] {
    let (b, c, d) = (b * width, c * width * width, d * width * width * width);
    [a, a + b / 3.0, a + (2.0 * b + c) / 3.0, a + b + c + d]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shifting_and_the_ends_of_the_coefficients_agree_with_the_polynomial() {
        let cubic = [0.3, -1.2, 2.5, -0.7];
        let value = |x: f64| cubic[0] + x * (cubic[1] + x * (cubic[2] + x * cubic[3]));
        let (from, width) = (0.4, 1.1);
        let [first, second, third, last] = bernstein(shifted(cubic, from), width);
        assert!((first - value(from)).abs() < 1e-15 && (last - value(from + width)).abs() < 1e-15);
        let middle = (first + 3.0 * (second + third) + last) / 8.0;
        assert!((middle - value(from + width / 2.0)).abs() < 1e-15);
        assert_eq!(derivative(cubic), [-1.2, 5.0, 3.0 * -0.7, 0.0]);
    }
}
