//! The cylinder that feels: a light beam or a stylus, fixed in the machine. Machine axes: X along the common normal, Z along the
//! workpiece's axis, the tool on A about X and B about its own axis (`docs/mathematics/skiving.md#tracks-and-poses`).

use crate::SkivingError;
use nalgebra::Vector3;

/// A cylinder about a line through a point. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beam {
    /// M: a point of its axis, where contacts are laid.
    pub point: Vector3<f64>,
    /// l: its direction, not of unit length: (tan delta, tan eps, 1).
    pub direction: Vector3<f64>,
    /// r_L: its effective radius.
    pub radius: f64,
}

/// The largest tilt, rad: a beam that lies down does not measure a tool that stands.
const LARGEST_TILT: f64 = std::f64::consts::FRAC_PI_4;

impl Beam {
    /// A beam tilted by delta in the X-Z plane and by eps in the Y-Z plane, rad.
    ///
    /// # Errors
    /// [`SkivingError::InvalidNumber`].
    pub fn new(point: Vector3<f64>, [delta, eps]: [f64; 2], radius: f64) -> Result<Self, SkivingError> {
        let number = |field, value: f64, good: bool, allowed| {
            if good { Ok(()) } else { Err(SkivingError::InvalidNumber { field, value, allowed }) }
        };
        for (field, value) in [("beam.x", point.x), ("beam.y", point.y), ("beam.z", point.z)] {
            number(field, value, value.is_finite(), "a finite length")?;
        }
        for (field, value) in [("beam.tilt_x_deg", delta), ("beam.tilt_y_deg", eps)] {
            number(field, value.to_degrees(), value.abs() <= LARGEST_TILT, "-45 to 45 deg")?;
        }
        number("beam.radius", radius, radius.is_finite() && radius > 0.0, "> 0 mm")?;
        Ok(Self { point, direction: Vector3::new(delta.tan(), eps.tan(), 1.0), radius })
    }

    /// The unit direction.
    pub fn unit(&self) -> Vector3<f64> {
        self.direction.normalize()
    }
}
