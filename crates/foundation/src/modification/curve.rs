//! The curves of one variable that profile, helix and directed modifications are made of.

use super::smoothness::Smoothness;

/// f(x) in mm, already with its sign (negative = removed). `x` is a distance in mm, or dimensionless for the
/// triangular relief.
#[derive(Clone, Copy, Debug)]
pub(super) enum Curve {
    /// c x.
    Line { c: f64 },
    /// c x^2.
    Parabola { c: f64 },
    /// c_1 x^2 for x < 0, c_2 x^2 for x >= 0.
    TwoParabolas { c_1: f64, c_2: f64 },
    /// Circle of curvature kappa (signed, 1/mm) with its apex at x = 0.
    Arc { kappa: f64 },
    /// c xi^power, xi = (sqrt(x^2+r_b^2) - middle) inverse_half, power 1 or 2: a law over the radius.
    Radius { c: f64, squared: bool, base_radius: f64, middle: f64, inverse_half: f64 },
    /// c ramp_h(x): straight, with a rounding of half length h around its start.
    Ramp { c: f64, h: f64 },
    /// c (max(x, 0)/length)^p, p > 1.
    Power { c: f64, length: f64, p: f64 },
}

impl Curve {
    /// f, f' and f'' at x; mean of both sides at a jump. `Err` holds the radius of an arc that ends before x.
    #[inline]
    pub(super) fn jet(&self, x: f64) -> Result<[f64; 3], f64> {
        Ok(match *self {
            Curve::Line { c } => [c * x, c, 0.0],
            Curve::Parabola { c } => [c * x * x, 2.0 * c * x, 2.0 * c],
            Curve::TwoParabolas { c_1, c_2 } => {
                let c = one_of_three(x, c_1, c_2);
                [c * x * x, 2.0 * c * x, 2.0 * c]
            }
            Curve::Arc { kappa } => {
                let sin = kappa * x;
                // A half circle ends at the border of the field: rounding must not push the border outside.
                if sin.abs() > 1.0 + 1e-12 {
                    return Err(1.0 / kappa.abs());
                }
                // (1-s)(1+s) keeps its digits where the arc steepens; x^2 kappa/(1+cos) where it is flat.
                let cos = ((1.0 - sin) * (1.0 + sin)).max(0.0).sqrt();
                [-kappa * x * x / (1.0 + cos), -sin / cos, -kappa / (cos * cos * cos)]
            }
            Curve::Radius { c, squared, base_radius, middle, inverse_half } => {
                let radius = x.hypot(base_radius);
                let xi = (radius - middle) * inverse_half;
                let xi_1 = x / radius * inverse_half;
                let xi_2 = (base_radius / radius).powi(2) / radius * inverse_half;
                if squared {
                    [c * xi * xi, 2.0 * c * xi * xi_1, 2.0 * c * (xi_1 * xi_1 + xi * xi_2)]
                } else {
                    [c * xi, c * xi_1, c * xi_2]
                }
            }
            Curve::Ramp { c, h } => {
                if x.abs() < h {
                    [c * (x + h) * (x + h) / (4.0 * h), c * (x + h) / (2.0 * h), c / (2.0 * h)]
                } else {
                    let bend = if h > 0.0 && x.abs() == h { c / (4.0 * h) } else { 0.0 };
                    let slope = if h > 0.0 && x == -h { 0.0 } else { one_of_three(x, 0.0, c) };
                    [c * x.max(0.0), slope, bend]
                }
            }
            Curve::Power { c, length, p } => {
                if x > 0.0 {
                    let t = x / length;
                    let bend = c * p * (p - 1.0) / (length * length);
                    [c * t.powf(p), c * p / length * t.powf(p - 1.0), bend * t.powf(p - 2.0)]
                } else if x == 0.0 && p == 2.0 {
                    [0.0, 0.0, c / (length * length)]
                } else {
                    [0.0; 3]
                }
            }
        })
    }

    pub(super) fn smoothness(&self) -> Smoothness {
        match *self {
            Curve::Line { .. } | Curve::Parabola { .. } | Curve::Arc { .. } | Curve::Radius { .. } => {
                Smoothness::Cinf
            }
            Curve::TwoParabolas { .. } => Smoothness::C1,
            Curve::Ramp { h, .. } => {
                if h > 0.0 {
                    Smoothness::C1
                } else {
                    Smoothness::C0
                }
            }
            Curve::Power { p, .. } => {
                if p > 2.0 {
                    Smoothness::C2
                } else {
                    Smoothness::C1
                }
            }
        }
    }

    /// Coefficients of 1, x, x^2 if the curve is such a polynomial.
    pub(super) fn polynomial(&self) -> Option<[f64; 3]> {
        match *self {
            Curve::Line { c } => Some([0.0, c, 0.0]),
            Curve::Parabola { c } => Some([0.0, 0.0, c]),
            _ => None,
        }
    }
}

/// `below` for x < 0, `above` for x > 0, their mean at zero.
#[inline]
fn one_of_three(x: f64, below: f64, above: f64) -> f64 {
    if x < 0.0 {
        below
    } else if x > 0.0 {
        above
    } else {
        0.5 * (below + above)
    }
}
