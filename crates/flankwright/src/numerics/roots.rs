//! Bracketed roots and minima of a function of one variable.

/// Root of `f` in `[a, b]`, where `f(a)` and `f(b)` differ in sign, by bisection down to the spacing of `f64`
/// (at most 200 halvings). Returns `None` without a sign change or when `f` yields a non-finite value.
pub fn bisect(mut a: f64, mut b: f64, mut f: impl FnMut(f64) -> f64) -> Option<f64> {
    let fa = f(a);
    let fb = f(b);
    if fa == 0.0 {
        return Some(a);
    }
    if fb == 0.0 {
        return Some(b);
    }
    if !fa.is_finite() || !fb.is_finite() || (fa > 0.0) == (fb > 0.0) {
        return None;
    }
    let rising = fb > 0.0;
    for _ in 0..200 {
        let m = 0.5 * (a + b);
        if m == a || m == b {
            break;
        }
        let fm = f(m);
        if !fm.is_finite() {
            return None;
        }
        if fm == 0.0 {
            return Some(m);
        }
        if (fm > 0.0) == rising { b = m } else { a = m }
    }
    Some(0.5 * (a + b))
}

/// Minimum of a unimodal function on `[a, b]` by golden section with the given number of evaluations (>= 2);
/// the argument of the least value seen. Non-finite values count as +infinity.
pub fn golden_section(a: f64, b: f64, evaluations: usize, mut f: impl FnMut(f64) -> f64) -> f64 {
    let mut value = |x: f64| {
        let y = f(x);
        if y.is_finite() { y } else { f64::INFINITY }
    };
    let ratio = (5f64.sqrt() - 1.0) / 2.0;
    let (mut lo, mut hi) = (a, b);
    let mut x1 = hi - ratio * (hi - lo);
    let mut x2 = lo + ratio * (hi - lo);
    let (mut f1, mut f2) = (value(x1), value(x2));
    for _ in 2..evaluations.max(2) {
        if f1 <= f2 {
            hi = x2;
            (x2, f2) = (x1, f1);
            x1 = hi - ratio * (hi - lo);
            f1 = value(x1);
        } else {
            lo = x1;
            (x1, f1) = (x2, f2);
            x2 = lo + ratio * (hi - lo);
            f2 = value(x2);
        }
    }
    if f1 <= f2 { x1 } else { x2 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bisection_finds_the_root_to_rounding() {
        let x = bisect(0.0, 2.0, |x| x * x - 2.0).unwrap();
        assert!((x - 2f64.sqrt()).abs() < 4e-16);
        assert!(bisect(0.0, 1.0, |x| x + 1.0).is_none());
        assert!(bisect(-1.0, 1.0, |x| 1.0 / x).is_none_or(|r| r.abs() < 1e-300));
    }

    #[test]
    fn golden_section_narrows_to_the_minimum() {
        let x = golden_section(-1.0, 3.0, 30, |x| (x - 0.7).powi(2));
        assert!((x - 0.7).abs() < 1e-5);
    }
}
