//! The corrections for a profile crowning of the gear.

use super::UM;
use super::bodies::Bodies;
use dressing::{Condition, ConditionSolver, DressingError};
use foundation::geometry::Flank;
use foundation::kinematics::DressingCorrection;

pub(super) fn three_points(bodies: &Bodies, middle: f64) -> [Condition; 4] {
    let range = bodies.range;
    let point = |w, f| Condition::Point { flank: Flank::Left, w, f };
    let map = Condition::Map { flank: Flank::Left, t: range.w_na, w: range.w_na };
    [point(range.w_nf, 0.0), point(range.middle(), middle), point(range.w_na, 0.0), map]
}

/// f in the middle of the worm's profile for a profile crowning of the gear, um.
pub(super) fn middle_of(bodies: &Bodies, amount: f64) -> f64 {
    -amount * UM * bodies.gear.flank(Flank::Left).base_helix_angle.cos()
}

/// The corrections for a profile crowning of the gear, um, by three points and the radius map.
pub(super) fn crowned(bodies: &Bodies, amount: f64) -> Result<DressingCorrection, DressingError> {
    let solver = ConditionSolver::new(&bodies.tool, bodies.reference_radius);
    solver.solve(&three_points(bodies, middle_of(bodies, amount)), &[0.0; 4])
}
