//! A place of a stroke, and the pose that is wanted there.

use foundation::kinematics::{DressingPosition, Pose};
use machine::{Mounts, StationSpindle, ToolSpindle};

/// A place of a stroke.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Waypoint {
    /// Path parameter: z_V2 in grinding, v_zS in dressing, t on a line, mm.
    pub v: f64,
    /// Added to the centre distance, mm: the tool stands off.
    pub lift: f64,
    /// Added to the angle of the tool, rad; the coupled body follows.
    pub lead: f64,
}

/// A wanted pose of the spindles with the bodies' own angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyPlace {
    /// H.
    pub pose: Pose<ToolSpindle, StationSpindle>,
    /// Angles of tool and counterpart, rad, full turns kept.
    pub angles: [f64; 2],
}

impl BodyPlace {
    /// Worm and dresser at a position; the dresser, a body of revolution, has no angle.
    pub(super) fn of_dressing(mounts: &Mounts, position: &DressingPosition) -> Self {
        Self { pose: mounts.spindles(&position.pose()), angles: [position.worm_angle, 0.0] }
    }
}
