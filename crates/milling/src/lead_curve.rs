//! Guide curves: the lines on the base body along which column planes stand (`docs/mathematics/milling.md#columns-and-rows`).

use super::MillingError;
use foundation::geometry::{BladeCurve, FlankLine};
use nalgebra::Vector3;
use std::fmt::Debug;
use std::sync::Arc;

/// A point of a guide curve with its frame. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeadPoint {
    /// Parameter of the curve: z, distance from the apex, or a fraction.
    pub u: f64,
    /// c: the point.
    pub point: Vector3<f64>,
    /// t: unit normal of the column plane, the direction of the curve unless planes are set askew.
    pub direction: Vector3<f64>,
    /// N: unit normal of the base body, out of its material.
    pub base_normal: Vector3<f64>,
}

/// How far the direction of a guide curve may leave the base body: its sine. A curve that is meant to lie on the body is exact to
/// rounding; 1e-9 is the bound of `docs/mathematics/milling.md#columns-and-rows`.
const OFF_BASE: f64 = 1e-9;

impl LeadPoint {
    /// A point of any curve on a base body, from unit or other vectors.
    ///
    /// # Errors
    /// [`MillingError::LeadOffBase`] if the direction leaves the base body or a vector has no direction.
    pub fn new(
        u: f64,
        point: Vector3<f64>,
        direction: &Vector3<f64>,
        base_normal: &Vector3<f64>,
    ) -> Result<Self, MillingError> {
        let (direction, base_normal) = (direction.normalize(), base_normal.normalize());
        let sine = direction.dot(&base_normal);
        if sine.abs() <= OFF_BASE && point.iter().all(|x| x.is_finite()) {
            Ok(Self { u, point, direction, base_normal })
        } else {
            Err(MillingError::LeadOffBase { u, sine })
        }
    }

    /// X_2 = N x t: the abscissa of the column plane; its ordinate is N.
    pub fn abscissa(&self) -> Vector3<f64> {
        self.base_normal.cross(&self.direction)
    }

    /// Coordinates of a point in the column plane, mm.
    pub fn in_plane(&self, point: &Vector3<f64>) -> [f64; 2] {
        let from = point - self.point;
        [from.dot(&self.abscissa()), from.dot(&self.base_normal)]
    }
}

/// A curve on the base body.
pub trait LeadCurve: Send + Sync + Debug {
    /// The point at the parameter u with its frame.
    ///
    /// # Errors
    /// [`MillingError::LeadOffBase`] where the curve has no direction or leaves the base body.
    fn at(&self, u: f64) -> Result<LeadPoint, MillingError>;
}

/// In cylindrical gears: the middle of the space on a cylinder, by default the root cylinder. u = z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HelixOnCylinder {
    /// r_0: radius, mm.
    pub radius: f64,
    /// k: turn of the space along the axis, rad/mm.
    pub turn_per_length: f64,
    /// +1 external, -1 internal: the base body's material lies inside or outside of the cylinder.
    pub external_sign: f64,
}

impl LeadCurve for HelixOnCylinder {
    fn at(&self, u: f64) -> Result<LeadPoint, MillingError> {
        let (sin, cos) = (-self.turn_per_length * u).sin_cos();
        let point = Vector3::new(self.radius * sin, self.radius * cos, u);
        let along = Vector3::new(-self.turn_per_length * point.y, self.turn_per_length * point.x, 1.0);
        let base_normal = Vector3::new(sin, cos, 0.0) * self.external_sign;
        LeadPoint::new(u, point, &along, &base_normal)
    }
}

/// In conical involute gears: the middle of the space on a cone about the axis, by default the root cone. u = z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HelixOnCone {
    /// Radius at z = 0, mm.
    pub radius: f64,
    /// Change of the radius along the axis.
    pub slope: f64,
    /// k: turn of the middle of the space along the axis, rad/mm.
    pub turn_per_length: f64,
}

impl LeadCurve for HelixOnCone {
    fn at(&self, u: f64) -> Result<LeadPoint, MillingError> {
        let (sin, cos) = (-self.turn_per_length * u).sin_cos();
        let (radial, radius) = (Vector3::new(sin, cos, 0.0), self.radius + self.slope * u);
        let point = radial * radius + Vector3::z() * u;
        let along = Vector3::new(-self.turn_per_length * point.y, self.turn_per_length * point.x, 1.0)
            + radial * self.slope;
        LeadPoint::new(u, point, &along, &(radial - Vector3::z() * self.slope))
    }
}

/// In bevel gears: the middle of the space on a cone about the axis with its apex at the origin, by default the root cone. u =
/// distance from the apex.
#[derive(Clone, Debug, PartialEq)]
pub struct CurveOnCone {
    /// Half angle of the cone, rad.
    pub cone_angle: f64,
    /// Theta(u): the turn of the space, as the flank has it.
    pub line: FlankLine,
}

