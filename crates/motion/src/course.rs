//! What two bodies do against each other in a stroke, and how far a pose of the machine is off it on the flank.

use super::waypoint::{BodyPlace, Waypoint};
use super::{DressingCourse, GrindingCourse, LineCourse};
use foundation::kinematics::Pose;
use machine::{Mounts, Station, StationSpindle, ToolSpindle};

/// The motion of the bodies in a stroke.
#[derive(Clone, Debug)]
pub enum Course {
    /// Worm on workpiece.
    Grinding(GrindingCourse),
    /// Worm on dresser.
    Dressing(DressingCourse),
    /// Worm on a disc that writes one line of it.
    Line(LineCourse),
}

impl Course {
    /// Where it happens.
    pub fn station(&self) -> Station {
        match self {
            Self::Grinding(_) => Station::Work,
            Self::Dressing(_) | Self::Line(_) => Station::Dresser,
        }
    }

    /// How the bodies are clamped.
    pub fn mounts(&self) -> &Mounts {
        match self {
            Self::Grinding(course) => &course.mounts,
            Self::Dressing(course) => &course.mounts,
            Self::Line(course) => &course.mounts,
        }
    }

    /// Where the spindles are wanted.
    pub fn place(&self, at: &Waypoint) -> BodyPlace {
        match self {
            Self::Grinding(course) => course.place(at),
            Self::Dressing(course) => course.place(at),
            Self::Line(course) => course.place(at),
        }
    }

    /// Bound of the deviation (mm, normal) that a pose leaves on the flank against the course at its own place on it; `near` is a
    /// place nearby. `None` for a pose of other bodies.
    pub fn off(&self, pose: &Pose<ToolSpindle, StationSpindle>, near: &Waypoint) -> Option<f64> {
        match self {
            Self::Grinding(course) => course.off(pose, near),
            Self::Dressing(course) => course.off(pose, near),
            Self::Line(course) => course.off(pose, near),
        }
    }
}
