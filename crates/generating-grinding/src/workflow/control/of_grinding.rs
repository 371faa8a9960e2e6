//! A run of generating grinding as the control sees it: one pass for all flanks, ground by the worm that the dresser left.

use super::pass::{ControlledPass, ControlledRun, GoesOn, GroundFlank};
use super::result::ControlResult;
use crate::workflow::execution::Execution;
use crate::workflow::prepare::Prepared;
use crate::workflow::referee::{Verdict, stock};
use foundation::geometry::{Flank, Sides};
use run::RunFailure;
use verdict::Remark;

/// What the job's control leaves, with the alarms of its interpolator; `None` for a job without one.
///
/// # Errors
/// [`RunFailure`] on a key of `[control]`.
pub fn control_of_grinding(
    prepared: &Prepared,
    execution: &Execution,
    verdicts: &Sides<Option<Verdict>>,
) -> Result<Option<(ControlResult, Vec<Remark>)>, RunFailure> {
    let Some(control) = &prepared.control else { return Ok(None) };
    let technology = &prepared.technology;
    let ground = |flank: Flank| {
        let (executed, verdict) = (execution.flanks[flank].as_ref()?, verdicts[flank].as_ref()?);
        Some(GroundFlank {
            flank,
            deviation: verdict.simulated.minus(&executed.target),
            simulated: &verdict.simulated,
            worm: GoesOn(verdict.worm(&executed.tool)?),
            stock: stock(prepared.setup.pair.worm.flank(flank), executed.target.largest()),
        })
    };
    let pass = ControlledPass {
        motion: &execution.motion,
        feed_range: execution.feed_range,
        flanks: Flank::BOTH.into_iter().filter_map(ground).collect(),
    };
    let run = ControlledRun {
        control,
        pair: &prepared.setup.pair,
        worm_speed: technology.finishing().worm_speed,
        feed_per_revolution: technology.finishing().feed_per_revolution,
        tolerance: &|w, z| prepared.tolerance.value(w, z),
        passes: vec![pass],
    };
    run.through_control().map(Some)
}
