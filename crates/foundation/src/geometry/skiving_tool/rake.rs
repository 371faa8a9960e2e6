//! Rake faces as signed distances from the material: a plane for every tooth, a cone for all of them, a hollow sphere; any other face
//! is one more implementation.

use nalgebra::Vector3;
use std::fmt::Debug;

/// A rake face by the distance from it: `docs/mathematics/skiving.md#the-virtual-edge` asks for a gradient of length one.
pub trait RakeFace: Debug + Send + Sync {
    /// D(p), mm, > 0 outside of the material.
    fn distance(&self, p: &Vector3<f64>) -> f64;

    /// n_r: the gradient of D at a point, a unit vector towards +z.
    fn normal(&self, p: &Vector3<f64>) -> Vector3<f64>;
}

/// A plane through the pitch point of tooth 0; a stepped tool has one for every tooth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneRake {
    normal: Vector3<f64>,
    pitch_radius: f64,
}

impl PlaneRake {
    /// A plane with rake angle and step angle (the tool's helix angle puts it across the tooth), rad.
    pub fn new(rake_angle: f64, step_angle: f64, pitch_radius: f64) -> Self {
        let (sin, cos) = rake_angle.sin_cos();
        let (sin_step, cos_step) = step_angle.sin_cos();
        // Ry(-sigma) Rx(gamma_r) e_z.
        Self { normal: Vector3::new(-cos * sin_step, -sin, cos * cos_step), pitch_radius }
    }
}

impl RakeFace for PlaneRake {
    fn distance(&self, p: &Vector3<f64>) -> f64 {
        self.normal.dot(p) - self.normal.y * self.pitch_radius
    }

    fn normal(&self, _: &Vector3<f64>) -> Vector3<f64> {
        self.normal
    }
}

/// A cone about the tool's axis, common to all teeth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConeRake {
    sin: f64,
    cos: f64,
    pitch_radius: f64,
}

impl ConeRake {
    /// A cone with a rake angle, rad.
    pub fn new(rake_angle: f64, pitch_radius: f64) -> Self {
        let (sin, cos) = rake_angle.sin_cos();
        Self { sin, cos, pitch_radius }
    }
}

impl RakeFace for ConeRake {
    fn distance(&self, p: &Vector3<f64>) -> f64 {
        p.z * self.cos - (p.x.hypot(p.y) - self.pitch_radius) * self.sin
    }

    fn normal(&self, p: &Vector3<f64>) -> Vector3<f64> {
        let r = p.x.hypot(p.y);
        Vector3::new(-self.sin * p.x / r, -self.sin * p.y / r, self.cos)
    }
}

/// A hollow sphere about the tool's axis, as a cup wheel grinds it: the rake angle grows towards the tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphericalRake {
    radius: f64,
    centre: Vector3<f64>,
}

impl SphericalRake {
    /// The sphere that has a rake angle (rad) at the pitch radius: its radius is r_1/sin(gamma_r), mm.
    pub fn new(rake_angle: f64, pitch_radius: f64) -> Self {
        let (sin, cos) = rake_angle.sin_cos();
        let radius = pitch_radius / sin;
        Self { radius, centre: Vector3::new(0.0, 0.0, radius * cos) }
    }
}

impl RakeFace for SphericalRake {
    fn distance(&self, p: &Vector3<f64>) -> f64 {
        self.radius - (p - self.centre).norm()
    }

    fn normal(&self, p: &Vector3<f64>) -> Vector3<f64> {
        (self.centre - p).normalize()
    }
}
