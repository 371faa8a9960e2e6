//! The inverse of a strictly monotone motion law: at which feed an axis stands where. Knows no axis by name.

use super::{LawError, MotionLaw};
use crate::numerics::Chebyshev;

/// Values that exceed an end of the range by this share belong to the end: rounding by the program that computed them.
const END: f64 = 1e-12;

/// The inverse of a law that rises or falls strictly on an interval.
#[derive(Clone, Debug, PartialEq)]
pub struct InverseLaw {
    law: MotionLaw,
    domain: [f64; 2],
    /// Values at both ends of the domain.
    ends: [f64; 2],
}

impl InverseLaw {
    /// Prepares the inverse of `law` on `domain` (ascending).
    ///
    /// # Errors
    /// `NotFinite` and `NotAscending` for a bad domain, `OutsideRange` for a domain beyond the interval of a series, `NotMonotone`
    /// with a place where the derivative vanishes or changes its sign.
    pub fn new(law: MotionLaw, domain: [f64; 2]) -> Result<Self, LawError> {
        let [a, b] = domain;
        if let Some(index) = domain.iter().position(|x| !x.is_finite()) {
            return Err(LawError::NotFinite { index });
        }
        if b <= a {
            return Err(LawError::NotAscending { index: 1 });
        }
        if let Some(at) = stationary(&law, domain)? {
            return Err(LawError::NotMonotone { at });
        }
        let ends = domain.map(|x| law.value(x));
        Ok(Self { law, domain, ends })
    }

    /// The law itself.
    pub fn law(&self) -> &MotionLaw {
        &self.law
    }

    /// The interval of arguments on which the law is inverted.
    pub fn domain(&self) -> [f64; 2] {
        self.domain
    }

    /// The values that the law takes there, ascending.
    pub fn range(&self) -> [f64; 2] {
        let [a, b] = self.ends;
        [a.min(b), a.max(b)]
    }

    /// The argument at which the law has the value y: Newton inside a bracket that bisection narrows.
    ///
    /// # Errors
    /// `OutsideRange`.
    pub fn argument(&self, y: f64) -> Result<f64, LawError> {
        let [from, to] = self.range();
        let margin = END * (1.0 + from.abs().max(to.abs()));
        // Written so that NaN is outside.
        let inside = y >= from - margin && y <= to + margin;
        if !inside {
            return Err(LawError::OutsideRange { value: y, from, to });
        }
        let [[mut a, mut b], [fa, fb]] = [self.domain, self.ends];
        let rising = fb > fa;
        let mut x = (a + (y - fa) / (fb - fa) * (b - a)).clamp(a, b);
        // Each round halves the bracket or is a Newton step, which converges quadratically near the root; 200 is out of reach.
        for _ in 0..200 {
            let [f, slope, _] = self.law.jet(x);
            if f == y {
                return Ok(x);
            }
            if (f < y) == rising {
                a = x
            } else {
                b = x
            }
            let newton = x - (f - y) / slope;
            let last = x;
            x = if newton > a && newton < b { newton } else { 0.5 * (a + b) };
            if (x - last).abs() <= 2.0 * f64::EPSILON * x.abs() || x == a || x == b {
                break;
            }
        }
        Ok(x)
    }

    /// `[x, dx/dy, d2x/dy2]` of the inverse at the value y.
    ///
    /// # Errors
    /// `OutsideRange`.
    pub fn jet(&self, y: f64) -> Result<[f64; 3], LawError> {
        let x = self.argument(y)?;
        let [_, f1, f2] = self.law.jet(x);
        Ok([x, 1.0 / f1, -f2 / (f1 * f1 * f1)])
    }
}

