//! Value, gradient and second derivatives of a function of two variables, and the rules of calculus on them.

use std::ops::{Add, AddAssign, Mul, Neg};

/// A function of (u, v) at one point up to second order. Units: those of `f`, divided by those of u and v.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Jet2 {
    /// Value.
    pub f: f64,
    /// df/du.
    pub fu: f64,
    /// df/dv.
    pub fv: f64,
    /// d2f/du2.
    pub fuu: f64,
    /// d2f/du dv.
    pub fuv: f64,
    /// d2f/dv2.
    pub fvv: f64,
}

impl Jet2 {
    /// A constant: all derivatives vanish.
    #[inline]
    pub fn constant(f: f64) -> Self {
        Self { f, ..Self::default() }
    }

    /// The function h(a u + b v + c) from h, h' and h'' at that argument.
    #[inline]
    pub fn ridge([h, h1, h2]: [f64; 3], a: f64, b: f64) -> Self {
        Self { f: h, fu: a * h1, fv: b * h1, fuu: a * a * h2, fuv: a * b * h2, fvv: b * b * h2 }
    }

    /// The function g(u, v) = f(u, -v), when `self` is f at (u, -v).
    #[inline]
    pub fn mirrored_v(self) -> Self {
        Self { fv: -self.fv, fuv: -self.fuv, ..self }
    }

    /// The function f(u(p, q), v(p, q)) of (p, q), when `self` is f at (u, v): the chain rule, up to second order.
    #[inline]
    pub fn of(self, u: Self, v: Self) -> Self {
        let second = |u_p: f64, v_p: f64, u_q: f64, v_q: f64| {
            self.fuu * u_p * u_q + self.fuv * (u_p * v_q + u_q * v_p) + self.fvv * v_p * v_q
        };
        Self {
            f: self.f,
            fu: self.fu * u.fu + self.fv * v.fu,
            fv: self.fu * u.fv + self.fv * v.fv,
            fuu: second(u.fu, v.fu, u.fu, v.fu) + self.fu * u.fuu + self.fv * v.fuu,
            fuv: second(u.fu, v.fu, u.fv, v.fv) + self.fu * u.fuv + self.fv * v.fuv,
            fvv: second(u.fv, v.fv, u.fv, v.fv) + self.fu * u.fvv + self.fv * v.fvv,
        }
    }

    /// Whether value and all derivatives are finite.
    #[inline]
    pub fn is_finite(&self) -> bool {
        [self.f, self.fu, self.fv, self.fuu, self.fuv, self.fvv].iter().all(|x| x.is_finite())
    }
}

impl Add for Jet2 {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self {
            f: self.f + other.f,
            fu: self.fu + other.fu,
            fv: self.fv + other.fv,
            fuu: self.fuu + other.fuu,
            fuv: self.fuv + other.fuv,
            fvv: self.fvv + other.fvv,
        }
    }
}

impl AddAssign for Jet2 {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Mul<f64> for Jet2 {
    type Output = Self;
    #[inline]
    fn mul(self, factor: f64) -> Self {
        Self {
            f: self.f * factor,
            fu: self.fu * factor,
            fv: self.fv * factor,
            fuu: self.fuu * factor,
            fuv: self.fuv * factor,
            fvv: self.fvv * factor,
        }
    }
}

impl Neg for Jet2 {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self * -1.0
    }
}

impl Mul for Jet2 {
    type Output = Self;
    /// The product rule, up to second order.
    #[inline]
    fn mul(self, g: Self) -> Self {
        let f = self;
        Self {
            f: f.f * g.f,
            fu: f.fu * g.f + f.f * g.fu,
            fv: f.fv * g.f + f.f * g.fv,
            fuu: f.fuu * g.f + 2.0 * f.fu * g.fu + f.f * g.fuu,
            fuv: f.fuv * g.f + f.fu * g.fv + f.fv * g.fu + f.f * g.fuv,
            fvv: f.fvv * g.f + 2.0 * f.fv * g.fv + f.f * g.fvv,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn composition_obeys_the_chain_rule() {
        // f = u^2 v with u = p q and v = p + q^2 is p^3 q^2 + p^2 q^4.
        let (p, q) = (1.3, -0.7);
        let u = Jet2 { f: p * q, fu: q, fv: p, fuv: 1.0, ..Jet2::default() };
        let v = Jet2 { f: p + q * q, fu: 1.0, fv: 2.0 * q, fvv: 2.0, ..Jet2::default() };
        let f = Jet2 {
            f: u.f * u.f * v.f,
            fu: 2.0 * u.f * v.f,
            fv: u.f * u.f,
            fuu: 2.0 * v.f,
            fuv: 2.0 * u.f,
            fvv: 0.0,
        };
        let got = f.of(u, v);
        let want = [
            (got.f, p.powi(3) * q.powi(2) + p * p * q.powi(4)),
            (got.fu, 3.0 * p * p * q * q + 2.0 * p * q.powi(4)),
            (got.fv, 2.0 * p.powi(3) * q + 4.0 * p * p * q.powi(3)),
            (got.fuu, 6.0 * p * q * q + 2.0 * q.powi(4)),
            (got.fuv, 6.0 * p * p * q + 8.0 * p * q.powi(3)),
            (got.fvv, 2.0 * p.powi(3) + 12.0 * p * p * q * q),
        ];
        for (got, want) in want {
            assert!((got - want).abs() < 1e-13, "{got} {want}");
        }
    }
}
