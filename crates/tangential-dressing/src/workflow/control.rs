//! A run of tangential dressing as the control sees it: each pass with its own motion and stroke. Variables of dressing and grinding that
//! cancel each other on the flank may each be large, so the worm of the rays in time is the one that the dresser left.

use crate::workflow::{TangentialPass, TangentialPrepared, TangentialRun, passes_of_runs};
use foundation::geometry::Sides;
use foundation::kinematics::GeneratingMotion;
use generating_grinding::workflow::control::pass::{ControlledPass, ControlledRun, GoesOn, GroundFlank};
use generating_grinding::workflow::control::result::ControlResult;
use generating_grinding::workflow::referee::stock;
use run::RunFailure;
use verdict::Remark;

/// What the control leaves while the gear is ground, with the alarms of its interpolator; `None` for a job without one.
///
/// # Errors
/// [`RunFailure`] on a key of `[control]`.
pub fn control_of_tangential(
    ready: &TangentialPrepared,
    runs: &Sides<Option<TangentialRun>>,
) -> Result<Option<(ControlResult, Vec<Remark>)>, RunFailure> {
    let Some(control) = &ready.control else { return Ok(None) };
    let passes: Vec<(TangentialPass<'_>, GeneratingMotion)> = passes_of_runs(runs)
        .into_iter()
        .filter_map(|pass| pass.motion(ready).map(|motion| (pass, motion)))
        .collect();
    let tolerance = ready.tolerance();
    let run = ControlledRun {
        control,
        pair: &ready.model.pair,
        worm_speed: ready.technology.finishing().worm_speed,
        feed_per_revolution: ready.technology.finishing().feed_per_revolution,
        tolerance: &|_, _| tolerance,
        passes: passes.iter().map(|(pass, motion)| controlled(ready, pass, motion)).collect(),
    };
    run.through_control().map(Some)
}

fn controlled<'a>(
    ready: &TangentialPrepared,
    pass: &TangentialPass<'a>,
    motion: &'a GeneratingMotion,
) -> ControlledPass<'a> {
    let ground = pass.runs.iter().map(|&(flank, run)| GroundFlank {
        flank,
        deviation: run.simulated.minus(&run.target),
        simulated: &run.simulated,
        worm: GoesOn(&run.refereed.worm.surface),
        stock: stock(ready.model.pair.worm.flank(flank), run.target.largest()),
    });
    ControlledPass { motion, feed_range: pass.feed(), flanks: ground.collect() }
}
