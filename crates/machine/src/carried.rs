//! What is fixed to an axis of a machine: where it stands, and how far turning axes can move it.

use super::{Bed, Joint, Limb, Machine, MachineError, Positions, Station, StationSpindle, ToolSpindle};
use foundation::geometry::TurnedBody;
use foundation::kinematics::Pose;

impl Machine {
    /// The limb that an axis belongs to, by its number: `None` for that of the tool, else the station; and the axes that move what is
    /// fixed to it, from the bed outwards, its own last.
    pub fn carriers(&self, axis: usize) -> Option<(Option<Station>, Vec<usize>)> {
        let in_limb = |limb: &Limb| {
            let place = limb.axes.iter().position(|known| *known == axis)?;
            Some(limb.axes[..=place].to_vec())
        };
        let limbs = [
            (None, Some(self.tool())),
            (Some(Station::Work), self.station(Station::Work).ok()),
            (Some(Station::Dresser), self.station(Station::Dresser).ok()),
        ];
        limbs.into_iter().find_map(|(station, limb)| Some((station, in_limb(limb?)?)))
    }

    /// Coordinates of the bed as they are with all axes at zero into those of the bed, for what these axes carry.
    pub fn carried(&self, carriers: &[usize], at: &Positions) -> Pose<Bed, Bed> {
        carriers
            .iter()
            .fold(Pose::<Bed, Bed>::identity(), |pose, &axis| pose.then(&self.elementary(axis, at[axis])))
    }

    /// The tool's spindle in the bed with all axes at zero.
    pub fn tool_at_zero(&self) -> Pose<Bed, ToolSpindle> {
        self.tool().home()
    }

    /// The spindle of a station in the bed with all axes at zero.
    ///
    /// # Errors
    /// [`MachineError::MissingAxis`] for the dresser of a machine without one.
    pub fn station_at_zero(&self, station: Station) -> Result<Pose<Bed, StationSpindle>, MachineError> {
        Ok(self.station(station)?.home())
    }

    /// By how much the rotary axes among these move any point of a body at most while they go straight from one place to another, mm; over
    /// a part of the way by that part of it. `body`: with all axes at zero.
    pub fn way_by_turning(&self, carriers: &[usize], body: &TurnedBody, ends: [&Positions; 2]) -> f64 {
        let by = |(number, &axis): (usize, &usize)| {
            let turned = (ends[1][axis] - ends[0][axis]).abs();
            if turned == 0.0 || self.joint(axis) == Joint::Linear {
                return 0.0;
            }
            turned * self.reach(axis, &carriers[number + 1..], body, ends)
        };
        carriers.iter().enumerate().map(by).sum()
    }

    /// How far a body can come from a point of a rotary axis by the axes outside of it, mm.
    fn reach(&self, axis: usize, outside: &[usize], body: &TurnedBody, ends: [&Positions; 2]) -> f64 {
        let mut place = self.axes()[axis].point;
        let mut moved = 0.0;
        for &other in outside {
            let most = ends.iter().map(|at| at[other].abs()).fold(0.0, f64::max);
            match self.joint(other) {
                _ if most == 0.0 => {}
                Joint::Linear => moved += most,
                Joint::Rotary => {
                    let point = self.axes()[other].point;
                    moved += (point - place).norm();
                    place = point;
                }
            }
        }
        body.reach(&place) + moved
    }
}
