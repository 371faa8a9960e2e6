//! The functions that a formula may call, with two derivatives, and where they are smooth.

use std::f64::consts::FRAC_PI_2;

/// A function of one argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Function {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Exp,
    Ln,
    Log10,
    Sqrt,
}

impl Function {
    pub(super) const ALL: [(&'static str, Function); 13] = [
        ("sin", Function::Sin),
        ("cos", Function::Cos),
        ("tan", Function::Tan),
        ("asin", Function::Asin),
        ("acos", Function::Acos),
        ("atan", Function::Atan),
        ("sinh", Function::Sinh),
        ("cosh", Function::Cosh),
        ("tanh", Function::Tanh),
        ("exp", Function::Exp),
        ("ln", Function::Ln),
        ("log10", Function::Log10),
        ("sqrt", Function::Sqrt),
    ];

    /// [h, h', h''] at x; not finite where the function or a derivative does not exist.
    pub(super) fn derivatives(self, x: f64) -> [f64; 3] {
        match self {
            Function::Sin => {
                let (sin, cos) = x.sin_cos();
                [sin, cos, -sin]
            }
            Function::Cos => {
                let (sin, cos) = x.sin_cos();
                [cos, -sin, -cos]
            }
            Function::Tan => {
                let t = x.tan();
                let slope = 1.0 + t * t;
                [t, slope, 2.0 * t * slope]
            }
            Function::Asin => {
                let slope = 1.0 / ((1.0 - x) * (1.0 + x)).sqrt();
                [x.asin(), slope, x * slope.powi(3)]
            }
            Function::Acos => {
                let slope = 1.0 / ((1.0 - x) * (1.0 + x)).sqrt();
                [x.acos(), -slope, -x * slope.powi(3)]
            }
            Function::Atan => {
                let slope = 1.0 / (1.0 + x * x);
                [x.atan(), slope, -2.0 * x * slope * slope]
            }
            Function::Sinh => [x.sinh(), x.cosh(), x.sinh()],
            Function::Cosh => [x.cosh(), x.sinh(), x.cosh()],
            Function::Tanh => {
                let t = x.tanh();
                let slope = (1.0 - t) * (1.0 + t);
                [t, slope, -2.0 * t * slope]
            }
            Function::Exp => [x.exp(); 3],
            Function::Ln => [x.ln(), 1.0 / x, -1.0 / (x * x)],
            Function::Log10 => {
                let c = std::f64::consts::LOG10_E;
                [x.log10(), c / x, -c / (x * x)]
            }
            Function::Sqrt => {
                let root = x.sqrt();
                [root, 0.5 / root, -0.25 / (x * root)]
            }
        }
    }

    /// The open interval on which it has any number of derivatives.
    pub(super) fn domain(self) -> [f64; 2] {
        match self {
            Function::Tan => [-FRAC_PI_2, FRAC_PI_2],
            Function::Asin | Function::Acos => [-1.0, 1.0],
            Function::Ln | Function::Log10 | Function::Sqrt => [0.0, f64::INFINITY],
            _ => [f64::NEG_INFINITY, f64::INFINITY],
        }
    }

    /// An interval that holds all values over an interval inside the domain.
    pub(super) fn range(self, [low, high]: [f64; 2]) -> [f64; 2] {
        let at = |x: f64| self.derivatives(x)[0];
        match self {
            Function::Sin | Function::Cos => [-1.0, 1.0],
            Function::Acos => [at(high), at(low)],
            Function::Cosh => {
                let least = if low <= 0.0 && high >= 0.0 { 1.0 } else { at(low).min(at(high)) };
                [least, at(low).max(at(high))]
            }
            _ => [at(low), at(high)],
        }
    }
}
