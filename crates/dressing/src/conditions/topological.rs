//! Topological dressing: the correction DK(v) along the worm for a wanted modification f*(w, b)
//! (`docs/mathematics/dressing.md#conditions`).

use crate::{
    Condition, ConditionSolver, ConditionsAlong, DressedProfile, DresserTool, DressingError, FlankDresser,
    PathReason, three_points_with_map,
};
use foundation::geometry::Flank;
use foundation::kinematics::DressingCorrection;
use foundation::numerics::Chebyshev;

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

/// Rounds of the fixed point on the targets, and how far the contact may still move in the last but one, mm. Targets that
/// change by 1 um a mm are then met to 1e-6 um.
const ROUNDS: usize = 40;
const ROUND_TOLERANCE: f64 = 1e-9;
/// A fixed point that still moves by more than this is none, mm: rounding stops others somewhat above the tolerance.
const UNSETTLED: f64 = 1e-6;

/// The three lengths of roll of the pitch points: both ends and the middle of the used range.
pub fn pitch_rolls(tool: &DresserTool, flank: Flank) -> [f64; 3] {
    let range = tool.flanks[flank].range;
    [range.w_nf, range.middle(), range.w_na]
}

/// Solves four conditions at one worm position v, from a correction nearby. Their targets are taken where the dresser touches,
/// by a fixed point: the contact moves little when the targets do.
///
/// # Errors
/// Those of [`ConditionSolver::solve`], with v filled in; [`DressingError::NoZero`] where the fixed point does not settle because
/// the targets change along the worm faster than the contact line follows.
pub fn solve_conditions_at(
    solver: &ConditionSolver<'_>,
    v: f64,
    start: &DressingCorrection,
    conditions: &dyn ConditionsAlong,
) -> Result<DressingCorrection, DressingError> {
    let tool = solver.tool();
    // A first guess of the places tells the lengths of roll; the places on those follow from the start.
    let mut rows = conditions.at(v, &[somewhere(&tool.flanks.left, v); 4]);
    let guessed = rows.map(|row| row.flank().map_or(0.0, |flank| somewhere(&tool.flanks[flank], v)));
    rows = conditions.at(v, &guessed);
    if let Some(dk) = solver.solve_following(conditions, v, &rows, start) {
        return Ok(dk);
    }
    let at = |b: &[f64]| conditions.at(v, &std::array::from_fn(|i| b[i])).to_vec();
    settle(tool, v, start, rows.to_vec(), &at, |rows, dk| solver.solve(rows, dk))
}

/// Solves rows whose targets are taken where the dresser touches, by a fixed point from `rows`: `at` gives the rows for the places of the
/// pitch points, `solve` their solution near a correction.
///
/// # Errors
/// Those of `solve`, with v filled in; [`DressingError::NoZero`] where the places do not settle.
pub(super) fn settle(
    tool: &DresserTool,
    v: f64,
    start: &DressingCorrection,
    mut rows: Vec<Condition>,
    at: &dyn Fn(&[f64]) -> Vec<Condition>,
    mut solve: impl FnMut(&[Condition], &DressingCorrection) -> Result<DressingCorrection, DressingError>,
) -> Result<DressingCorrection, DressingError> {
    let mut dk = *start;
    let mut b = places(tool, &rows, &dk, v)?;
    let mut moved = f64::INFINITY;
    for _ in 0..ROUNDS {
        rows = at(&b);
        dk = solve(&rows, &dk).map_err(|error| error.at_position(v))?;
        let next = places(tool, &rows, &dk, v)?;
        let step = next.iter().zip(&b).map(|(next, b)| (next - b).abs()).fold(0.0, f64::max);
        b = next;
        if step < ROUND_TOLERANCE || (step < UNSETTLED && step >= moved) {
            return Ok(dk);
        }
        moved = step;
    }
    if moved < UNSETTLED {
        return Ok(dk);
    }
    let flank = rows.iter().find_map(Condition::flank).unwrap_or(Flank::Left);
    Err(DressingError::NoZero { flank, v, fraction: 0.0, reason: PathReason::GivenUp })
}

/// Worm z of the places where the dresser touches at the pitch points; 0 for the other rows.
pub(super) fn places(
    tool: &DresserTool,
    rows: &[Condition],
    dk: &DressingCorrection,
    v: f64,
) -> Result<Vec<f64>, DressingError> {
    let place = |row: &Condition| match *row {
        Condition::Point { flank, w, .. } => Ok(DressedProfile::new(tool, flank, *dk).at_roll(w)?.b - v),
        _ => Ok(0.0),
    };
    rows.iter().map(place).collect()
}

/// Worm z at which a flank is dressed at the position v without corrections, in the middle of the profile: a first guess of the places.
pub(super) fn somewhere(dresser: &FlankDresser, v: f64) -> f64 {
    dresser.line.value(dresser.designed.middle()) - v
}

