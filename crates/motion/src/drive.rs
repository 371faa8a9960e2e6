//! A machine that follows a course: places of the bodies -> positions of the axes, one after the other.

use super::{BodyPlace, Course, MotionError, Waypoint};
use machine::{DressingRule, Follower, Machine, Positions, Station};

/// Where a machine stands on its way along a course.
#[derive(Clone)]
pub(super) struct Drive<'a> {
    machine: &'a Machine,
    course: &'a Course,
    stroke: &'a str,
    /// Angle of the dresser's swivel, rad.
    swivel: f64,
    follower: Follower<'a>,
}

impl<'a> Drive<'a> {
    pub fn new(machine: &'a Machine, course: &'a Course, stroke: &'a str, swivel: f64) -> Self {
        let mounts = course.mounts();
        let senses = [mounts.tool.sense(), mounts.counterpart.sense()];
        let follower = Follower::new(machine, course.station(), senses);
        Self { machine, course, stroke, swivel, follower }
    }

    /// Positions of all axes at a place.
    ///
    /// # Errors
    /// [`MotionError::Machine`] with the place.
    pub fn stand(&mut self, at: &Waypoint) -> Result<Positions, MotionError> {
        let BodyPlace { pose, angles } = self.course.place(at);
        let found = match self.course.station() {
            Station::Work => self.machine.grinding(&pose),
            Station::Dresser => {
                let worm = self.follower.worm().unwrap_or(angles[0]);
                self.machine.dressing(&pose, DressingRule::Swivel(self.swivel), Some(worm))
            }
        };
        found.and_then(|found| self.follower.next(found, angles)).map_err(|error| MotionError::Machine {
            stroke: self.stroke.to_owned(),
            v: at.v,
            error,
        })
    }
}
