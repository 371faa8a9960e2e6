//! A path of the dresser along one line of the worm flank (`docs/mathematics/dressing.md#conditions`): positions over a path parameter,
//! without the screw coupling of a dressing stroke.

use super::{DressingPosition, MotionLaw};
use crate::numerics::Scalar;

/// Positions of dresser and worm over the path parameter t, mm.
#[derive(Clone, Debug, PartialEq)]
pub struct DressingPath {
    /// First and last t.
    pub domain: [f64; 2],
    /// phi_S over t, rad; full turns kept.
    pub worm_angle: MotionLaw,
    /// v_zS over t, mm.
    pub worm_shift: MotionLaw,
    /// d_A over t, mm.
    pub centre_distance: MotionLaw,
    /// gamma_A, rad.
    pub crossing_angle: f64,
    /// v_yA, mm.
    pub offset: f64,
}

impl DressingPath {
    /// Position at t. A dual argument gives the velocities along with it.
    pub fn position<T: Scalar>(&self, t: T) -> DressingPosition<T> {
        DressingPosition {
            worm_angle: self.worm_angle.lifted(t)[0],
            worm_shift: self.worm_shift.lifted(t)[0],
            crossing_angle: T::from(self.crossing_angle),
            centre_distance: self.centre_distance.lifted(t)[0],
            offset: T::from(self.offset),
        }
    }
}
