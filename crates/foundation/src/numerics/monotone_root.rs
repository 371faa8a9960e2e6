//! The root of a monotone function of one variable that is given with its slope.

/// Farthest doubling of the first step in search of a bracket.
const DOUBLINGS: usize = 60;
/// Steps inside the bracket at most; Newton needs a few, stretches without slope are halved.
const STEPS: usize = 120;

/// Root of a monotone `f`, which yields value and slope, by Newton's method kept inside a bracket; it may stand still or have
/// kinks on the way. NaN when the function has no root or yields NaN.
pub fn monotone_root(f: impl Fn(f64) -> (f64, f64)) -> f64 {
    let (start, slope) = f(0.0);
    if start == 0.0 {
        return 0.0;
    }
    let rises = if slope == 0.0 { f(1.0).0 > f(-1.0).0 } else { slope > 0.0 };
    let direction = if rises == (start < 0.0) { 1.0 } else { -1.0 };
    let first = (start / slope).abs();
    let mut step = if first.is_finite() && first > 0.0 { first } else { 1.0 };
    // Half a step beyond Newton's, so that a linear function is bracketed at once.
    let mut far = 1.5 * direction * step;
    let mut near = 0.0;
    let mut found = false;
    for _ in 0..DOUBLINGS {
        let value = f(far).0;
        if value.is_nan() {
            return f64::NAN;
        }
        if (value > 0.0) != (start > 0.0) {
            found = true;
            break;
        }
        near = far;
        step *= 2.0;
        far += direction * step;
    }
    if !found {
        return f64::NAN;
    }
    let (mut low, mut high) = if near < far { (near, far) } else { (far, near) };
    let mut x = near + direction * step / if near == 0.0 { 1.0 } else { 2.0 };
    let mut last = f64::INFINITY;
    for _ in 0..STEPS {
        let (value, slope) = f(x);
        if value.is_nan() {
            return f64::NAN;
        }
        if value == 0.0 {
            return x;
        }
        if (value > 0.0) == rises {
            high = x
        } else {
            low = x
        }
        let newton = x - value / slope;
        let size = (newton - x).abs();
        let next =
            if newton > low && newton < high && size <= 0.5 * last { newton } else { 0.5 * (low + high) };
        let moved = (next - x).abs();
        last = moved;
        x = next;
        if moved <= 1e-15 * (1.0 + x.abs()) || high - low <= 1e-15 * (1.0 + x.abs()) {
            break;
        }
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_of_monotone_functions_are_found_from_afar() {
        let line = monotone_root(|x| (3.0 - 0.5 * x, -0.5));
        assert!((line - 6.0).abs() < 1e-14);
        let bent = monotone_root(|x: f64| (x.powi(3) + x - 1000.0, 3.0 * x * x + 1.0));
        assert!((bent.powi(3) + bent - 1000.0).abs() < 1e-10);
        let steep = monotone_root(|x: f64| (x.atan() + 1.2, 1.0 / (1.0 + x * x)));
        assert!((steep + 1.2f64.tan()).abs() < 1e-12);
    }

    #[test]
    fn a_stretch_without_slope_is_crossed() {
        let law = |x: f64| {
            if x < 2.0 {
                (x - 2.0 - 1.0, 1.0)
            } else if x < 5.0 {
                (-1.0, 0.0)
            } else {
                (x - 5.0 - 1.0, 1.0)
            }
        };
        assert!((monotone_root(law) - 6.0).abs() < 1e-12);
    }

    #[test]
    fn without_a_root_the_answer_is_not_a_number() {
        assert!(monotone_root(|x: f64| (x.atan() + 2.0, 1.0 / (1.0 + x * x))).is_nan());
        assert!(monotone_root(|_| (f64::NAN, 1.0)).is_nan());
    }
}
