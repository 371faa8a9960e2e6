//! The dressing motion of rows along the worm: four are met exactly; of more, those without a weight are, and the others as nearly as their
//! weights ask (`docs/mathematics/dressing.md#conditions`).

use super::topological::{places, settle, somewhere};
use crate::{
    Compensation, Condition, ConditionSolver, ConditionsAlong, DresserTool, DressingError, NodePlan,
    NodeSolution, RowsAlong, SoftCondition, solve_conditions_along, solve_conditions_at,
};
use foundation::kinematics::DressingCorrection;
use foundation::numerics::Chebyshev;

/// What a motion leaves of one row over the dressed length, mm or rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowMiss {
    /// Its largest residual without sign.
    pub largest: f64,
    /// Root of the mean square of its residuals.
    pub rms: f64,
}

/// Rows that are four and exact.
struct Four<'a>(&'a RowsAlong<'a>);

impl ConditionsAlong for Four<'_> {
    fn at(&self, v: f64, b: &[f64; 4]) -> [Condition; 4] {
        let rows = self.0.conditions(v, b);
        // A set without weights has four rows.
        std::array::from_fn(|i| rows.get(i).copied().unwrap_or(Condition::Fixed { j: i, x: 0.0 }))
    }
}

/// Solves rows at one worm position v, from a correction nearby.
///
/// # Errors
/// Those of [`solve_conditions_at`] for four exact rows, of [`Compensation::solve`] for others, with v filled in.
pub fn solve_rows_at(
    solver: &ConditionSolver<'_>,
    v: f64,
    start: &DressingCorrection,
    rows: &RowsAlong<'_>,
) -> Result<DressingCorrection, DressingError> {
    if !rows.rows.is_weighed() {
        return solve_conditions_at(solver, v, start, &Four(rows));
    }
    let weights = rows.weights();
    let tool = solver.tool();
    let compensate = |conditions: &[Condition], from: &DressingCorrection| {
        let (mut soft, mut hard) = (Vec::new(), Vec::new());
        for (condition, weight) in conditions.iter().zip(&weights) {
            match *weight {
                Some(weight) => soft.push(SoftCondition { condition: *condition, weight }),
                None => hard.push(*condition),
            }
        }
        Ok(Compensation::new(tool, solver.reference_radius(), soft, hard).solve(from)?.dk)
    };
    let first = first_rows(tool, v, rows);
    settle(tool, v, start, first, &|b| rows.conditions(v, b), compensate)
}

/// The rows where a flank is dressed without corrections: their lengths of roll are a first guess.
fn first_rows(tool: &DresserTool, v: f64, rows: &RowsAlong<'_>) -> Vec<Condition> {
    let anywhere = vec![somewhere(&tool.flanks.left, v); rows.rows.rows().len()];
    let guessed = rows.conditions(v, &anywhere);
    let at = |row: &Condition| row.flank().map_or(0.0, |flank| somewhere(&tool.flanks[flank], v));
    rows.conditions(v, &guessed.iter().map(at).collect::<Vec<_>>())
}

/// DK(v) of rows as Chebyshev series over the plan's interval.
///
/// # Errors
/// Those of [`solve_rows_at`] at the first node that fails; [`DressingError::InvalidNumber`] for a plan without nodes or length.
pub fn solve_rows_along(
    solver: &ConditionSolver<'_>,
    plan: &NodePlan,
    rows: &RowsAlong<'_>,
) -> Result<([Chebyshev; 4], Vec<NodeSolution>), DressingError> {
    if rows.rows.is_weighed() {
        return super::topological::follow_nodes(plan, |v, start| solve_rows_at(solver, v, start, rows));
    }
    solve_conditions_along(solver, plan, &Four(rows))
}

/// What the solved nodes leave of each row.
///
/// # Errors
/// Those of the forward calculation.
pub fn missed_rows(nodes: &[NodeSolution], rows: &RowsAlong<'_>) -> Result<Vec<RowMiss>, DressingError> {
    let tool = rows.tool;
    let mut misses = vec![RowMiss { largest: 0.0, rms: 0.0 }; rows.rows.rows().len()];
    for node in nodes {
        let mut conditions = first_rows(tool, node.v, rows);
        for _ in 0..PLACE_ROUNDS {
            let next = rows.conditions(node.v, &places(tool, &conditions, &node.dk, node.v)?);
            let settled = next == conditions;
            conditions = next;
            if settled {
                break;
            }
        }
        for (miss, condition) in misses.iter_mut().zip(&conditions) {
            let mut from_afar = f64::NAN;
            let (left, _) = condition.row(tool, &node.dk, &mut from_afar)?;
            miss.largest = miss.largest.max(left.abs());
            miss.rms += left * left;
        }
    }
    misses.iter_mut().for_each(|miss| miss.rms = (miss.rms / nodes.len().max(1) as f64).sqrt());
    Ok(misses)
}

/// Rounds in which the places of pitch points that move over the width settle.
const PLACE_ROUNDS: usize = 8;
