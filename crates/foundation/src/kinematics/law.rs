//! Motion laws: how one axis follows another, as plain data with derivatives.

use super::{LawError, PiecewisePolynomial};
use crate::numerics::{BSpline, Chebyshev, Scalar, equidistant, value_of};
use std::sync::Arc;

/// Points of a smoothed law.
const SMOOTH_POINTS: usize = 257;

/// A smooth function of one machine coordinate. Units are those of the axis per mm of the argument.
#[derive(Clone, Debug, PartialEq)]
pub enum MotionLaw {
    /// sum c_k (x - origin)^k.
    Polynomial {
        /// Origin, mm.
        origin: f64,
        /// c_0, c_1, ...
        coefficients: Vec<f64>,
    },
    /// A Chebyshev series with its first two derivatives at hand.
    Series(Box<[Chebyshev; 3]>),
    /// Polynomials up to third degree between breakpoints.
    Pieces(PiecewisePolynomial),
    /// factor * spline(stretch * x); beyond its interval the border pieces of the spline continue.
    BSpline {
        /// The function.
        spline: Arc<BSpline>,
        /// Its argument per mm.
        stretch: f64,
        /// Units of the axis per value.
        factor: f64,
    },
    /// Laws that add up.
    Sum(Vec<MotionLaw>),
}

impl MotionLaw {
    /// The law that is zero everywhere.
    pub fn zero() -> Self {
        Self::polynomial(0.0, Vec::new())
    }

    /// sum c_k (x - origin)^k.
    pub fn polynomial(origin: f64, coefficients: Vec<f64>) -> Self {
        Self::Polynomial { origin, coefficients }
    }

    /// A law from a series.
    pub fn series(series: Chebyshev) -> Self {
        let first = series.derivative();
        let second = first.derivative();
        Self::Series(Box::new([series, first, second]))
    }

    /// Straight lines through the points (x, y): C0.
    ///
    /// # Errors
    /// Those of [`PiecewisePolynomial::broken_line`].
    pub fn broken_line(x: &[f64], y: &[f64]) -> Result<Self, LawError> {
        PiecewisePolynomial::broken_line(x, y).map(Self::Pieces)
    }

    /// Straight lines through the points with parabolas over +-`half_length` at the corners: C1.
    ///
    /// # Errors
    /// Those of [`PiecewisePolynomial::rounded_line`].
    pub fn rounded_line(x: &[f64], y: &[f64], half_length: f64) -> Result<Self, LawError> {
        PiecewisePolynomial::rounded_line(x, y, half_length).map(Self::Pieces)
    }

    /// Straight lines through the points with parabolas at the corners, each over half of the shorter line beside it: C1.
    ///
    /// # Errors
    /// Those of [`PiecewisePolynomial::rounded_corners`].
    pub fn rounded_corners(x: &[f64], y: &[f64]) -> Result<Self, LawError> {
        PiecewisePolynomial::rounded_corners(x, y).map(Self::Pieces)
    }

    /// Monotone cubic interpolation of the points (Fritsch-Carlson): C1.
    ///
    /// # Errors
    /// Those of [`PiecewisePolynomial::monotone`].
    pub fn monotone(x: &[f64], y: &[f64]) -> Result<Self, LawError> {
        PiecewisePolynomial::monotone(x, y).map(Self::Pieces)
    }

    /// The interpolating cubic spline through at least four points: C2, what the exact contact asks of a law
    /// (`docs/mathematics/generating-contact.md#exact-contact`).
    ///
    /// # Errors
    /// Those of [`PiecewisePolynomial::spline`].
    pub fn spline(x: &[f64], y: &[f64]) -> Result<Self, LawError> {
        PiecewisePolynomial::spline(x, y).map(Self::Pieces)
    }

    /// The law over a domain as a spline through 257 of its points: C2. Over some 40 mm it misses a law whose curvature jumps
    /// by less than 1e-4 mm; who plans with it must also simulate with it.
    ///
    /// # Errors
    /// Those of [`Self::spline`].
    pub fn smooth(&self, domain: [f64; 2]) -> Result<Self, LawError> {
        let x = equidistant(domain, SMOOTH_POINTS);
        let y: Vec<f64> = x.iter().map(|&at| self.value(at)).collect();
        Self::spline(&x, &y)
    }

    /// `[f, f', f'']` at x.
    pub fn jet(&self, x: f64) -> [f64; 3] {
        match self {
            Self::Polynomial { origin, coefficients } => {
                let h = x - origin;
                let mut jet = [0.0; 3];
                for &c in coefficients.iter().rev() {
                    jet[2] = jet[2] * h + 2.0 * jet[1];
                    jet[1] = jet[1] * h + jet[0];
                    jet[0] = jet[0] * h + c;
                }
                jet
            }
            Self::Series(s) => [s[0].value(x), s[1].value(x), s[2].value(x)],
            Self::Pieces(p) => p.jet(x),
            Self::BSpline { spline, stretch, factor } => {
                let [f0, f1, f2] = spline.jet(stretch * x);
                [factor * f0, factor * stretch * f1, factor * stretch * stretch * f2]
            }
            Self::Sum(laws) => laws.iter().fold([0.0; 3], |sum, law| {
                let jet = law.jet(x);
                std::array::from_fn(|k| sum[k] + jet[k])
            }),
        }
    }