impl LeadCurve for CurveOnCone {
    fn at(&self, u: f64) -> Result<LeadPoint, MillingError> {
        let [turn, slope, ..] = self.line.derivatives(u);
        let ((sin, cos), (sin_cone, cos_cone)) = ((-turn).sin_cos(), self.cone_angle.sin_cos());
        let (radial, tangential) = (Vector3::new(sin, cos, 0.0), Vector3::new(cos, -sin, 0.0));
        let axial = Vector3::z();
        let outward = radial * sin_cone + axial * cos_cone;
        let along = outward - tangential * (u * sin_cone * slope);
        LeadPoint::new(u, outward * u, &along, &(radial * cos_cone - axial * sin_cone))
    }
}

/// In blades: the foot curve on a hub of revolution whose meridian it follows (`docs/mathematics/milling.md#flanks-as-patches`). u = the
/// curve's parameter.
#[derive(Clone, Debug)]
pub struct FootOnHub {
    /// The curve.
    pub curve: Arc<dyn BladeCurve>,
}

impl LeadCurve for FootOnHub {
    fn at(&self, u: f64) -> Result<LeadPoint, MillingError> {
        let [point, along, ..] = self.curve.derivatives(u);
        let radial = Vector3::new(point.x, point.y, 0.0).normalize();
        // Along the meridian the radius changes by `widens` while the position changes by `rises`.
        let (widens, rises) = (along.dot(&radial), along.z);
        LeadPoint::new(u, point, &along, &(radial * rises.abs() - Vector3::z() * (widens * rises.signum())))
    }
}

/// Column planes turned about the base body's normal (claim of skew planes): t := cos(chi) t + sin(chi) (N x t).
#[derive(Clone, Debug)]
pub struct SkewPlanes {
    /// The guide curve.
    pub curve: Arc<dyn LeadCurve>,
    /// chi, rad.
    pub angle: f64,
}

impl LeadCurve for SkewPlanes {
    fn at(&self, u: f64) -> Result<LeadPoint, MillingError> {
        let upright = self.curve.at(u)?;
        let (sin, cos) = self.angle.sin_cos();
        Ok(LeadPoint { direction: upright.direction * cos + upright.abscissa() * sin, ..upright })
    }
}

/// The mirror image z -> 2 z_0 - z of a guide curve that runs towards +z, run towards +z as well: that of the other half of a
/// double-helical gear (`docs/mathematics/milling.md#flanks-as-patches`). u is mirrored with it.
#[derive(Clone, Debug)]
pub struct MirroredLead {
    /// The guide curve of the half towards +z.
    pub curve: Arc<dyn LeadCurve>,
    /// z_0, mm.
    pub plane: f64,
}

impl LeadCurve for MirroredLead {
    fn at(&self, u: f64) -> Result<LeadPoint, MillingError> {
        let image = |v: Vector3<f64>| Vector3::new(v.x, v.y, -v.z);
        let of = self.curve.at(2.0 * self.plane - u)?;
        let point = image(of.point) + Vector3::z() * (2.0 * self.plane);
        Ok(LeadPoint { u, point, direction: -image(of.direction), base_normal: image(of.base_normal) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_helix_on_a_cone_stays_on_it_with_its_frame() {
        let cone = HelixOnCone { radius: 40.0, slope: -0.12, turn_per_length: 0.004 };
        for u in [-20.0, 0.0, 13.0] {
            let at = cone.at(u).unwrap();
            assert!((at.point.xy().norm() - (40.0 - 0.12 * u)).abs() < 1e-12 && at.point.z == u);
            let by = 1e-5;
            let along = (cone.at(u + by).unwrap().point - cone.at(u - by).unwrap().point).normalize();
            assert!((along - at.direction).norm() < 1e-9);
            assert!(at.base_normal.dot(&at.point) > 0.0 && at.base_normal.dot(&along).abs() < 1e-9);
        }
        let flat = HelixOnCone { slope: 0.0, ..cone }.at(7.0).unwrap();
        let cylinder = HelixOnCylinder { radius: 40.0, turn_per_length: 0.004, external_sign: 1.0 };
        assert_eq!(flat, cylinder.at(7.0).unwrap());
    }

    #[test]
    fn the_lead_curve_of_the_other_half_is_a_helix_of_the_other_hand() {
        let curve = Arc::new(HelixOnCylinder { radius: 60.0, turn_per_length: 0.01, external_sign: 1.0 });
        let mirrored = MirroredLead { curve, plane: 4.0 };
        // Turned, because both meet at z = 4 and not at z = 0.
        let other = HelixOnCylinder { radius: 60.0, turn_per_length: -0.01, external_sign: 1.0 };
        let turn = nalgebra::Rotation3::from_axis_angle(&Vector3::z_axis(), 2.0 * 4.0 * 0.01);
        for u in [-9.0, 4.0, 17.0] {
            let (found, plain) = (mirrored.at(u).unwrap(), other.at(u).unwrap());
            assert!((found.point - turn * plain.point).norm() < 1e-12);
            assert!((found.direction - turn * plain.direction).norm() < 1e-14);
            assert!((found.base_normal - turn * plain.base_normal).norm() < 1e-14);
            assert_eq!(found.u, u);
        }
    }
}
