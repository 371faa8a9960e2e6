//! Minimum of a smooth function of two variables from exact gradients, and of its restriction to a line. Knows no bodies.

use nalgebra::{Matrix2, Vector2};

/// Value and gradient at a point, in the units of the caller.
pub(super) trait Slope: Copy {
    /// Value.
    fn value(&self) -> f64;
    /// Derivatives by both variables.
    fn gradient(&self) -> Vector2<f64>;
}

/// A minimum.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bottom<S> {
    /// Where.
    pub x: Vector2<f64>,
    /// What the function says there.
    pub sample: S,
    /// Matrix of second derivatives as learnt on the way.
    pub hessian: Matrix2<f64>,
    /// How much lower the quadratic model expects the minimum.
    pub residue: f64,
}

/// The quadratic model expects less than this below the point reached, mm: 1e-10 um.
const SETTLED: f64 = 1e-13;
/// Rises below this are rounding of the value, mm.
const NOISE: f64 = 1e-12;
/// Offset, in scan steps, at which gradients are compared for the first matrix of second derivatives.
const PROBE: f64 = 0.05;
/// Longest step, in scan steps: the start is a sample next to the minimum.
const LONGEST: f64 = 1.5;
/// BFGS settles in five to eight steps; more than forty mean a function without a smooth minimum.
const MOST_STEPS: usize = 40;

/// Quasi-Newton (BFGS) descent from `start` with exact gradients; `scale` is the size of a scan step in each variable.
/// `function` gets the point and the value found last; `None` means there is no value and shortens the step.
pub(super) fn descend<S: Slope>(
    start: Vector2<f64>,
    scale: Vector2<f64>,
    guess: f64,
    mut function: impl FnMut(Vector2<f64>, f64) -> Option<S>,
) -> Option<Bottom<S>> {
    // Everything below is in scan steps, which brings both second derivatives to one magnitude.
    let mut y = Vector2::zeros();
    let mut evaluate = |y: Vector2<f64>, guess: f64| function(start + y.component_mul(&scale), guess);
    let slope = |s: &S| s.gradient().component_mul(&scale);
    let mut sample = evaluate(y, guess)?;
    let mut gradient = slope(&sample);
    let mut hessian = Matrix2::zeros();
    for k in 0..2 {
        let mut probe = Vector2::zeros();
        probe[k] = PROBE;
        let moved = evaluate(probe, sample.value())?;
        hessian.set_column(k, &((slope(&moved) - gradient) / PROBE));
    }
    hessian = convex(&((hessian + hessian.transpose()) * 0.5));
    for _ in 0..MOST_STEPS {
        let full = hessian.try_inverse()? * gradient;
        let residue = 0.5 * gradient.dot(&full);
        if residue < SETTLED {
            let unscaled = |i: usize, j: usize| hessian[(i, j)] / (scale[i] * scale[j]);
            return Some(Bottom {
                x: start + y.component_mul(&scale),
                sample,
                hessian: Matrix2::new(unscaled(0, 0), unscaled(0, 1), unscaled(1, 0), unscaled(1, 1)),
                residue,
            });
        }
        let mut step = -full / f64::max(1.0, full.amax() / LONGEST);
        let mut next = None;
        for _ in 0..12 {
            next = evaluate(y + step, sample.value()).filter(|s| s.value() <= sample.value() + NOISE);
            if next.is_some() {
                break;
            }
            step *= 0.5;
        }
        let next = next?;
        let next_gradient = slope(&next);
        let change = next_gradient - gradient;
        let bent = change.dot(&step);
        // Without positive curvature along the step the update would lose convexity: the old matrix stays.
        if bent > 1e-12 * change.norm() * step.norm() {
            let pushed = hessian * step;
            hessian += change * change.transpose() / bent - pushed * pushed.transpose() / step.dot(&pushed);
        }
        y += step;
        sample = next;
        gradient = next_gradient;
    }
    None
}

/// Minimum along `x = origin + t direction` by the secant rule on the exact slope, from t = 0. `curvature` is the
/// expected second derivative along the direction.
pub(super) fn descend_along<S: Slope>(
    origin: Vector2<f64>,
    direction: Vector2<f64>,
    curvature: f64,
    guess: f64,
    mut function: impl FnMut(Vector2<f64>, f64) -> Option<S>,
) -> Option<(Vector2<f64>, S, f64)> {
    if curvature.is_nan() || curvature <= 0.0 {
        return None;
    }
    let mut t = 0.0;
    let mut sample = function(origin, guess)?;
    let mut slope = sample.gradient().dot(&direction);
    let mut bend = curvature;
    for _ in 0..MOST_STEPS {
        let residue = 0.5 * slope * slope / bend;
        if residue < SETTLED {
            return Some((origin + direction * t, sample, residue));
        }
        let step = -slope / bend;
        sample = function(origin + direction * (t + step), sample.value())?;
        let next = sample.gradient().dot(&direction);
        let learnt = (next - slope) / step;
        if learnt > 0.1 * curvature {
            bend = learnt;
        }
        t += step;
        slope = next;
    }
    None
}

/// The symmetric matrix with the magnitudes of its eigenvalues, kept away from zero.
fn convex(matrix: &Matrix2<f64>) -> Matrix2<f64> {
    let mut eigen = matrix.symmetric_eigen();
    let least = 1e-3 * eigen.eigenvalues.amax();
    eigen.eigenvalues.apply(|value| *value = value.abs().max(least));
    eigen.recompose()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Clone, Copy)]
    struct At(f64, Vector2<f64>);

    impl Slope for At {
        fn value(&self) -> f64 {
            self.0
        }
        fn gradient(&self) -> Vector2<f64> {
            self.1
        }
    }

    /// (a - 0.3)^2 + 2 (b + 0.2)^2 + (a - 0.3)(b + 0.2) + (a - 0.3)^4
    fn bowl(x: Vector2<f64>) -> At {
        let (a, b) = (x[0] - 0.3, x[1] + 0.2);
        let value = a * a + 2.0 * b * b + a * b + a.powi(4);
        At(value, Vector2::new(2.0 * a + b + 4.0 * a.powi(3), 4.0 * b + a))
    }

    #[test]
    fn descends_to_the_bottom() {
        let scale = Vector2::new(1.0, 2.0);
        let bottom = descend(Vector2::new(1.0, 0.7), scale, 0.0, |x, _| Some(bowl(x))).unwrap();
        assert!(bottom.sample.value() < 1e-12 && bottom.residue < SETTLED);
        assert!((bottom.x - Vector2::new(0.3, -0.2)).norm() < 1e-6);
    }

    #[test]
    fn descends_along_a_line() {
        let (x, sample, _) =
            descend_along(Vector2::new(0.5, 0.0), Vector2::new(1.0, 0.0), 2.0, 0.0, |x, _| Some(bowl(x)))
                .unwrap();
        assert!(sample.gradient()[0].abs() < 1e-5 && x[1] == 0.0);
    }

    #[test]
    fn a_slope_has_no_bottom() {
        let plane = |x: Vector2<f64>, _| Some(At(x[0], Vector2::new(1.0, 0.0)));
        assert!(descend(Vector2::zeros(), Vector2::new(1.0, 1.0), 0.0, plane).is_none());
        assert!(descend_along(Vector2::zeros(), Vector2::x(), 1.0, 0.0, plane).is_none());
    }
}
