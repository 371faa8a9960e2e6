//! How each axis of the dressing machine moves the dresser against the worm (`docs/mathematics/programs.md#from-bodies-to-axes`).

use super::{DressingAxes, Pose, Worm};
use nalgebra::Vector3;

/// Velocity of a body per unit of an axis (rad or mm), in worm coordinates: v(X) = turning x X + sliding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisTwist {
    /// Angular velocity, rad per unit.
    pub turning: Vector3<f64>,
    /// Velocity of the point of the body that is at the origin, mm per unit.
    pub sliding: Vector3<f64>,
}

impl AxisTwist {
    /// Velocity of the body point at X (worm coordinates, mm).
    pub fn velocity(&self, point: &Vector3<f64>) -> Vector3<f64> {
        self.turning.cross(point) + self.sliding
    }

    fn rotary(direction: Vector3<f64>, through: Vector3<f64>) -> Self {
        Self { turning: direction, sliding: -direction.cross(&through) }
    }

    fn linear(direction: Vector3<f64>) -> Self {
        Self { turning: Vector3::zeros(), sliding: direction }
    }
}

impl DressingAxes {
    /// The motion of the dresser against the worm by each axis, in the order of [`super::DressingAxis::ALL`].
    pub fn twists(&self) -> [AxisTwist; 7] {
        type Frame = Pose<Worm, Worm>;
        let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
        let spindle = Frame::rz(-self.worm).then(&Frame::tz(-self.shift));
        let head = spindle.then(&Frame::rx(-self.tilt));
        let slide = head.then(&Frame::tx(-self.radial)).then(&Frame::ty(self.axial));
        let swivel = slide.then(&Frame::ry(self.swivel));
        [
            AxisTwist::rotary(-z, Vector3::zeros()),
            AxisTwist::linear(-z),
            AxisTwist::rotary(-(spindle.rotation() * x), *spindle.translation()),
            AxisTwist::linear(-(head.rotation() * x)),
            AxisTwist::linear(head.rotation() * y),
            AxisTwist::rotary(slide.rotation() * y, *slide.translation()),
            AxisTwist::rotary(swivel.rotation() * z, *swivel.translation()),
        ]
    }
}
