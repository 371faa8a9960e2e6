//! What can be said about a formula over the whole field without computing it everywhere: an interval that holds its
//! values, how smooth it is, and the polynomial if it is one.

use super::function::Function;
use crate::modification::HIGHEST_DEGREE;
use crate::modification::smoothness::Smoothness;
use crate::numerics::Polynomial2;

/// Knowledge about one part of a formula.
#[derive(Clone, Debug)]
pub(super) struct Known {
    /// All values lie between these.
    pub range: [f64; 2],
    /// At least so smooth inside the field.
    pub smoothness: Smoothness,
    /// In (w - w_m, z - z_m), if the part is a polynomial of moderate degree.
    pub polynomial: Option<Polynomial2>,
    /// A smooth function cut off at zero: powers of it are smoother than it is.
    ramp: bool,
}

const EVERYTHING: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

impl Known {
    pub(super) fn constant(c: f64) -> Self {
        Self::smooth([c, c], Some(Polynomial2::constant(c)))
    }

    pub(super) fn smooth(range: [f64; 2], polynomial: Option<Polynomial2>) -> Self {
        Self { range, smoothness: Smoothness::Cinf, polynomial, ramp: false }
    }

    fn new(range: [f64; 2], smoothness: Smoothness) -> Self {
        // A bound that came about as infinity less infinity says nothing.
        let range = if range[0] <= range[1] { range } else { EVERYTHING };
        Self { range, smoothness, polynomial: None, ramp: false }
    }

    fn value(&self) -> Option<f64> {
        (self.range[0] == self.range[1]).then_some(self.range[0])
    }

    fn is_positive(&self) -> bool {
        self.range[0] > 0.0
    }

    fn misses_zero(&self) -> bool {
        self.range[0] > 0.0 || self.range[1] < 0.0
    }

    pub(super) fn negated(self) -> Self {
        let [low, high] = self.range;
        let polynomial = self.polynomial.as_ref().map(|p| p.scale(-1.0));
        Self { polynomial, ramp: self.ramp, ..Self::new([-high, -low], self.smoothness) }
    }

    pub(super) fn plus(self, other: Self) -> Self {
        let range = [self.range[0] + other.range[0], self.range[1] + other.range[1]];
        let polynomial = self.polynomial.as_ref().zip(other.polynomial.as_ref()).map(|(a, b)| a.add(b));
        Self { polynomial, ..Self::new(range, self.smoothness.min(other.smoothness)) }
    }

    pub(super) fn times(self, other: Self) -> Self {
        let range = products(self.range, other.range);
        let polynomial =
            self.polynomial.as_ref().zip(other.polynomial.as_ref()).and_then(|(a, b)| multiplied(a, b));
        let scaled_ramp = self.ramp && other.value().is_some() || other.ramp && self.value().is_some();
        Self { polynomial, ramp: scaled_ramp, ..Self::new(range, self.smoothness.min(other.smoothness)) }
    }

    pub(super) fn over(self, other: Self) -> Self {
        if !other.misses_zero() {
            return Self::new(EVERYTHING, Smoothness::C0);
        }
        let inverse = match other.value() {
            Some(c) => Self::constant(1.0 / c),
            None => Self::new([1.0 / other.range[1], 1.0 / other.range[0]], other.smoothness),
        };
        self.times(inverse)
    }

    pub(super) fn raised(self, exponent: Self) -> Self {
        let Some(p) = exponent.value() else {
            let smoothness = self.smoothness.min(exponent.smoothness);
            return Self::new(EVERYTHING, if self.is_positive() { smoothness } else { Smoothness::C0 });
        };
        let [low, high] = self.range;
        let whole = p.fract() == 0.0;
        let (a, b) = (low.powf(p), high.powf(p));
        let range = if self.is_positive() || (whole && p > 0.0 && p % 2.0 != 0.0) || (low >= 0.0 && p > 0.0) {
            [a.min(b), a.max(b)]
        } else if whole && p >= 0.0 {
            [if low <= 0.0 && high >= 0.0 { 0.0 } else { a.min(b) }, a.max(b)]
        } else {
            EVERYTHING
        };
        let smoothness = match () {
            () if self.ramp && !self.is_positive() => of_power(p),
            () if self.is_positive() || (whole && p >= 0.0) || (whole && self.misses_zero()) => {
                self.smoothness
            }
            () => of_power(p).min(self.smoothness),
        };
        let polynomial = self.polynomial.as_ref().filter(|q| {
            whole && p >= 0.0 && q.degree() as f64 * p <= HIGHEST_DEGREE as f64 && p <= HIGHEST_DEGREE as f64
        });
        let polynomial = polynomial.and_then(|q| {
            (0..p as usize).try_fold(Polynomial2::constant(1.0), |power, _| multiplied(&power, q))
        });
        Self { polynomial, ..Self::new(range, smoothness) }
    }

    pub(super) fn maximum(self, other: Self) -> Self {
        if self.range[0] > other.range[1] {
            return self;
        }
        if other.range[0] > self.range[1] {
            return other;
        }
        let zero = |known: &Self| known.value() == Some(0.0);
        let ramp = (zero(&self) && other.smoothness == Smoothness::Cinf)
            || (zero(&other) && self.smoothness == Smoothness::Cinf);
        let range = [self.range[0].max(other.range[0]), self.range[1].max(other.range[1])];
        Self { ramp, ..Self::new(range, Smoothness::C0) }
    }

    pub(super) fn minimum(self, other: Self) -> Self {
        self.negated().maximum(other.negated()).negated()
    }

    pub(super) fn absolute(self) -> Self {
        let [low, high] = self.range;
        if low >= 0.0 {
            self
        } else if high <= 0.0 {
            self.negated()
        } else {
            let ramp = self.smoothness == Smoothness::Cinf;
            Self { ramp, ..Self::new([0.0, high.max(-low)], Smoothness::C0) }
        }
    }

    pub(super) fn applied(self, function: Function) -> Self {
        if let Some(x) = self.value() {
            return Self::constant(function.derivatives(x)[0]);
        }
        let ([low, high], [from, to]) = (self.range, function.domain());
        if low > from && high < to || [from, to] == EVERYTHING {
            Self::new(function.range(self.range), self.smoothness)
        } else {
            Self::new(EVERYTHING, Smoothness::C0)
        }
    }
}

/// Continuous derivatives of x^p at x = 0, cut off or not.
fn of_power(p: f64) -> Smoothness {
    match p {
        p if p > 2.0 => Smoothness::C2,
        p if p > 1.0 => Smoothness::C1,
        _ => Smoothness::C0,
    }
}

fn multiplied(a: &Polynomial2, b: &Polynomial2) -> Option<Polynomial2> {
    (a.degree() + b.degree() <= HIGHEST_DEGREE).then(|| a.multiply(b))
}

fn products(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    // A bound of zero times an infinite one is zero: the values themselves are finite.
    let times = |x: f64, y: f64| if x == 0.0 || y == 0.0 { 0.0 } else { x * y };
    let all = [times(a[0], b[0]), times(a[0], b[1]), times(a[1], b[0]), times(a[1], b[1])];
    [all.iter().copied().fold(f64::INFINITY, f64::min), all.iter().copied().fold(f64::NEG_INFINITY, f64::max)]
}
