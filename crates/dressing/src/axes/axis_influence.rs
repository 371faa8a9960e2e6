//! What a small deviation of one machine axis does to the worm flank that is being dressed
//! (`docs/mathematics/generating-contact.md#machine-chains`, `docs/mathematics/dressing.md#what-a-corrected-dresser-leaves`). Knows the motion by each axis and the contact, not how either was found.

use foundation::kinematics::AxisTwist;
use nalgebra::Vector3;

/// A point at which the dresser touches the worm, in worm coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WormContact {
    /// The point, mm.
    pub point: Vector3<f64>,
    /// Normal out of the worm as it is dressed, any length.
    pub normal: Vector3<f64>,
    /// Unit normal of the unmodified flank along which deviations are measured.
    pub nominal: Vector3<f64>,
}

impl WormContact {
    /// df_n1/dq of every axis in the order of [`foundation::kinematics::DressingAxis::ALL`], mm/rad and 1: by how much more
    /// material an axis leaves on the worm when it stands off by a unit during the whole stroke. Exact to first order at any
    /// modification; the rotation of the dresser leaves nothing.
    pub fn influence(&self, twists: &[AxisTwist; 7]) -> [f64; 7] {
        let facing = self.normal.dot(&self.nominal);
        twists.map(|axis| self.normal.dot(&axis.velocity(&self.point)) / facing)
    }
}