/// DK(v) as Chebyshev series over the plan's interval; nodes are solved outwards from the middle, each from its neighbours.
///
/// # Errors
/// Those of [`solve_conditions_at`] at the first node that fails; [`DressingError::InvalidNumber`] for a plan without nodes or
/// length.
pub fn solve_conditions_along(
    solver: &ConditionSolver<'_>,
    plan: &NodePlan,
    conditions: &dyn ConditionsAlong,
) -> Result<([Chebyshev; 4], Vec<NodeSolution>), DressingError> {
    follow_nodes(plan, |v, start| solve_conditions_at(solver, v, start, conditions))
}

/// The 3-point rows with the radius map: f(w_i) = wanted(b_0, b_1, b_2)_i, w_i = [`pitch_rolls`].
struct ThreePoints<'a> {
    dresser: &'a FlankDresser,
    wanted: &'a dyn Fn([f64; 3]) -> [f64; 3],
}

impl ConditionsAlong for ThreePoints<'_> {
    fn at(&self, _: f64, &[b_0, b_1, b_2, _]: &[f64; 4]) -> [Condition; 4] {
        three_points_with_map(self.dresser, (self.wanted)([b_0, b_1, b_2]))
    }
}

/// DK(v) of the 3-point rows with the radius map as Chebyshev series over the plan's interval.
///
/// # Errors
/// Those of [`solve_conditions_along`].
pub fn solve_dressing_motion(
    tool: &DresserTool,
    flank: Flank,
    reference_radius: f64,
    plan: &NodePlan,
    wanted: &dyn Fn([f64; 3]) -> [f64; 3],
) -> Result<([Chebyshev; 4], Vec<NodeSolution>), DressingError> {
    let rows = ThreePoints { dresser: &tool.flanks[flank], wanted };
    solve_conditions_along(&ConditionSolver::new(tool, reference_radius), plan, &rows)
}

/// Nodes whose polynomial tells where the next one is sought.
const FOLLOWED: usize = 3;

/// The correction at v on the polynomial through known ones.
fn expected(known: &[(f64, DressingCorrection)], v: f64) -> DressingCorrection {
    let mut sum = [0.0; 4];
    for (i, (at, dk)) in known.iter().enumerate() {
        let others = known.iter().enumerate().filter(|(j, _)| *j != i);
        let weight: f64 = others.map(|(_, (other, _))| (v - other) / (at - other)).product();
        for j in 0..4 {
            sum[j] += weight * dk[j];
        }
    }
    sum
}

/// DK(v) through the nodes of a plan, outwards from the middle, each sought where its neighbours let expect it.
pub(crate) fn follow_nodes(
    plan: &NodePlan,
    mut solve: impl FnMut(f64, &DressingCorrection) -> Result<DressingCorrection, DressingError>,
) -> Result<([Chebyshev; 4], Vec<NodeSolution>), DressingError> {
    let (from, to) = plan.interval;
    if !(from.is_finite() && to.is_finite() && from < to) {
        let (field, allowed) = ("worm position from", "finite and below the end of the dressed length");
        return Err(DressingError::InvalidNumber { field, value: from, allowed });
    }
    if plan.nodes == 0 {
        let (field, allowed) = ("nodes of the dressing motion", "1 or more");
        return Err(DressingError::InvalidNumber { field, value: 0.0, allowed });
    }
    let nodes = Chebyshev::nodes(from, to, plan.nodes);
    let middle = plan.nodes / 2;
    let mut solved: Vec<Option<DressingCorrection>> = vec![None; plan.nodes];
    // Each node with its neighbours that are solved before it, the nearest first.
    let mut order: Vec<(usize, Vec<usize>)> = vec![(middle, Vec::new())];
    order.extend((middle + 1..plan.nodes).map(|k| (k, (middle..k).rev().take(FOLLOWED).collect())));
    order.extend((0..middle).rev().map(|k| (k, (k + 1..plan.nodes).take(FOLLOWED).collect())));
    for (k, neighbours) in order {
        let known: Vec<(f64, DressingCorrection)> =
            neighbours.iter().filter_map(|&n| Some((nodes[n], solved[n]?))).collect();
        let nearest = known.first().map_or([0.0; 4], |known| known.1);
        let found = match known.len() {
            0 | 1 => solve(nodes[k], &nearest),
            _ => solve(nodes[k], &expected(&known, nodes[k])).or_else(|_| solve(nodes[k], &nearest)),
        };
        solved[k] = Some(found?);
    }
    let values: Vec<DressingCorrection> = solved.into_iter().flatten().collect();
    let series = std::array::from_fn(|j| {
        Chebyshev::interpolate(from, to, &values.iter().map(|dk| dk[j]).collect::<Vec<_>>())
    });
    let solutions = nodes.iter().zip(&values).map(|(&v, &dk)| NodeSolution { v, dk }).collect();
    Ok((series, solutions))
}