    /// Value at x.
    pub fn value(&self, x: f64) -> f64 {
        self.jet(x)[0]
    }

    /// Value and first derivative for a dual argument, exact to first order.
    pub fn lifted<T: Scalar>(&self, x: T) -> [T; 2] {
        let at = value_of(x);
        let [f0, f1, f2] = self.jet(at);
        let dx = x - at;
        [dx * f1 + f0, dx * f2 + f1]
    }

    /// The law times a factor.
    pub fn scaled(&self, factor: f64) -> Self {
        match self {
            Self::Polynomial { origin, coefficients } => Self::Polynomial {
                origin: *origin,
                coefficients: coefficients.iter().map(|c| c * factor).collect(),
            },
            Self::Series(s) => Self::series(s[0].scaled(factor)),
            Self::Pieces(p) => Self::Pieces(p.scaled(factor)),
            Self::BSpline { spline, stretch, factor: own } => {
                Self::BSpline { spline: spline.clone(), stretch: *stretch, factor: own * factor }
            }
            Self::Sum(laws) => Self::Sum(laws.iter().map(|law| law.scaled(factor)).collect()),
        }
    }

    /// The law plus a constant.
    pub fn raised(&self, by: f64) -> Self {
        match self {
            Self::Polynomial { origin, coefficients } => {
                let mut coefficients = coefficients.clone();
                match coefficients.first_mut() {
                    Some(first) => *first += by,
                    None => coefficients.push(by),
                }
                Self::Polynomial { origin: *origin, coefficients }
            }
            Self::Series(s) => Self::series(s[0].raised(by)),
            Self::Pieces(p) => Self::Pieces(p.raised(by)),
            Self::BSpline { .. } => Self::Sum(vec![self.clone(), Self::polynomial(0.0, vec![by])]),
            Self::Sum(laws) => {
                let constant = Self::polynomial(0.0, vec![by]);
                Self::Sum(laws.iter().cloned().chain([constant]).collect())
            }
        }
    }

    /// Whether the law is a straight line, by its form.
    pub fn is_affine(&self) -> bool {
        matches!(self, Self::Polynomial { coefficients, .. } if coefficients.iter().skip(2).all(|&c| c == 0.0))
    }

    /// Whether the law stands still, by its form.
    pub fn is_constant(&self) -> bool {
        matches!(self, Self::Polynomial { coefficients, .. } if coefficients.iter().skip(1).all(|&c| c == 0.0))
    }

    /// Whether the law is constant zero.
    pub fn is_zero(&self) -> bool {
        match self {
            Self::Polynomial { coefficients, .. } => coefficients.iter().all(|&c| c == 0.0),
            Self::Series(s) => s[0].coefficients().iter().all(|&c| c == 0.0),
            Self::Pieces(p) => p.pieces().iter().flatten().all(|&c| c == 0.0),
            Self::BSpline { spline, factor, .. } => {
                *factor == 0.0 || spline.coefficients().iter().all(|&c| c == 0.0)
            }
            Self::Sum(laws) => laws.iter().all(Self::is_zero),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::BSplineBasis;

    #[test]
    fn polynomial_and_series_agree_with_their_derivatives() {
        let law = MotionLaw::polynomial(0.5, vec![1.0, -2.0, 0.5, 0.25]);
        let f = |x: f64| 1.0 - 2.0 * (x - 0.5) + 0.5 * (x - 0.5).powi(2) + 0.25 * (x - 0.5).powi(3);
        let series = MotionLaw::series(Chebyshev::fit(-1.0, 3.0, 6, |x| Ok::<_, ()>(f(x))).unwrap());
        for x in [-0.9, 0.0, 1.3, 2.9] {
            let (a, b) = (law.jet(x), series.jet(x));
            assert!((a[0] - f(x)).abs() < 1e-14);
            for k in 0..3 {
                assert!((a[k] - b[k]).abs() < 1e-12, "{x} {k}");
            }
            assert!((law.scaled(2.0).value(x) - 2.0 * f(x)).abs() < 1e-13);
        }
        assert!(MotionLaw::zero().is_zero() && !law.is_zero());
    }

    #[test]
    fn a_sum_with_a_spline_adds_values_and_derivatives() {
        let basis = BSplineBasis::uniform([-1.0, 1.0], 4, 5, &[]).unwrap();
        let spline = BSpline::new(basis, (0..9).map(|j| f64::from(j).sin()).collect()).unwrap();
        let polynomial = MotionLaw::polynomial(0.0, vec![0.5, -1.0, 2.0]);
        let drawn = MotionLaw::BSpline { spline: Arc::new(spline.clone()), stretch: -0.5, factor: 3.0 };
        let sum = MotionLaw::Sum(vec![polynomial.clone(), drawn]);
        for x in [-0.8, 0.1, 1.2] {
            let (a, b, c) = (sum.jet(x), polynomial.jet(x), spline.jet(-0.5 * x));
            for (k, chain) in [3.0, -1.5, 0.75].into_iter().enumerate() {
                assert!((a[k] - b[k] - chain * c[k]).abs() < 1e-13);
            }
            assert!((sum.scaled(-3.0).raised(1.0).value(x) - (1.0 - 3.0 * a[0])).abs() < 1e-13);
        }
        assert!(!sum.is_zero() && sum.scaled(0.0).is_zero());
    }
}
