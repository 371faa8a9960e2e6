//! One flank of an involute gear, worm or beveloid: the surface of `docs/mathematics/involute-gears.md#flank-normal-curvature` and its
//! inverse.
//!
//! One formula serves external and internal, symmetric and asymmetric, cylindrical and conical bodies. Coordinates are
//! those of the body's own rest frame. Knows neither tooth thickness nor a second flank.

use super::{Flank, GeometryError};
use crate::numerics::Scalar;
use nalgebra::Vector3;

/// An unmodified involute flank: the involute helicoid of `docs/mathematics/conventions.md` for one tooth space. Lengths mm, angles rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InvoluteFlank {
    /// Which flank of the space.
    pub flank: Flank,
    /// Number of teeth without sign.
    pub teeth: f64,
    /// +1 external, -1 internal.
    pub external_sign: f64,
    /// Base radius r_b, mm (always positive).
    pub base_radius: f64,
    /// Base helix angle beta_b, rad, > 0 right-handed.
    pub base_helix_angle: f64,
    /// Base half-angle of the tooth space eta_b, rad; not reduced modulo 2 pi.
    pub base_space_half_angle: f64,
}

/// Directions at a flank point (`docs/mathematics/involute-gears.md#flank-normal-curvature`,
/// `docs/mathematics/generating-contact.md#what-the-grinding-motion-leaves-to-first-order`): unit vectors in body coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlankFrame<T: Scalar> {
    /// Radial direction of the tangent point on the base cylinder; direction of the curved section.
    pub e_r: Vector3<T>,
    /// Transverse direction across e_r.
    pub e_t: Vector3<T>,
    /// Normal out of the material.
    pub n: Vector3<T>,
    /// Straight generatrix.
    pub g: Vector3<T>,
}

/// Deviation of a point from a flank and the foot of the perpendicular.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlankDeviation<T: Scalar> {
    /// Normal deviation f_n, mm; > 0 outside the material.
    pub f_n: T,
    /// Length of roll of the foot, mm (>= 0; for internal gears without the sign of w_s).
    pub w: T,
    /// Axial position of the foot, mm.
    pub z: T,
}

impl InvoluteFlank {
    /// s of the flank as a number.
    pub fn s(&self) -> f64 {
        self.flank.sign()
    }

    /// tan(beta_b)/r_b, rad/mm: rotation of the helicoid per unit of z.
    pub fn twist_per_length(&self) -> f64 {
        self.base_helix_angle.tan() / self.base_radius
    }

    /// Angle phi of the tangent point on the base cylinder, from +y towards +x, rad.
    pub fn phi<T: Scalar>(&self, w: T, z: T) -> T {
        let s = self.s();
        (w * self.external_sign / self.base_radius + self.base_space_half_angle) * s
            - z * self.twist_per_length()
    }

    /// Unit directions at (w, z).
    pub fn frame<T: Scalar>(&self, w: T, z: T) -> FlankFrame<T> {
        let s = self.s();
        let (sin, cos) = self.phi(w, z).sin_cos();
        let (sb, cb) = self.base_helix_angle.sin_cos();
        let zero = T::from(0.0);
        let e_t = Vector3::new(cos * -s, sin * s, zero);
        FlankFrame {
            e_r: Vector3::new(sin, cos, zero),
            e_t,
            n: Vector3::new(e_t.x * cb, e_t.y * cb, T::from(-s * sb)),
            g: Vector3::new(e_t.x * (s * sb), e_t.y * (s * sb), T::from(cb)),
        }
    }

    /// Point at length of roll w >= 0 and axial position z.
    pub fn point<T: Scalar>(&self, w: T, z: T) -> Vector3<T> {
        let frame = self.frame(w, z);
        self.point_in(&frame, w, z)
    }

