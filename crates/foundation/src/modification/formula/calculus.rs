//! Rules of calculus on jets that the formula needs beside sum and product: chains, powers, kinks.

use std::cmp::Ordering;

use crate::numerics::Jet2;

/// h(g) from h, h', h'' at g. A factor that is exactly zero wins over one without bound: where g stands still, h(g)
/// does too, e.g. max(u, 0)^1.5 for u < 0.
pub(super) fn chain(g: Jet2, [h, h1, h2]: [f64; 3]) -> Jet2 {
    let times = |a: f64, b: f64| if b == 0.0 { 0.0 } else { a * b };
    let second = |a: f64, b: f64, ab: f64| times(h2, a * b) + times(h1, ab);
    Jet2 {
        f: h,
        fu: times(h1, g.fu),
        fv: times(h1, g.fv),
        fuu: second(g.fu, g.fu, g.fuu),
        fuv: second(g.fu, g.fv, g.fuv),
        fvv: second(g.fv, g.fv, g.fvv),
    }
}

pub(super) fn quotient(a: Jet2, b: Jet2) -> Jet2 {
    let r = 1.0 / b.f;
    Jet2 { f: a.f / b.f, ..a * chain(b, [r, -r * r, 2.0 * r * r * r]) }
}

/// a^b; with a constant exponent also for a <= 0 where the power exists.
pub(super) fn power(a: Jet2, b: Jet2) -> Jet2 {
    if is_constant(&b) {
        let p = b.f;
        let term = |c: f64, e: f64| if c == 0.0 { 0.0 } else { c * raised(a.f, e) };
        chain(a, [raised(a.f, p), term(p, p - 1.0), term(p * (p - 1.0), p - 2.0)])
    } else {
        let x = a.f.ln();
        let exponent = b * chain(a, [x, 1.0 / a.f, -1.0 / (a.f * a.f)]);
        chain(exponent, [exponent.f.exp(); 3])
    }
}

/// Whole exponents by multiplication: exact for small numbers, and the same for bases of both signs.
fn raised(x: f64, p: f64) -> f64 {
    if p.fract() == 0.0 && p.abs() <= 64.0 { x.powi(p as i32) } else { x.powf(p) }
}

fn is_constant(b: &Jet2) -> bool {
    [b.fu, b.fv, b.fuu, b.fuv, b.fvv].iter().all(|x| *x == 0.0)
}

/// From which side a point of a kink is looked at.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    /// The direction in (w, z) in which the point is left; none as long as no kink was met.
    pub direction: Option<[f64; 2]>,
    /// Whether a kink was met.
    pub kink: bool,
}

impl View {
    /// a compared with b, on a kink a moment later along the direction.
    fn compare(&mut self, a: &Jet2, b: &Jet2) -> Option<Ordering> {
        let values = a.f.partial_cmp(&b.f)?;
        if values != Ordering::Equal || (a.fu, a.fv, a.fuu, a.fuv, a.fvv) == (b.fu, b.fv, b.fuu, b.fuv, b.fvv)
        {
            return Some(values);
        }
        self.kink = true;
        let [p, q] = self.direction?;
        let first = |j: &Jet2| j.fu * p + j.fv * q;
        let second = |j: &Jet2| j.fuu * p * p + 2.0 * j.fuv * p * q + j.fvv * q * q;
        let slopes = first(a).partial_cmp(&first(b))?;
        if slopes == Ordering::Equal { second(a).partial_cmp(&second(b)) } else { Some(slopes) }
    }

    pub(super) fn maximum(&mut self, a: Jet2, b: Jet2) -> Jet2 {
        if self.compare(&a, &b) == Some(Ordering::Less) || a.f.is_nan() {
            keep_nan(b, a)
        } else {
            keep_nan(a, b)
        }
    }

    pub(super) fn minimum(&mut self, a: Jet2, b: Jet2) -> Jet2 {
        -self.maximum(-a, -b)
    }

    pub(super) fn absolute(&mut self, a: Jet2) -> Jet2 {
        self.maximum(a, -a)
    }
}

/// `chosen`, unless the other has no value: what is undefined is reported, not passed over.
fn keep_nan(chosen: Jet2, other: Jet2) -> Jet2 {
    if other.f.is_nan() { other } else { chosen }
}

/// The mean over jets seen from several sides. A second derivative that grows without bound on one side is taken from
/// the others (as with relief exponents between 1 and 2); a slope without bound stays so.
pub(super) fn mean(views: [Jet2; 4]) -> Jet2 {
    let all = |part: fn(&Jet2) -> f64| views.iter().map(part).sum::<f64>() / 4.0;
    let finite = |part: fn(&Jet2) -> f64| {
        let found: Vec<f64> = views.iter().map(part).filter(|x| x.is_finite()).collect();
        if found.is_empty() { f64::NAN } else { found.iter().sum::<f64>() / found.len() as f64 }
    };
    Jet2 {
        f: all(|j| j.f),
        fu: all(|j| j.fu),
        fv: all(|j| j.fv),
        fuu: finite(|j| j.fuu),
        fuv: finite(|j| j.fuv),
        fvv: finite(|j| j.fvv),
    }
}
