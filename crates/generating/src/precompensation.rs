//! The correction of a command by the errors of the exact flank, round by round
//! (`docs/mathematics/planning.md#from-the-ratio-to-the-flank`).

use super::class_fit::ClassFit;
use super::planning_grid::GroundError;
use super::{
    Command, FeedLaw, FieldSpline, FlankLines, FlankTarget, GeneratingError, GrindingSetup, IdealPlan,
    PlanningGrid, ProfilePolicy, Tool,
};
use foundation::geometry::{Flank, Sides};
use std::sync::Arc;

/// Rounds of precompensation with the ideal worm (`docs/mathematics/planning.md#from-the-ratio-to-the-flank`).
pub(super) const ROUNDS: usize = 4;
/// Rounds where the correction is free: reliefs and steep lines shift the contact further, each round gains less.
pub(super) const FREE_ROUNDS: usize = 12;

/// A free correction ends below this error, mm: a nanometre is far below what anything can hold.
const FINE: f64 = 1e-6;

/// Which terms of the error go back into the command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Correction {
    /// Terms pure in u or in y.
    Pure,
    /// The class of polynomials.
    Mixed,
    /// The class and a smooth function for what is left.
    Free,
}

/// Cells over profile and face width of a correction, the finest that the feet determine is taken.
const CORRECTION_CELLS: [[usize; 2]; 3] = [[6, 16], [4, 10], [2, 5]];

/// The command corrected by the normal errors `e` (target - ground, mm): what the class of polynomials takes, and the rest as a
/// smooth function. Errors are put where the tool touches (`feet`): there the flank follows the tool one to one, whatever the
/// contact has moved by (envelope theorem; dm/df_n1 of `docs/mathematics/generating-contact.md#exact-contact`).
fn freely_corrected(lines: &FlankLines, command: &Command, e: &[f64], feet: &[(f64, f64)]) -> Command {
    let centred: Vec<(f64, f64)> = feet.iter().map(|&(w, z)| (w - lines.w_m, z - lines.z_m)).collect();
    let transverse: Vec<f64> = e.iter().map(|e| e / lines.cos_b2).collect();
    let fitted = ClassFit::new(&centred).fit(&transverse);
    let points: Vec<[f64; 3]> = feet
        .iter()
        .zip(&centred)
        .zip(&transverse)
        .map(|((&(w, z), &(u, y)), f)| [w, z, f - fitted.value(u, y)])
        .collect();
    let mut next = command.clone();
    next.polynomial = command.polynomial.add(&fitted);
    let spline = CORRECTION_CELLS.into_iter().find_map(|cells| FieldSpline::near(&points, cells).ok());
    next.corrections.extend(spline.map(Arc::new));
    next
}

/// Which terms of an error may go back into the command of a plan.
fn allowed_correction(plan: &IdealPlan, setup: &GrindingSetup) -> Correction {
    if plan.feed.is_radial() || matches!(setup.tool, Tool::Given(_)) {
        Correction::Pure
    } else if plan.worms.iter().any(|(_, w)| w.as_ref().is_some_and(|w| !w.carried.is_empty())) {
        Correction::Free
    } else {
        Correction::Mixed
    }
}

/// The commands of a plan corrected by the errors it leaves.
pub(super) fn corrected(
    setup: &GrindingSetup,
    grid: &PlanningGrid,
    plan: &IdealPlan,
    error: &GroundError,
) -> Sides<Option<Command>> {
    let terms = allowed_correction(plan, setup);
    Sides::from_fn(|flank| {
        let (Some(command), Some(e)) = (&plan.commanded[flank], &error.error[flank]) else {
            return plan.commanded[flank].clone();
        };
        Some(match (&error.feet[flank], terms) {
            (Some(feet), Correction::Free) => freely_corrected(&setup.lines[flank], command, e, feet),
            _ => {
                let mixed = terms != Correction::Pure;
                let fitted = grid.correction(flank, e, setup.lines[flank].cos_b2, mixed);
                Command { polynomial: command.polynomial.add(&fitted), ..command.clone() }
            }
        })
    })
}

/// Precompensation: corrects the command by the fitted error of the exact flank, `rounds` times or until a round does not
/// reduce the largest error. Returns the best plan, its error and the largest error per flank by round, mm.
///
/// # Errors
/// Those of [`IdealPlan::new`] and [`IdealPlan::error`] in the first round; a later round that fails ends the loop.
pub fn precompensate(
    setup: &GrindingSetup,
    targets: &Sides<Option<FlankTarget>>,
    grid: &PlanningGrid,
    feed: &FeedLaw,
    policy: ProfilePolicy,
    rounds: usize,
) -> Result<(IdealPlan, GroundError, Sides<Vec<f64>>), GeneratingError> {
    let command = targets.map(|_, t| t.as_ref().map(Command::of));
    let mut best = IdealPlan::new(setup, targets, command, feed, policy)?;
    let mut error = best.error(setup, targets, grid)?;
    let mut record: Sides<Vec<f64>> = Sides::from_fn(|f| error.largest(f).into_iter().collect());
    for _ in 0..rounds {
        if allowed_correction(&best, setup) == Correction::Free && error.max() < FINE {
            break;
        }
        let command = corrected(setup, grid, &best, &error);
        let Ok(next) = best.commanding(setup, targets, command, policy) else { break };
        let Ok(next_error) = next.error(setup, targets, grid) else { break };
        for flank in Flank::BOTH {
            record[flank].extend(next_error.largest(flank));
        }
        if next_error.max() >= error.max() {
            break;
        }
        (best, error) = (next, next_error);
    }
    Ok((best, error, record))
}
