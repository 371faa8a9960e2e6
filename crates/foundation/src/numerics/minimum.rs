//! The least value of a function of one variable: parabolas through the last places, golden sections where they lead nowhere.

/// (3 - sqrt 5) / 2: the smaller part of a golden section.
const GOLDEN: f64 = 0.381_966_011_250_105;
/// Evaluations at most; golden sections alone would narrow any interval to a 1e-20th of it.
const MOST: usize = 100;

/// Argument and value of the minimum of a unimodal function on an interval, ends included; the argument to within twice the
/// tolerance. Values that are not finite count as +infinity.
pub fn least_value([from, to]: [f64; 2], tolerance: f64, mut f: impl FnMut(f64) -> f64) -> (f64, f64) {
    let mut value = |x: f64| {
        let y = f(x);
        if y.is_finite() { y } else { f64::INFINITY }
    };
    let (mut low, mut high) = (from, to);
    let mut x = low + GOLDEN * (high - low);
    let mut fx = value(x);
    // The second and third best places, and the last two steps.
    let (mut w, mut fw, mut v, mut fv) = (x, fx, x, fx);
    let (mut step, mut before) = (0.0_f64, 0.0_f64);
    for _ in 0..MOST {
        let middle = 0.5 * (low + high);
        if (x - middle).abs() <= 2.0 * tolerance - 0.5 * (high - low) {
            break;
        }
        let (r, q) = ((x - w) * (fx - fv), (x - v) * (fx - fw));
        let vertex = ((x - w) * r - (x - v) * q) / (2.0 * (q - r));
        let inside = x + vertex > low && x + vertex < high && vertex.abs() < 0.5 * before.abs();
        if before.abs() > tolerance && inside {
            (before, step) = (step, vertex);
            if x + step - low < 2.0 * tolerance || high - (x + step) < 2.0 * tolerance {
                step = tolerance.copysign(middle - x);
            }
        } else {
            before = if x < middle { high - x } else { low - x };
            step = GOLDEN * before;
        }
        let u = x + if step.abs() >= tolerance { step } else { tolerance.copysign(step) };
        let fu = value(u);
        if fu <= fx {
            if u < x {
                high = x
            } else {
                low = x
            }
            (v, fv, w, fw, x, fx) = (w, fw, x, fx, u, fu);
        } else {
            if u < x {
                low = u
            } else {
                high = u
            }
            if fu <= fw || w == x {
                (v, fv, w, fw) = (w, fw, u, fu);
            } else if fu <= fv || v == x || v == w {
                (v, fv) = (u, fu);
            }
        }
    }
    for end in [from, to] {
        if (x - end).abs() <= 4.0 * tolerance {
            let at_end = value(end);
            if at_end < fx {
                (x, fx) = (end, at_end);
            }
        }
    }
    (x, fx)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_the_least_value() {
        let mut calls = 0;
        let (x, y) = least_value([-1.0, 3.0], 1e-6, |x| {
            calls += 1;
            (x - 0.7).powi(2) * (1.0 + 0.1 * x) + 2.0
        });
        assert!((x - 0.7).abs() < 4e-6 && (y - 2.0).abs() < 1e-10, "{x} {y}");
        assert!(calls < 15, "{calls} evaluations");
        // An end, a corner, and a function that is not there over most of the interval.
        assert_eq!(least_value([0.0, 1.0], 1e-6, |x| x), (0.0, 0.0));
        assert_eq!(least_value([0.0, 1.0], 1e-6, |x| -x), (1.0, -1.0));
        assert!((least_value([0.0, 1.0], 1e-6, |x| (x - 0.3).abs()).0 - 0.3).abs() < 4e-6);
        let holed = |x: f64| if (0.1..0.55).contains(&x) { (x - 0.2).powi(2) } else { f64::INFINITY };
        assert!((least_value([0.0, 1.0], 1e-6, holed).0 - 0.2).abs() < 4e-6);
        assert_eq!(least_value([0.0, 1.0], 1e-6, |_| f64::NAN).1, f64::INFINITY);
    }
}
