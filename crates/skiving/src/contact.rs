//! Where a flank on its way touches whatever generates it, in closed form (`docs/mathematics/skiving.md#tool-and-workpiece`): for every
//! turn of the flank one height at which its normal is perpendicular to the velocity.

use super::ProfilePlace;
use foundation::kinematics::SkivingMotion;
use nalgebra::Vector3;

/// A point of the flank at the moment in which it is conjugate to a tool. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conjugate {
    /// q: the point in the room beside the workpiece; its height is free of the feed.
    pub point: Vector3<f64>,
    /// The workpiece's normal there, out of its material.
    pub normal: Vector3<f64>,
    /// phi_1.
    pub tool_angle: f64,
}

/// The conjugate point of a place of the profile that has been turned by `turn` (chi, rad) in all, turn of workpiece and helix together.
/// There is a pole where the normal is perpendicular to y: the height is not finite then.
#[inline]
pub fn conjugate(motion: &SkivingMotion, place: &ProfilePlace, turn: f64) -> Conjugate {
    let (sin, cos) = turn.sin_cos();
    let turned = |v: &Vector3<f64>| Vector3::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y, v.z);
    let (at, normal) = (turned(&place.point), turned(&place.normal));
    let (sin_axes, cos_axes) = motion.crossed_axes_angle.sin_cos();
    let lever = normal.y * at.x - normal.x * at.y;
    let height = (motion.ratio * lever
        + (normal.x * cos_axes + normal.z * sin_axes) * (at.y + motion.centre_distance)
        - normal.y * cos_axes * at.x)
        / (normal.y * sin_axes);
    Conjugate {
        point: Vector3::new(at.x, at.y, height),
        normal,
        tool_angle: motion.tool_angle_at(turn - motion.twist * (height - place.point.z)),
    }
}

/// The turns (chi, rad) of a profile at which it is conjugate to a tool on a parallel axis, whatever its height: its normal passes through
/// the point where both roll on each other. None where it does not reach that point.
pub fn parallel_turns(motion: &SkivingMotion, place: &ProfilePlace) -> Option<[f64; 2]> {
    let (at, normal) = (&place.point, &place.normal);
    let lever = normal.y * at.x - normal.x * at.y;
    let cosine = lever * (1.0 - motion.ratio) / (motion.centre_distance * normal.xy().norm());
    let middle = -normal.y.atan2(normal.x);
    // Written so that NaN has no turn.
    (cosine.abs() <= 1.0).then(|| [middle + cosine.acos(), middle - cosine.acos()])
}

/// The same point on a parallel axis: the turn follows from the rolling, the height is free, because tool and workpiece slide along their
/// helices in one another.
pub fn parallel_conjugate(motion: &SkivingMotion, place: &ProfilePlace, turn: f64, height: f64) -> Conjugate {
    let (sin, cos) = turn.sin_cos();
    let turned = |v: &Vector3<f64>| Vector3::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y, v.z);
    let at = turned(&place.point);
    Conjugate {
        point: Vector3::new(at.x, at.y, height),
        normal: turned(&place.normal),
        tool_angle: motion.tool_angle_at(turn - motion.twist * (height - place.point.z)),
    }
}
