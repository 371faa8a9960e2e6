//! The beam of the light barrier as the job states it.

use crate::SkivingError;
use crate::job::LightBarrier;
use crate::measuring::Beam;
use nalgebra::Vector3;

/// The beam as the job gives it.
pub(super) fn nominal_beam(given: &LightBarrier) -> Result<Beam, SkivingError> {
    if let Some(direction) = given.direction {
        return Beam::along(Vector3::from(given.point), Vector3::from(direction), given.radius);
    }
    let tilts = [given.tilt_x_deg, given.tilt_y_deg].map(f64::to_radians);
    Beam::new(Vector3::from(given.point), tilts, given.radius)
}
