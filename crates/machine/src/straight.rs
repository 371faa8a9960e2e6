//! How far a tool leaves the chord of its ends while all axes run straight from one position to another: a bound that holds for
//! every chain, from the second derivatives of the product of motions (`docs/mathematics/milling.md#positions-of-five-axes`, blocks without
//! RTCP).

use super::frames::ToolSpindle;
use super::{Joint, Machine, MachineError, Positions, Station};
use foundation::kinematics::Point;

/// Bounds over one straight block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StraightBound {
    /// Largest second derivative of the tool's point with the share of the block, in the station, mm.
    pub bend: f64,
    /// Largest rate of the tool's axis with the share of the block, in the station, rad.
    pub turn: f64,
}

impl StraightBound {
    /// How far the tool's point may be off the chord of its ends, mm.
    pub fn chord(&self) -> f64 {
        self.bend / 8.0
    }
}

impl Machine {
    /// Bounds of a tool's motion in the station over a straight block; `reach` is the point of the tool.
    ///
    /// # Errors
    /// As [`Machine::pose`].
    pub fn straight_bound(
        &self,
        station: Station,
        [from, to]: [&Positions; 2],
        reach: &Point<ToolSpindle>,
    ) -> Result<StraightBound, MachineError> {
        self.pose(station, from)?;
        self.pose(station, to)?;
        let mut middle = Positions::default();
        for k in 0..self.axes().len() {
            middle[k] = 0.5 * (from[k] + to[k]);
        }
        // From the tool towards the station: what an axis moves is moved on by those after it in this order. Seen in M, where the
        // axes of the station move the other way: distances and angles are the same.
        let other = self.station(station)?;
        let tip = self.limb(self.tool(), &middle).point(reach).xyz;
        let mut outwards = self.standing(self.tool(), &middle);
        outwards.reverse();
        outwards.extend(self.standing(other, &middle));
        let (mut bend, mut turn) = (0.0, 0.0);
        // How far the point may have moved from where it is in the middle by the axes so far, in half a block.
        let mut moved = 0.0;
        let mut speed = 0.0;
        for axis in outwards {
            let rate = (to[axis.axis] - from[axis.axis]).abs();
            let own = match self.joint(axis.axis) {
                Joint::Linear => rate,
                Joint::Rotary => {
                    let lever = axis.direction.cross(&(tip - axis.point)).norm() + moved;
                    // An axis turns what moves inside it, and what it moves itself.
                    bend += 2.0 * rate * speed + rate * rate * lever;
                    turn += rate;
                    rate * lever
                }
            };
            speed += own;
            moved += 0.5 * own;
        }
        Ok(StraightBound { bend, turn })
    }
}
