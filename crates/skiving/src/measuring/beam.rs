//! The cylinder that feels: a light beam or a stylus, fixed in the machine. Machine axes: X along the common normal, Z along the
//! workpiece's axis, the tool on A about X and B about its own axis (`docs/mathematics/skiving.md#tracks-and-poses`).

use crate::SkivingError;
use nalgebra::Vector3;

/// A cylinder about a line through a point. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beam {
    /// M: a point of its axis, where contacts are laid.
    pub point: Vector3<f64>,
    /// l: its direction, not of unit length; the rake face of a tool that is measured looks that way.
    pub direction: Vector3<f64>,
    /// k: normal of the plane through M in which contacts are laid: e_z of a tilted beam, l of one that is given by its direction.
    pub level: Vector3<f64>,
    /// r_L: its effective radius.
    pub radius: f64,
}

/// Tilts stay below this, rad: a beam that lies down has none, and is given by its direction.
const LYING: f64 = std::f64::consts::FRAC_PI_2;

impl Beam {
    /// A beam tilted by delta in the X-Z plane and by eps in the Y-Z plane, rad: l = (tan delta, tan eps, 1). Contacts are laid at the
    /// height of its point.
    ///
    /// # Errors
    /// [`SkivingError::InvalidNumber`].
    pub fn new(point: Vector3<f64>, [delta, eps]: [f64; 2], radius: f64) -> Result<Self, SkivingError> {
        for (field, value) in [("beam.tilt_x_deg", delta), ("beam.tilt_y_deg", eps)] {
            number(field, value.to_degrees(), value.abs() < LYING, "between -90 and 90 deg")?;
        }
        check(&point, radius)?;
        Ok(Self { point, direction: Vector3::new(delta.tan(), eps.tan(), 1.0), level: Vector3::z(), radius })
    }

    /// A beam in any direction, lying ones too. Contacts are laid in the plane across it through its point.
    ///
    /// # Errors
    /// [`SkivingError::InvalidNumber`].
    pub fn along(point: Vector3<f64>, direction: Vector3<f64>, radius: f64) -> Result<Self, SkivingError> {
        let length = direction.norm();
        number(
            "beam.direction",
            length,
            length.is_finite() && length > 0.0,
            "a vector of finite numbers, not 0",
        )?;
        check(&point, radius)?;
        let unit = direction / length;
        Ok(Self { point, direction: unit, level: unit, radius })
    }

    /// The unit direction.
    pub fn unit(&self) -> Vector3<f64> {
        self.direction.normalize()
    }
}

fn check(point: &Vector3<f64>, radius: f64) -> Result<(), SkivingError> {
    for (field, value) in [("beam.x", point.x), ("beam.y", point.y), ("beam.z", point.z)] {
        number(field, value, value.is_finite(), "a finite length")?;
    }
    number("beam.radius", radius, radius.is_finite() && radius > 0.0, "> 0 mm")
}

fn number(field: &'static str, value: f64, good: bool, allowed: &'static str) -> Result<(), SkivingError> {
    if good { Ok(()) } else { Err(SkivingError::InvalidNumber { field, value, allowed }) }
}
