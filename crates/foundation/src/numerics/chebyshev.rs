//! Chebyshev series of one variable: interpolation at Chebyshev nodes, evaluation with derivatives.

use super::Scalar;

/// A polynomial on `[a, b]` in Chebyshev form. Outside the interval the polynomial continues (callers guard it).
#[derive(Clone, Debug, PartialEq)]
pub struct Chebyshev {
    a: f64,
    b: f64,
    coefficients: Vec<f64>,
}

/// Whether `x` lies between `a` and `b`, with a margin of 1e-9 of their distance for rounding.
pub(super) fn covers((a, b): (f64, f64), x: f64) -> bool {
    let margin = 1e-9 * (b - a);
    x >= a - margin && x <= b + margin
}

impl Chebyshev {
    /// The `n` Chebyshev nodes (first kind) of `[a, b]`, ascending.
    pub fn nodes(a: f64, b: f64, n: usize) -> Vec<f64> {
        (0..n)
            .map(|k| {
                let angle = std::f64::consts::PI * (2 * (n - 1 - k) + 1) as f64 / (2 * n) as f64;
                0.5 * (a + b) + 0.5 * (b - a) * angle.cos()
            })
            .collect()
    }

    /// Interpolates values given at [`Chebyshev::nodes`]`(a, b, values.len())` in that order.
    pub fn interpolate(a: f64, b: f64, values: &[f64]) -> Self {
        let n = values.len();
        let coefficients = (0..n)
            .map(|j| {
                let sum: f64 = values
                    .iter()
                    .enumerate()
                    .map(|(k, value)| {
                        let angle = std::f64::consts::PI * (2 * (n - 1 - k) + 1) as f64 / (2 * n) as f64;
                        value * (j as f64 * angle).cos()
                    })
                    .sum();
                sum * if j == 0 { 1.0 } else { 2.0 } / n as f64
            })
            .collect();
        Self { a, b, coefficients }
    }

    /// Samples `f` at `n` nodes of `[a, b]` and interpolates; the first error ends it.
    pub fn fit<E>(a: f64, b: f64, n: usize, f: impl FnMut(f64) -> Result<f64, E>) -> Result<Self, E> {
        let values = Self::nodes(a, b, n).into_iter().map(f).collect::<Result<Vec<_>, E>>()?;
        Ok(Self::interpolate(a, b, &values))
    }

    /// sum c_j T_j on `[a, b]`.
    pub fn from_coefficients(a: f64, b: f64, coefficients: Vec<f64>) -> Self {
        Self { a, b, coefficients }
    }

    /// The constant function `value` on `[a, b]`.
    pub fn constant(a: f64, b: f64, value: f64) -> Self {
        Self { a, b, coefficients: vec![value] }
    }

    /// The interval the series was made for.
    pub fn interval(&self) -> (f64, f64) {
        (self.a, self.b)
    }

