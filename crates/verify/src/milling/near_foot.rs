//! The foot of a point near a surface.

use super::super::given::Checked;
use foundation::geometry::{Surface, SurfaceJet};
use nalgebra::{Matrix2, Vector2, Vector3};

/// Newton's steps; a point some micrometres off a flank takes five.
const STEPS: usize = 60;
/// Step along the surface that ends them, mm.
const SMALLEST_STEP: f64 = 1e-12;

/// The place of the surface on whose normal a point stands, and the distance along that normal, mm.
pub(super) fn foot(
    surface: &dyn Surface,
    point: &Vector3<f64>,
    [mut a, mut b]: [f64; 2],
) -> Checked<(SurfaceJet, f64)> {
    for _ in 0..STEPS {
        let jet = surface.jet(a, b);
        let off = point - jet.point;
        let (s_a, s_b) = (jet.by_height, jet.by_length);
        let metric = Matrix2::new(s_a.dot(&s_a), s_a.dot(&s_b), s_a.dot(&s_b), s_b.dot(&s_b));
        let step = metric.lu().solve(&Vector2::new(off.dot(&s_a), off.dot(&s_b)));
        let step = step.ok_or("the surface has no tangent plane")?;
        (a, b) = (a + step.x, b + step.y);
        if (s_a * step.x + s_b * step.y).norm() < SMALLEST_STEP {
            let jet = surface.jet(a, b);
            let distance = (point - jet.point).dot(&jet.normal);
            return Ok((jet, distance));
        }
    }
    Err("the foot on the flank is not found".into())
}
