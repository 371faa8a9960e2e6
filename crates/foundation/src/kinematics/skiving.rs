//! Power skiving: the coupled rotation of tool and workpiece on crossed axes (`docs/mathematics/skiving.md#tool-and-workpiece`). The chain
//! is that of generating grinding without cones; the helicoid of the workpiece goes over into itself under the feed, so that one feed
//! stands for all.

use super::{GeneratingChain, GeneratingState};
use nalgebra::Vector3;

/// Centre distance, crossed axes and coupling of a skiving process. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SkivingMotion {
    /// d, with sign: < 0 for an internal gear.
    pub centre_distance: f64,
    /// gamma.
    pub crossed_axes_angle: f64,
    /// z_V1: how far the tool's datum face stands off the common normal.
    pub tool_shift: f64,
    /// i21 = -z1/z2: turns of the workpiece per turn of the tool.
    pub ratio: f64,
    /// phi_10: angle of the tool at which its tooth 0 stands on the common normal.
    pub tool_angle: f64,
    /// phi_20: angle of the workpiece there, pi for an external gear, 0 for an internal one.
    pub work_angle: f64,
    /// p = tan(beta_b)/r_b: turn of the workpiece's helicoid per mm of feed.
    pub twist: f64,
}

impl SkivingMotion {
    /// The chain K_R of `docs/mathematics/conventions.md` with these distances.
    pub fn chain(&self) -> GeneratingChain {
        GeneratingChain {
            centre_distance: self.centre_distance,
            crossed_axes_angle: self.crossed_axes_angle,
            worm_cone: 0.0,
            work_cone: 0.0,
            worm_pivot: 0.0,
            work_pivot: 0.0,
        }
    }

    /// Both angles and the feed of the chain at an angle of the tool and an axial feed z_V2, mm: the feed turns the workpiece as well.
    pub fn state(&self, tool_angle: f64, feed: f64) -> GeneratingState {
        GeneratingState {
            worm_angle: tool_angle,
            work_angle: self.work_angle + self.ratio * (tool_angle - self.tool_angle) + self.twist * feed,
            shift: self.tool_shift,
            feed,
            delta_d: 0.0,
            delta_gamma: 0.0,
        }
    }

    /// The tool's angle at which the workpiece stands at an angle, without feed.
    pub fn tool_angle_at(&self, work_angle: f64) -> f64 {
        self.tool_angle + (work_angle - self.work_angle) / self.ratio
    }

    /// A point of the room beside the workpiece, q = Rz(phi_2) p, in coordinates of the tool at its angle.
    pub fn to_tool(&self, tool_angle: f64, q: &Vector3<f64>) -> Vector3<f64> {
        let turned = self.crossed(q);
        let at = Vector3::new(turned.x, turned.y + self.centre_distance, turned.z - self.tool_shift);
        turned_back(tool_angle, &at)
    }

    /// A direction of that room in coordinates of the tool.
    pub fn direction_to_tool(&self, tool_angle: f64, direction: &Vector3<f64>) -> Vector3<f64> {
        turned_back(tool_angle, &self.crossed(direction))
    }

    /// The tool's axis k1 in that room.
    pub fn tool_axis(&self) -> Vector3<f64> {
        let (sin, cos) = self.crossed_axes_angle.sin_cos();
        Vector3::new(-sin, 0.0, cos)
    }

    /// Velocity of the tool's material against the workpiece's at a point of that room, mm per radian of the tool.
    pub fn velocity(&self, q: &Vector3<f64>) -> Vector3<f64> {
        self.tool_axis().cross(&(q + Vector3::y() * self.centre_distance))
            - Vector3::z().cross(q) * self.ratio
    }

    /// Ry(gamma) v.
    fn crossed(&self, v: &Vector3<f64>) -> Vector3<f64> {
        let (sin, cos) = self.crossed_axes_angle.sin_cos();
        Vector3::new(cos * v.x + sin * v.z, v.y, cos * v.z - sin * v.x)
    }
}

/// Rz(-angle) v.
fn turned_back(angle: f64, v: &Vector3<f64>) -> Vector3<f64> {
    let (sin, cos) = angle.sin_cos();
    Vector3::new(cos * v.x + sin * v.y, cos * v.y - sin * v.x, v.z)
}