    /// The Chebyshev coefficients c_0, c_1, ... of sum c_j T_j.
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients
    }

    /// Whether `x` lies in the interval, with a margin of 1e-9 of its length for rounding.
    pub fn covers(&self, x: f64) -> bool {
        covers(self.interval(), x)
    }

    /// Value at `x` (Clenshaw's recurrence).
    pub fn value<T: Scalar>(&self, x: T) -> T {
        let t = (x * 2.0 - (self.a + self.b)) / (self.b - self.a);
        let twice = t * 2.0;
        let mut b1 = T::from(0.0);
        let mut b2 = T::from(0.0);
        for &c in self.coefficients.iter().skip(1).rev() {
            let b0 = twice * b1 - b2 + c;
            b2 = b1;
            b1 = b0;
        }
        t * b1 - b2 + self.coefficients.first().copied().unwrap_or(0.0)
    }

    /// Value, first and second derivative at `x` in one pass of the recurrence.
    pub fn jet(&self, x: f64) -> [f64; 3] {
        let scale = 2.0 / (self.b - self.a);
        let t = (2.0 * x - (self.a + self.b)) / (self.b - self.a);
        let twice = 2.0 * t;
        let (mut b1, mut b2) = ([0.0; 3], [0.0; 3]);
        for &c in self.coefficients.iter().skip(1).rev() {
            let b0 = [
                twice * b1[0] - b2[0] + c,
                twice * b1[1] + 2.0 * b1[0] - b2[1],
                twice * b1[2] + 4.0 * b1[1] - b2[2],
            ];
            (b1, b2) = (b0, b1);
        }
        let constant = self.coefficients.first().copied().unwrap_or(0.0);
        [
            t * b1[0] - b2[0] + constant,
            (t * b1[1] + b1[0] - b2[1]) * scale,
            (t * b1[2] + 2.0 * b1[1] - b2[2]) * (scale * scale),
        ]
    }

    /// The series times a factor.
    pub fn scaled(&self, factor: f64) -> Self {
        Self { coefficients: self.coefficients.iter().map(|c| c * factor).collect(), ..*self }
    }

    /// The series plus a constant.
    pub fn raised(&self, by: f64) -> Self {
        let mut coefficients = self.coefficients.clone();
        match coefficients.first_mut() {
            Some(first) => *first += by,
            None => coefficients.push(by),
        }
        Self { coefficients, ..*self }
    }

    /// What the nodes of an interpolation may miss: the sum of the last quarter of the coefficients.
    pub fn tail(&self) -> f64 {
        let count = self.coefficients.len();
        self.coefficients[count - count / 4..].iter().map(|c| c.abs()).sum()
    }

    /// The series without trailing coefficients below `relative` times the largest one.
    pub fn truncated(mut self, relative: f64) -> Self {
        let limit = relative * self.coefficients.iter().fold(0.0, |m: f64, c| m.max(c.abs()));
        while self.coefficients.len() > 1 && self.coefficients.last().is_some_and(|c| c.abs() <= limit) {
            self.coefficients.pop();
        }
        self
    }

    /// The integral from the lower end of the interval as a series of its own.
    pub fn integral(&self) -> Self {
        let at = |j: usize| self.coefficients.get(j).copied().unwrap_or(0.0);
        // The integral of T_j is (T_(j+1)/(j+1) - T_(j-1)/(j-1))/2; T_0 counts twice.
        let count = self.coefficients.len();
        let scale = 0.5 * (self.b - self.a);
        let mut integral = vec![0.0; count + 1];
        for (j, coefficient) in integral.iter_mut().enumerate().skip(1) {
            let before = if j == 1 { 2.0 * at(0) } else { at(j - 1) };
            *coefficient = scale * (before - at(j + 1)) / (2 * j) as f64;
        }
        // Nothing at the lower end, where T_j = (-1)^j.
        let below: f64 = integral.iter().enumerate().map(|(j, c)| if j % 2 == 0 { *c } else { -c }).sum();
        integral[0] -= below;
        Self { coefficients: integral, ..*self }
    }

    /// The derivative as a series of its own.
    pub fn derivative(&self) -> Self {
        let n = self.coefficients.len();
        let mut d = vec![0.0; n.max(2) + 1];
        for j in (1..n).rev() {
            d[j - 1] = d[j + 1] + 2.0 * j as f64 * self.coefficients[j];
        }
        d[0] *= 0.5;
        d.truncate(n.saturating_sub(1).max(1));
        let scale = 2.0 / (self.b - self.a);
        d.iter_mut().for_each(|c| *c *= scale);
        Self { a: self.a, b: self.b, coefficients: d }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn interpolates_and_differentiates() {
        let series = Chebyshev::fit(1.0, 3.0, 24, |x: f64| Ok::<_, ()>((2.0 * x).sin())).unwrap();
        let derivative = series.derivative();
        for k in 0..=20 {
            let x = 1.0 + 0.1 * k as f64;
            assert!((series.value(x) - (2.0 * x).sin()).abs() < 1e-14);
            assert!((derivative.value(x) - 2.0 * (2.0 * x).cos()).abs() < 1e-12);
            let bend = derivative.derivative().value(x);
            for (a, b) in series.jet(x).into_iter().zip([series.value(x), derivative.value(x), bend]) {
                assert!((a - b).abs() < 1e-11, "{x}: {a} {b}");
            }
        }
        assert_eq!(Chebyshev::constant(0.0, 1.0, 4.0).value(0.3), 4.0);
        assert_eq!(Chebyshev::constant(0.0, 1.0, 4.0).derivative().value(0.3), 0.0);
        assert_eq!(Chebyshev::constant(0.0, 1.0, 4.0).jet(0.3), [4.0, 0.0, 0.0]);
    }
}
