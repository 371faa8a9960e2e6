//! Forward kinematics of the tree: axis positions -> poses, by products of exponentials
//! (`docs/mathematics/programs.md#from-bodies-to-axes`).

use super::frames::{Bed, Station, StationSpindle, ToolSpindle};
use super::{Joint, Limb, Machine, MachineError, Positions};
use foundation::kinematics::Pose;
use nalgebra::Vector3;

/// An axis as it stands while the axes before it have moved, in M.
#[derive(Clone, Copy, Debug)]
pub(super) struct Standing {
    pub axis: usize,
    pub direction: Vector3<f64>,
    pub point: Vector3<f64>,
}

impl Machine {
    /// H: coordinates of the station's spindle into those of the tool spindle.
    ///
    /// # Errors
    /// [`MachineError::MissingAxis`]; [`MachineError::InvalidNumber`].
    pub fn pose(
        &self,
        station: Station,
        at: &Positions,
    ) -> Result<Pose<ToolSpindle, StationSpindle>, MachineError> {
        let other = self.station(station)?;
        for axis in self.axes_at(station)? {
            let value = at[axis];
            if !value.is_finite() {
                return Err(MachineError::InvalidNumber { field: self.axes()[axis].name.clone(), value });
            }
        }
        let tool: Pose<Bed, ToolSpindle> = self.limb(self.tool(), at);
        Ok(tool.inverse().then(&self.limb::<StationSpindle>(other, at)))
    }

    /// Spindle of a limb in M.
    pub(super) fn limb<Spindle>(&self, limb: &Limb, at: &Positions) -> Pose<Bed, Spindle> {
        let mut pose = Pose::<Bed, Bed>::identity();
        for &axis in &limb.axes {
            pose = pose.then(&self.elementary(axis, at[axis]));
        }
        pose.then(&limb.home())
    }

    /// E_k(q) of one axis.
    pub(super) fn elementary(&self, axis: usize, value: f64) -> Pose<Bed, Bed> {
        let axis = &self.axes()[axis];
        match axis.joint {
            Joint::Linear => Pose::along(&axis.direction, value),
            Joint::Rotary => Pose::about(&axis.direction, &axis.point, value),
        }
    }

    /// The axes of a limb where they stand in M at these positions.
    pub(super) fn standing(&self, limb: &Limb, at: &Positions) -> Vec<Standing> {
        let mut pose = Pose::<Bed, Bed>::identity();
        limb.axes
            .iter()
            .map(|&number| {
                let axis = &self.axes()[number];
                let direction = pose.rotation() * axis.direction;
                let point = pose.rotation() * axis.point + pose.translation();
                pose = pose.then(&self.elementary(number, at[number]));
                Standing { axis: number, direction, point }
            })
            .collect()
    }
}
