//! How a body is clamped in its spindle, and what that makes of the pose of two bodies
//! (`docs/mathematics/generating-contact.md#machine-chains`).

use super::{StationSpindle, ToolSpindle};
use foundation::kinematics::Pose;

/// How a body sits in a spindle: spindle <- body = Tz(z_0) Rz(phi_0) F.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mount {
    /// Whether +z of the body points into -z of its spindle: F = Rx(180 deg).
    pub reversed: bool,
    /// z_0, mm.
    pub axial: f64,
    /// phi_0, rad.
    pub angle: f64,
}

impl Mount {
    /// r: +1, or -1 for a reversed body. The spindle turns by r times the angle of the body.
    pub fn sense(&self) -> f64 {
        if self.reversed { -1.0 } else { 1.0 }
    }

    /// Coordinates of the body into those of its spindle.
    pub fn pose<Spindle, Body>(&self) -> Pose<Spindle, Body> {
        let clamped = Pose::<Spindle, Spindle>::tz(self.axial).then(&Pose::<Spindle, Body>::rz(self.angle));
        if self.reversed { clamped.then(&reversal()) } else { clamped }
    }
}

/// F(-1) = diag(1, -1, -1), exactly.
fn reversal<Body>() -> Pose<Body, Body> {
    use nalgebra::{Matrix3, Vector3};
    Pose::rigid(Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, -1.0)), Vector3::zeros())
}

/// How tool and counterpart are clamped.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mounts {
    /// The tool in its spindle: W.
    pub tool: Mount,
    /// The counterpart in its spindle: U, or U_A of the dresser.
    pub counterpart: Mount,
}

impl Mounts {
    /// H = W K U^-1: the wanted pose of the spindles from that of the bodies.
    pub fn spindles<Tool, Body>(&self, bodies: &Pose<Tool, Body>) -> Pose<ToolSpindle, StationSpindle> {
        let tool: Pose<ToolSpindle, Tool> = self.tool.pose();
        let counterpart: Pose<StationSpindle, Body> = self.counterpart.pose();
        tool.then(bodies).then(&counterpart.inverse())
    }

    /// K = W^-1 H U: the pose of the bodies from that of the spindles.
    pub fn bodies<Tool, Body>(&self, spindles: &Pose<ToolSpindle, StationSpindle>) -> Pose<Tool, Body> {
        let tool: Pose<ToolSpindle, Tool> = self.tool.pose();
        let counterpart: Pose<StationSpindle, Body> = self.counterpart.pose();
        tool.inverse().then(spindles).then(&counterpart)
    }
}
