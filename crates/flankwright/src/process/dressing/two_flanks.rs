//! Both flanks at once: one correction DK(v) for both, two pitch points on each (spec 30 section 11). Knows no wanted
//! modification and no least squares.

use super::topological::follow_nodes;
use super::{Condition, ConditionSolver, DressedProfile, DresserTool, DressingError, NodePlan, NodeSolution};
use crate::geometry::{Flank, Sides};
use crate::kinematics::DressingCorrection;
use crate::numerics::Chebyshev;
use std::f64::consts::FRAC_1_SQRT_2;

/// Rounds of the fixed point on the targets and their tolerance in b, mm.
const ROUNDS: usize = 12;
const ROUND_TOLERANCE: f64 = 1e-9;

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

/// Solves the rows at worm position v: f(w_i) = wanted(flank, [b_0 - v, b_1 - v])_i on both flanks.
///
/// # Errors
/// [`DressingError::TwoFlanksOfCone`]; those of [`ConditionSolver::solve`], with v filled in.
pub fn solve_two_flank_node(
    tool: &DresserTool,
    reference_radius: f64,
    v: f64,
    start: &DressingCorrection,
    wanted: TwoFlankWish<'_>,
) -> Result<DressingCorrection, DressingError> {
    if tool.flanks.left.chain != tool.flanks.right.chain {
        return Err(DressingError::TwoFlanksOfCone);
    }
    let rolls = two_flank_rolls(tool);
    let solver = ConditionSolver::new(tool, reference_radius);
    let positions = |dk: &DressingCorrection| -> Result<Sides<[f64; 2]>, DressingError> {
        Sides::try_from_fn(|flank| {
            let profile = DressedProfile::new(tool, flank, *dk);
            let [w_0, w_1] = rolls[flank];
            Ok([profile.at_roll(w_0)?.b, profile.at_roll(w_1)?.b])
        })
    };
    let mut dk = *start;
    let mut b = positions(&dk)?;
    for _ in 0..ROUNDS {
        let mut rows = Vec::with_capacity(4);
        for flank in Flank::BOTH {
            let f = wanted(flank, b[flank].map(|b| b - v));
            rows.extend((0..2).map(|i| Condition::Point { flank, w: rolls[flank][i], f: f[i] }));
        }
        dk = solver.solve(&rows, &dk).map_err(|error| error.at_position(v))?;
        let next = positions(&dk)?;
        let moved =
            Flank::BOTH.iter().flat_map(|&flank| [0, 1].map(|i| (next[flank][i] - b[flank][i]).abs()));
        let moved = moved.fold(0.0, f64::max);
        b = next;
        if moved < ROUND_TOLERANCE {
            break;
        }
    }
    Ok(dk)
}

/// DK(v) of both flanks as Chebyshev series over the plan's interval, nodes solved outwards from the middle.
///
/// # Errors
/// Those of [`solve_two_flank_node`] at the first node that fails.
pub fn solve_two_flank_motion(
    tool: &DresserTool,
    reference_radius: f64,
    plan: &NodePlan,
    wanted: TwoFlankWish<'_>,
) -> Result<([Chebyshev; 4], Vec<NodeSolution>), DressingError> {
    follow_nodes(plan, |v, start| solve_two_flank_node(tool, reference_radius, v, start, wanted))
}
