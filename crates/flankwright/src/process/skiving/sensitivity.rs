//! What a change of the machine's setting does to the flank at a contact (spec 60 section 9).

use super::ContactPlace;
use crate::kinematics::SkivingMotion;
use nalgebra::Vector3;

/// Change of f_2 per unit of [d, gamma, z_V1, phi_1]: mm/mm and mm/rad; phi_1 turns the tool against its coupling.
pub fn setting_sensitivity(motion: &SkivingMotion, place: &ContactPlace) -> [f64; 4] {
    let (n, q) = (&place.work_normal, &place.engagement);
    let axis = motion.tool_axis();
    let from_tool = q + Vector3::y() * motion.centre_distance;
    [-n.y, -n.dot(&Vector3::y().cross(q)), n.dot(&axis), n.dot(&axis.cross(&from_tool))]
}
