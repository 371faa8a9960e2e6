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

/// Root of `f` in `[a, b]` with the known values `f(a)` and `f(b)` of different signs, by Brent's method (Brent 1973,
/// chapter 4) to an interval of 4 spacings of `f64` plus `tolerance`. `None` without a sign change or when `f` yields
/// `None` or a non-finite value on the way. A pole with a sign change is found like a root: the caller looks at f there.
pub fn brent(
    [mut a, mut b]: [f64; 2],
    [mut fa, mut fb]: [f64; 2],
    tolerance: f64,
    mut f: impl FnMut(f64) -> Option<f64>,
) -> Option<f64> {
    if fa == 0.0 {
        return Some(a);
    }
    if fb == 0.0 {
        return Some(b);
    }
    if !fa.is_finite() || !fb.is_finite() || (fa > 0.0) == (fb > 0.0) {
        return None;
    }
    // b is the best point so far, c the other end of the bracket, a the point before b.
    let (mut c, mut fc) = (a, fa);
    let mut step = b - a;
    let mut before = step;
    // Bisection alone needs 1100 halvings from the widest to the narrowest interval of f64; Brent some 10.
    for _ in 0..200 {
        if (fb > 0.0) == (fc > 0.0) {
            (c, fc) = (a, fa);
            step = b - a;
            before = step;
        }
        if fc.abs() < fb.abs() {
            (a, b, c) = (b, c, b);
            (fa, fb, fc) = (fb, fc, fb);
        }
        let enough = 2.0 * f64::EPSILON * b.abs() + 0.5 * tolerance;
        let half = 0.5 * (c - b);
        if half.abs() <= enough || fb == 0.0 {
            return Some(b);
        }
        if before.abs() >= enough && fa.abs() > fb.abs() {
            // Secant through two points, inverse parabola through three.
            let s = fb / fa;
            let (mut p, mut q) = if a == c {
                (2.0 * half * s, 1.0 - s)
            } else {
                let (r, t) = (fb / fc, fa / fc);
                (s * (2.0 * half * t * (t - r) - (b - a) * (r - 1.0)), (t - 1.0) * (r - 1.0) * (s - 1.0))
            };
            if p > 0.0 {
                q = -q;
            }
            p = p.abs();
            if 2.0 * p < (3.0 * half * q - (enough * q).abs()).min((before * q).abs()) {
                before = step;
                step = p / q;
            } else {
                step = half;
                before = half;
            }
        } else {
            step = half;
            before = half;
        }
        (a, fa) = (b, fb);
        b += if step.abs() > enough { step } else { enough.copysign(half) };
        fb = f(b).filter(|value| value.is_finite())?;
    }
    Some(b)
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
    fn brent_finds_roots_in_few_steps() {
        let mut count = 0;
        let mut f = |x: f64| {
            count += 1;
            Some(x.cos() - x)
        };
        let x = brent([0.0, 1.0], [1.0, 1f64.cos() - 1.0], 1e-15, &mut f).unwrap();
        assert!((x - 0.739_085_133_215_160_6).abs() < 1e-15 && count < 12, "{x} {count}");
        // Flat at the root: never worse than bisection by more than a factor.
        let flat = brent([-1.0, 2.0], [-1.0, 512.0], 1e-12, |x| Some(x.powi(9))).unwrap();
        assert!(flat.abs() < 1e-1_f64.powi(3), "{flat}");
        assert!(brent([0.0, 1.0], [1.0, 2.0], 0.0, |x| Some(x + 1.0)).is_none());
        assert!(brent([0.0, 1.0], [-1.0, 1.0], 0.0, |_| None).is_none());
        assert_eq!(brent([0.0, 1.0], [0.0, 1.0], 0.0, Some), Some(0.0));
        // A pole between the ends: the place of the sign change, where f is huge.
        let pole = brent([-1.0, 2.0], [-1.0, 0.5], 1e-15, |x| Some(1.0 / (x + 1e-9))).unwrap();
        assert!((pole + 1e-9).abs() < 1e-12, "{pole}");
    }

    #[test]
    fn golden_section_narrows_to_the_minimum() {
        let x = golden_section(-1.0, 3.0, 30, |x| (x - 0.7).powi(2));
        assert!((x - 0.7).abs() < 1e-5);
    }
}
