//! A cubic of one parameter.

/// A cubic of u in 0..1 that starts where its axis stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CubicSpan {
    /// Value at u = 1, mm or rad.
    pub end: f64,
    /// Derivative with respect to u at u = 0.
    pub start_slope: f64,
    /// Derivative with respect to u at u = 1.
    pub end_slope: f64,
}

impl CubicSpan {
    /// c_0 .. c_3 of sum c_k u^k, from the value at u = 0.
    pub fn coefficients(&self, start: f64) -> [f64; 4] {
        let rise = self.end - start;
        [
            start,
            self.start_slope,
            3.0 * rise - 2.0 * self.start_slope - self.end_slope,
            self.start_slope + self.end_slope - 2.0 * rise,
        ]
    }

    /// Value at u, from the value at u = 0.
    pub fn value(&self, start: f64, u: f64) -> f64 {
        let [c0, c1, c2, c3] = self.coefficients(start);
        c0 + u * (c1 + u * (c2 + u * c3))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cubic_has_the_values_and_slopes_it_was_given() {
        let span = CubicSpan { end: 3.0, start_slope: -2.0, end_slope: 5.0 };
        let h = 1e-6;
        assert_eq!((span.value(1.0, 0.0), span.value(1.0, 1.0)), (1.0, 3.0));
        assert!(((span.value(1.0, h) - 1.0) / h + 2.0).abs() < 1e-4);
        assert!(((3.0 - span.value(1.0, 1.0 - h)) / h - 5.0).abs() < 1e-4);
    }
}