/// A place in the interval where the derivative is not of the sign of the whole rise, if there is one.
fn stationary(law: &MotionLaw, [a, b]: [f64; 2]) -> Result<Option<f64>, LawError> {
    let sign = (law.value(b) - law.value(a)).signum();
    let good = |x: f64| law.jet(x)[1] * sign > 0.0;
    match law {
        MotionLaw::Pieces(pieces) => {
            // The derivative of a cubic is least at an end of its piece or at its vertex. Ends are taken from both sides.
            let breaks = pieces.breaks();
            for (k, [_, c1, c2, c3]) in pieces.pieces().iter().enumerate() {
                let (lo, hi) = (breaks[k].max(a), breaks[k + 1].min(b));
                if hi <= lo {
                    continue;
                }
                let vertex = breaks[k] - c2 / (3.0 * c3);
                for x in [lo, hi, vertex].into_iter().filter(|x| (lo..=hi).contains(x)) {
                    let t = x - breaks[k];
                    // NaN is no sign either.
                    let steep = (c1 + t * (2.0 * c2 + 3.0 * t * c3)) * sign > 0.0;
                    if !steep {
                        return Ok(Some(x));
                    }
                }
            }
            // The tangents beyond the ends.
            Ok([a, b].into_iter().find(|&x| !good(x)))
        }
        MotionLaw::Series(series) if !covers(series, a, b) => {
            let (from, to) = series[0].interval();
            let value = if (from..=to).contains(&a) { b } else { a };
            Err(LawError::OutsideRange { value, from, to })
        }
        _ => Ok(subdivide(&good, law, largest_bend(law, [a, b]), a, b)),
    }
}

fn covers(series: &[Chebyshev; 3], a: f64, b: f64) -> bool {
    let (from, to) = series[0].interval();
    (from..=to).contains(&a) && (from..=to).contains(&b)
}

/// A bound of |f''| on [a, b].
fn largest_bend(law: &MotionLaw, [a, b]: [f64; 2]) -> f64 {
    match law {
        MotionLaw::Polynomial { origin, coefficients } => {
            let reach = (a - origin).abs().max((b - origin).abs());
            let bend = |k: usize, c: &f64| c.abs() * (k * k.saturating_sub(1)) as f64 * power(reach, k);
            coefficients.iter().enumerate().map(|(k, c)| bend(k, c)).sum()
        }
        // A Chebyshev series is nowhere larger than the sum of its coefficients.
        MotionLaw::Series(series) => series[2].coefficients().iter().map(|c| c.abs()).sum(),
        MotionLaw::BSpline { spline, stretch, factor } => {
            let (a, b) = ((stretch * a).min(stretch * b), (stretch * a).max(stretch * b));
            factor.abs() * stretch * stretch * spline.largest_bend([a, b])
        }
        MotionLaw::Sum(laws) => laws.iter().map(|law| largest_bend(law, [a, b])).sum(),
        // Its slope may jump, so that nothing can be proved of a sum with it.
        MotionLaw::Pieces(_) => f64::INFINITY,
    }
}

/// reach^(k-2) for k >= 2, 0 below.
fn power(reach: f64, k: usize) -> f64 {
    if k < 2 { 0.0 } else { reach.powi(k as i32 - 2) }
}

