//! Both flanks at once: one correction DK(v) for both, two pitch points on each (`docs/mathematics/dressing.md#conditions`). Knows no
//! wanted modification and no least squares.

use crate::{
    Condition, ConditionSolver, ConditionsAlong, DresserTool, DressingError, NodePlan, NodeSolution,
    solve_conditions_along,
};
use foundation::geometry::{Flank, Sides};
use foundation::numerics::Chebyshev;
use std::f64::consts::FRAC_1_SQRT_2;

/// Lengths of roll of the pitch points on each flank: where a parabola that deviates alike at the ends and in the middle of the
/// used range is zero. What the two rows leave is a parabola nearly, and so it is shared out.
pub fn two_flank_rolls(tool: &DresserTool) -> Sides<[f64; 2]> {
    Sides::from_fn(|flank| {
        let range = tool.flanks[flank].range;
        let reach = 0.5 * FRAC_1_SQRT_2 * range.length();
        [range.middle() - reach, range.middle() + reach]
    })
}

/// The wanted modification of a flank at the pitch points with worm positions b, mm.
pub type TwoFlankWish<'a> = &'a dyn Fn(Flank, [f64; 2]) -> [f64; 2];

/// The rows f(w_i) = wanted(flank, [b_0, b_1])_i on both flanks, w_i = [`two_flank_rolls`].
struct TwoFlankRows<'a> {
    rolls: Sides<[f64; 2]>,
    wanted: TwoFlankWish<'a>,
}

impl ConditionsAlong for TwoFlankRows<'_> {
    fn at(&self, _: f64, b: &[f64; 4]) -> [Condition; 4] {
        let left = (self.wanted)(Flank::Left, [b[0], b[1]]);
        let right = (self.wanted)(Flank::Right, [b[2], b[3]]);
        let point = |flank: Flank, i: usize, f: [f64; 2]| Condition::Point {
            flank,
            w: self.rolls[flank][i],
            f: f[i],
        };
        [
            point(Flank::Left, 0, left),
            point(Flank::Left, 1, left),
            point(Flank::Right, 0, right),
            point(Flank::Right, 1, right),
        ]
    }
}

/// DK(v) of both flanks as Chebyshev series over the plan's interval, nodes solved outwards from the middle.
///
/// # Errors
/// [`crate::dressing::DressingError::TwoFlanksOfCone`]; those of [`solve_conditions_along`].
pub fn solve_two_flank_motion(
    tool: &DresserTool,
    reference_radius: f64,
    plan: &NodePlan,
    wanted: TwoFlankWish<'_>,
) -> Result<([Chebyshev; 4], Vec<NodeSolution>), DressingError> {
    let rows = TwoFlankRows { rolls: two_flank_rolls(tool), wanted };
    solve_conditions_along(&ConditionSolver::new(tool, reference_radius), plan, &rows)
}
