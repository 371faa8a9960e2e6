//! How each axis moves the counterpart against the tool, and what that does to the flank
//! (`docs/mathematics/generating-contact.md#machine-chains`).

use super::{Joint, Machine, MachineError, Positions, Station, ToolSpindle};
use foundation::kinematics::{Direction, Point};
use nalgebra::Vector3;

/// Velocity of the counterpart against the tool per unit of an axis (rad or mm), in M: v(X) = turning x X + sliding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MachineTwist {
    /// Number of the axis.
    pub axis: usize,
    /// Angular velocity, rad per unit.
    pub turning: Vector3<f64>,
    /// Velocity of the point of the body that is at the origin of M, mm per unit.
    pub sliding: Vector3<f64>,
}

impl Machine {
    /// Twists of all axes that move tool or station.
    ///
    /// # Errors
    /// [`MachineError::MissingAxis`].
    pub fn twists(&self, station: Station, at: &Positions) -> Result<Vec<MachineTwist>, MachineError> {
        let limbs = [(self.tool(), -1.0), (self.station(station)?, 1.0)];
        let of_limb = |(limb, sense): (_, f64)| {
            self.standing(limb, at).into_iter().map(move |axis| {
                let direction = axis.direction * sense;
                let (turning, sliding) = match self.joint(axis.axis) {
                    Joint::Linear => (Vector3::zeros(), direction),
                    Joint::Rotary => (direction, -direction.cross(&axis.point)),
                };
                MachineTwist { axis: axis.axis, turning, sliding }
            })
        };
        Ok(limbs.into_iter().flat_map(of_limb).collect())
    }

    /// What each axis leaves on the flank at a contact: d(material left)/dq in mm per rad or mm, with the point and the outward
    /// normal of the tool in its spindle's coordinates. The same for both jobs: left on the workpiece, or left on the tool.
    ///
    /// # Errors
    /// [`MachineError::MissingAxis`].
    pub fn influence(
        &self,
        station: Station,
        at: &Positions,
        point: &Point<ToolSpindle>,
        normal: &Direction<ToolSpindle>,
    ) -> Result<Vec<(usize, f64)>, MachineError> {
        let tool = self.limb::<ToolSpindle>(self.tool(), at);
        let (x, n) = (tool.point(point).xyz, tool.direction(normal).xyz);
        let left = |twist: MachineTwist| (twist.axis, n.dot(&(twist.turning.cross(&x) + twist.sliding)));
        Ok(self.twists(station, at)?.into_iter().map(left).collect())
    }
}