/// Halves the interval until `bound`, a bound of the second derivative, proves the sign of the first in every part.
fn subdivide(good: &impl Fn(f64) -> bool, law: &MotionLaw, bound: f64, a: f64, b: f64) -> Option<f64> {
    // Parts so short where the derivative is still within its bound of zero: no inverse that could be evaluated.
    let least = 1e-9 * (b - a);
    let mut parts = vec![(a, b)];
    while let Some((a, b)) = parts.pop() {
        let middle = 0.5 * (a + b);
        if !good(middle) {
            return Some(middle);
        }
        let proven = law.jet(middle)[1].abs() > bound * 0.5 * (b - a);
        if proven {
            continue;
        }
        if b - a < least {
            return Some(middle);
        }
        parts.extend([(a, middle), (middle, b)]);
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn laws() -> Vec<MotionLaw> {
        let x = [-2.0, -0.5, 0.0, 1.5, 2.0, 3.0];
        let y = [-3.0, -1.0, 0.0, 0.2, 0.4, 5.0];
        let smooth = |x: f64| 0.3 * x + 0.2 * (0.8 * x).sin() + 0.01 * x * x;
        vec![
            MotionLaw::polynomial(0.5, vec![1.0, -2.0, 0.1, -0.25]),
            MotionLaw::series(Chebyshev::fit(-2.0, 3.0, 24, |x| Ok::<_, ()>(smooth(x))).unwrap()),
            MotionLaw::broken_line(&x, &y).unwrap(),
            MotionLaw::rounded_line(&x, &y, 0.2).unwrap(),
            MotionLaw::monotone(&x, &y).unwrap().scaled(-1.0),
        ]
    }

    #[test]
    fn there_and_back_is_the_same_place() {
        for (k, law) in laws().into_iter().enumerate() {
            let inverse = InverseLaw::new(law.clone(), [-2.0, 3.0]).unwrap();
            for i in 0..=97 {
                let x = (-2.0 + 5.0 * f64::from(i) / 97.0).min(3.0);
                assert!((inverse.argument(law.value(x)).unwrap() - x).abs() < 1e-12, "law {k} at {x}");
            }
        }
    }

    #[test]
    fn derivatives_are_those_of_the_inverse() {
        for (k, law) in laws().into_iter().enumerate() {
            let inverse = InverseLaw::new(law, [-2.0, 3.0]).unwrap();
            let [from, to] = inverse.range();
            for i in 1..40 {
                let (y, h) = (from + (to - from) * (f64::from(i) / 40.0 + 0.0013), 1e-6);
                let at = |y: f64| inverse.jet(y).unwrap();
                // Not across a breakpoint, where derivatives of higher order jump.
                if (at(y + h)[2] - at(y - h)[2]).abs() > 1e-2 {
                    continue;
                }
                let first = (at(y + h)[0] - at(y - h)[0]) / (2.0 * h);
                let second = (at(y + h)[1] - at(y - h)[1]) / (2.0 * h);
                assert!((at(y)[1] - first).abs() < 1e-6 * (1.0 + first.abs()), "law {k} at {y}");
                assert!((at(y)[2] - second).abs() < 1e-4 * (1.0 + second.abs()), "law {k} at {y}");
            }
        }
    }

    #[test]
    fn laws_without_an_inverse_are_refused() {
        let error = |law: MotionLaw, domain| InverseLaw::new(law, domain).unwrap_err().code();
        let level = MotionLaw::broken_line(&[0.0, 1.0, 2.0, 3.0], &[0.0, 1.0, 1.0, 2.0]).unwrap();
        assert_eq!(error(level.clone(), [0.0, 3.0]), "law-not-monotone");
        assert!(InverseLaw::new(level.clone(), [-4.0, 0.9]).is_ok());
        assert_eq!(error(level, [0.5, 1.5]), "law-not-monotone");
        assert_eq!(error(MotionLaw::zero(), [0.0, 1.0]), "law-not-monotone");
        // Rises as a whole, falls a little around 0.
        let wave = MotionLaw::polynomial(0.0, vec![0.0, -1e-4, 0.0, 1.0]);
        assert_eq!(error(wave.clone(), [-1.0, 1.0]), "law-not-monotone");
        assert!(InverseLaw::new(wave, [0.006, 1.0]).is_ok());
        let cubic = MotionLaw::polynomial(0.0, vec![0.0, 0.0, 0.0, 1.0]);
        assert_eq!(error(cubic, [-1.0, 1.0]), "law-not-monotone");
        let series = MotionLaw::series(Chebyshev::fit(0.0, 1.0, 3, Ok::<_, ()>).unwrap());
        assert_eq!(error(series, [0.0, 1.5]), "law-outside-range");
        let line = MotionLaw::polynomial(0.0, vec![0.0, 1.0]);
        assert_eq!(error(line.clone(), [0.0, f64::NAN]), "law-not-finite");
        assert_eq!(error(line.clone(), [1.0, 0.0]), "law-not-ascending");
        let inverse = InverseLaw::new(line, [0.0, 1.0]).unwrap();
        for y in [-0.1, 1.1, f64::NAN] {
            assert_eq!(inverse.jet(y).unwrap_err().code(), "law-outside-range");
        }
    }
}