    /// Point from an already evaluated frame of the same (w, z).
    pub fn point_in<T: Scalar>(&self, frame: &FlankFrame<T>, w: T, z: T) -> Vector3<T> {
        let w_s = w * self.external_sign;
        let r_b = self.base_radius;
        Vector3::new(frame.e_r.x * r_b + frame.e_t.x * w_s, frame.e_r.y * r_b + frame.e_t.y * w_s, z)
    }

    /// Unit normal out of the material.
    pub fn normal<T: Scalar>(&self, w: T, z: T) -> Vector3<T> {
        self.frame(w, z).n
    }

    /// First principal curvature kappa_1 = cos(beta_b)/w_s along e_r, 1/mm (convex > 0); the second is 0 along g.
    pub fn curvature(&self, w: f64) -> f64 {
        self.base_helix_angle.cos() / (w * self.external_sign)
    }

    /// Both principal curvatures, 1/mm: along e_r and along the straight generatrix g.
    pub fn principal_curvatures(&self, w: f64) -> [f64; 2] {
        [self.curvature(w), 0.0]
    }

    /// Roll angle xi = w/r_b, rad.
    pub fn roll_angle(&self, w: f64) -> f64 {
        w / self.base_radius
    }

    /// Length of roll at radius r, mm.
    ///
    /// # Errors
    /// [`GeometryError::RadiusBelowBaseCircle`] for r < r_b.
    pub fn length_of_roll(&self, radius: f64) -> Result<f64, GeometryError> {
        if radius.is_nan() || radius < self.base_radius {
            return Err(GeometryError::RadiusBelowBaseCircle {
                flank: self.flank,
                radius,
                base_radius: self.base_radius,
            });
        }
        Ok(((radius - self.base_radius) * (radius + self.base_radius)).sqrt())
    }

    /// Radius at length of roll w, mm.
    pub fn radius(&self, w: f64) -> f64 {
        w.hypot(self.base_radius)
    }

    /// w_s of the circle through a point, and by how much the flank of tooth space 0 lags behind the point there, rad on the
    /// base circle. Inside the base cylinder both are NaN.
    fn lag<T: Scalar>(&self, x: &Vector3<T>) -> (T, T) {
        let (s, r_b) = (self.s(), self.base_radius);
        let w_s = (x.x * x.x + x.y * x.y - r_b * r_b).sqrt() * self.external_sign;
        let phi = x.x.atan2(x.y) + (w_s / r_b).atan() * s;
        (w_s, w_s / r_b + self.base_space_half_angle - phi * s - x.z * (s * self.twist_per_length()))
    }

    /// Number of the tooth space whose flank is nearest to a point, the one that [`InvoluteFlank::deviation`] measures
    /// from: 0 is centred on +y at z = 0, numbers rise in the positive sense of rotation about z and are not reduced
    /// modulo the number of teeth. Inside the base cylinder 0.
    pub fn nearest_space(&self, x: &Vector3<f64>) -> i64 {
        let pitch = 2.0 * std::f64::consts::PI / self.teeth;
        // The cast takes NaN to 0.
        (self.s() * (self.lag(x).1 / pitch).round()) as i64
    }

    /// Signed deviation of any point from the nearest tooth's flank and its foot
    /// (`docs/mathematics/involute-gears.md#flank-normal-curvature`; exact, no iteration). Valid while |f_n| is below half the normal base pitch. Inside the base cylinder the result is NaN.
    pub fn deviation<T: Scalar>(&self, x: &Vector3<T>) -> FlankDeviation<T> {
        let (s, sg, r_b) = (self.s(), self.external_sign, self.base_radius);
        let (sb, cb) = self.base_helix_angle.sin_cos();
        let (w_s, mut e) = self.lag(x);
        let pitch = 2.0 * std::f64::consts::PI / self.teeth;
        e -= T::from((crate::numerics::value_of(e) / pitch).round() * pitch);
        let f_n = e * (r_b * cb);
        FlankDeviation { f_n, w: (w_s - f_n * cb) * sg, z: x.z + f_n * (s * sb) }
    }
}
