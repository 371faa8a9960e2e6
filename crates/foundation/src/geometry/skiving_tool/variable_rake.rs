//! A rake face whose angle changes over the tooth: a plane on which slopes grow with the height of the tooth and across it
//! (`docs/mathematics/skiving.md#the-virtual-edge`).

use super::RakeFace;
use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};

/// How the slope of a rake face against its plane at the pitch point changes. u goes up the tooth, v across it, from the pitch point; mm,
/// rad.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RakeChange {
    /// Slope along the height, per mm of height and per square millimetre.
    pub by_height: [f64; 2],
    /// Slope across the tooth, per mm from its middle: > 0 is hollow.
    pub hollow: f64,
    /// Slope across the tooth, per mm of height: one edge gains rake where the other loses it.
    pub twist: f64,
}

/// The face h(u, v) = b_1 u^2/2 + b_2 u^3/3 + c v^2/2 + t u v above a plane with rake angle and step angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VariableRake {
    /// Columns: across the tooth, up the tooth, out of the plane.
    frame: Matrix3<f64>,
    origin: Vector3<f64>,
    change: RakeChange,
}

/// Newton's steps for the foot of a perpendicular, and the last of them, mm.
const STEPS: usize = 40;
const LAST: f64 = 1e-14;

/// The face at a place: height, its slopes [by v, by u] and bends.
struct Jet {
    height: f64,
    slope: Vector2<f64>,
    bend: Matrix2<f64>,
}

impl VariableRake {
    /// A face with rake angle and step angle (rad) at the pitch point.
    pub fn new(rake_angle: f64, step_angle: f64, change: RakeChange, pitch_radius: f64) -> Self {
        let (sin, cos) = rake_angle.sin_cos();
        let (sin_step, cos_step) = step_angle.sin_cos();
        // Ry(-sigma) Rx(gamma_r).
        let across = Vector3::new(cos_step, 0.0, sin_step);
        let up = Vector3::new(-sin_step * sin, cos, cos_step * sin);
        let out = Vector3::new(-cos * sin_step, -sin, cos * cos_step);
        Self {
            frame: Matrix3::from_columns(&[across, up, out]),
            origin: Vector3::new(0.0, pitch_radius, 0.0),
            change,
        }
    }

    fn jet(&self, at: &Vector2<f64>) -> Jet {
        let RakeChange { by_height: [b, c], hollow, twist } = self.change;
        let (v, u) = (at.x, at.y);
        Jet {
            height: u * u * (b / 2.0 + c * u / 3.0) + hollow * v * v / 2.0 + twist * u * v,
            slope: Vector2::new(hollow * v + twist * u, u * (b + c * u) + twist * v),
            bend: Matrix2::new(hollow, twist, twist, b + 2.0 * c * u),
        }
    }

    /// The foot of the perpendicular from a point of the plane's coordinates; NaN where there is none nearby.
    fn foot(&self, at: &Vector3<f64>) -> Vector2<f64> {
        let mut foot = at.xy();
        for _ in 0..STEPS {
            let jet = self.jet(&foot);
            let off = jet.height - at.z;
            let gradient = foot - at.xy() + jet.slope * off;
            let matrix = Matrix2::identity() + jet.slope * jet.slope.transpose() + jet.bend * off;
            let Some(inverse) = matrix.try_inverse() else { break };
            let step = inverse * gradient;
            foot -= step;
            if step.amax() < LAST * (1.0 + foot.amax()) {
                return foot;
            }
        }
        Vector2::repeat(f64::NAN)
    }
}

impl RakeFace for VariableRake {
    fn distance(&self, p: &Vector3<f64>) -> f64 {
        let at = self.frame.tr_mul(&(p - self.origin));
        let jet = self.jet(&self.foot(&at));
        (at.z - jet.height) * jet.slope.norm().hypot(1.0)
    }

    fn normal(&self, p: &Vector3<f64>) -> Vector3<f64> {
        let at = self.frame.tr_mul(&(p - self.origin));
        let slope = self.jet(&self.foot(&at)).slope;
        self.frame * Vector3::new(-slope.x, -slope.y, 1.0).normalize()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::PlaneRake;

    const CHANGE: RakeChange = RakeChange { by_height: [0.02, -0.004], hollow: 0.03, twist: -0.015 };

    /// Without any change it is the plane, bit for bit of no interest, but to rounding.
    #[test]
    fn without_change_it_is_the_plane() {
        let (plane, face) =
            (PlaneRake::new(0.1, 0.2, 60.0), VariableRake::new(0.1, 0.2, RakeChange::default(), 60.0));
        for k in 0..50 {
            let k = f64::from(k);
            let p = Vector3::new((1.3 * k).sin(), 60.0 + 2.0 * (0.7 * k).cos(), (2.1 * k).sin());
            assert!((plane.distance(&p) - face.distance(&p)).abs() < 1e-13);
            assert!((plane.normal(&p) - face.normal(&p)).amax() < 1e-15);
        }
    }

    /// The distance is that of the nearest of many places of the face, and the normal its gradient.
    #[test]
    fn distances_are_those_of_the_nearest_place() {
        let face = VariableRake::new(0.08, 0.17, CHANGE, 60.0);
        for k in 0..12 {
            let k = f64::from(k);
            let p = Vector3::new(1.2 * (1.3 * k).sin(), 60.0 + 2.0 * (0.7 * k).cos(), 0.3 * (2.1 * k).sin());
            let at = face.frame.tr_mul(&(p - face.origin));
            let distance = |v: f64, u: f64| {
                let height = face.jet(&Vector2::new(v, u)).height;
                (Vector3::new(v, u, height) - at).norm()
            };
            let (mut best, mut reach) = (at.xy(), 0.5);
            for _ in 0..12 {
                let mut least = (f64::INFINITY, best);
                for i in -20..=20 {
                    for j in -20..=20 {
                        let place = best + Vector2::new(f64::from(i), f64::from(j)) * (reach / 20.0);
                        let found = distance(place.x, place.y);
                        if found < least.0 {
                            least = (found, place);
                        }
                    }
                }
                (best, reach) = (least.1, reach / 8.0);
            }
            assert!((distance(best.x, best.y) - face.distance(&p).abs()).abs() < 1e-10, "{p}");
            let step = 1e-5;
            let gradient = Vector3::from_fn(|i, _| {
                let mut off = Vector3::zeros();
                off[i] = step;
                (face.distance(&(p + off)) - face.distance(&(p - off))) / (2.0 * step)
            });
            assert!((gradient - face.normal(&p)).amax() < 1e-9, "{gradient}");
        }
    }
}
