//! Topological dressing: the correction DK(v) along the worm for a wanted modification f*(w, b) (spec 30 section 10).

use super::{Condition, ConditionSolver, DressedProfile, DresserTool, DressingError};
use crate::geometry::Flank;
use crate::kinematics::DressingCorrection;
use crate::numerics::Chebyshev;

/// The solved rows at one worm position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodeSolution {
    /// Worm position v_zS, mm.
    pub v: f64,
    /// DK there.
    pub dk: DressingCorrection,
}

/// How DK(v) is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodePlan {
    /// Interval of v, mm.
    pub interval: (f64, f64),
    /// Number of Chebyshev nodes.
    pub nodes: usize,
}

/// Rounds of the fixed point on the targets and their tolerance in b, mm.
const ROUNDS: usize = 12;
const ROUND_TOLERANCE: f64 = 1e-9;

/// The three lengths of roll of the pitch points: both ends and the middle of the used range.
pub fn pitch_rolls(tool: &DresserTool, flank: Flank) -> [f64; 3] {
    let range = tool.flanks[flank].range;
    [range.w_nf, range.middle(), range.w_na]
}

/// Solves the 3-point rows with the radius map at one worm position v: f(w_i) = wanted(b_0 - v, b_1 - v, b_2 - v)_i, w_i
/// = [`pitch_rolls`].
///
/// # Errors
/// Those of [`ConditionSolver::solve`], with v filled in.
pub fn solve_node(
    tool: &DresserTool,
    flank: Flank,
    reference_radius: f64,
    v: f64,
    start: &DressingCorrection,
    wanted: &dyn Fn([f64; 3]) -> [f64; 3],
) -> Result<DressingCorrection, DressingError> {
    let (range, designed) = (tool.flanks[flank].range, tool.flanks[flank].designed);
    let rolls = pitch_rolls(tool, flank);
    let solver = ConditionSolver::new(tool, reference_radius);
    let mut dk = *start;
    let profile = DressedProfile::new(tool, flank, dk);
    let mut b = [profile.at_roll(rolls[0])?.b, profile.at_roll(rolls[1])?.b, profile.at_roll(rolls[2])?.b];
    for _ in 0..ROUNDS {
        let f = wanted(b.map(|b| b - v));
        let point = |i: usize| Condition::Point { flank, w: rolls[i], f: f[i] };
        let rows = [point(0), point(1), point(2), Condition::Map { flank, t: designed.w_na, w: range.w_na }];
        dk = solver.solve(&rows, &dk).map_err(|error| error.at_position(v))?;
        let profile = DressedProfile::new(tool, flank, dk);
        let mut moved: f64 = 0.0;
        for i in 0..3 {
            let next = profile.at_roll(rolls[i])?.b;
            moved = moved.max((next - b[i]).abs());
            b[i] = next;
        }
        if moved < ROUND_TOLERANCE {
            break;
        }
    }
    Ok(dk)
}

/// DK(v) as Chebyshev series over the plan's interval; nodes are solved outwards from the middle, each from its neighbour.
///
/// # Errors
/// Those of [`solve_node`] at the first node that fails.
pub fn solve_dressing_motion(
    tool: &DresserTool,
    flank: Flank,
    reference_radius: f64,
    plan: &NodePlan,
    wanted: &dyn Fn([f64; 3]) -> [f64; 3],
) -> Result<([Chebyshev; 4], Vec<NodeSolution>), DressingError> {
    follow_nodes(plan, |v, start| solve_node(tool, flank, reference_radius, v, start, wanted))
}

/// DK(v) through the nodes of a plan, each solved from its neighbour, outwards from the middle.
pub(super) fn follow_nodes(
    plan: &NodePlan,
    mut solve: impl FnMut(f64, &DressingCorrection) -> Result<DressingCorrection, DressingError>,
) -> Result<([Chebyshev; 4], Vec<NodeSolution>), DressingError> {
    let (from, to) = plan.interval;
    let nodes = Chebyshev::nodes(from, to, plan.nodes);
    let middle = plan.nodes / 2;
    let mut solved: Vec<Option<DressingCorrection>> = vec![None; plan.nodes];
    let mut order: Vec<(usize, Option<usize>)> = vec![(middle, None)];
    order.extend((middle + 1..plan.nodes).map(|k| (k, Some(k - 1))));
    order.extend((0..middle).rev().map(|k| (k, Some(k + 1))));
    for (k, neighbour) in order {
        let start = neighbour.and_then(|n| solved[n]).unwrap_or([0.0; 4]);
        solved[k] = Some(solve(nodes[k], &start)?);
    }
    let values: Vec<DressingCorrection> = solved.into_iter().flatten().collect();
    let series = std::array::from_fn(|j| {
        Chebyshev::interpolate(from, to, &values.iter().map(|dk| dk[j]).collect::<Vec<_>>())
    });
    let solutions = nodes.iter().zip(&values).map(|(&v, &dk)| NodeSolution { v, dk }).collect();
    Ok((series, solutions))
}
