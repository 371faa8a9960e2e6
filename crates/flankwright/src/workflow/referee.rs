//! The referee's run: rays of the worm against the dresser, then rays of the workpiece against the worm that those rays
//! left (spec 28 section 5). Nothing of the process's own formulas enters here, only bodies and motions.

use super::execution::Execution;
use crate::geometry::{Flank, Sides};
use crate::metrology::Topography;
use crate::numerics::Progress;
use crate::process::generating::GrindingSetup;
use crate::removal::{
    Dressing, Grinding, GrindingMode, RayGrid, RemovalError, Statistics, WormArea, dress, grind,
};

/// What one stage did and how exact it is.
#[derive(Clone, Debug, PartialEq)]
pub struct StageReport {
    /// Counts.
    pub statistics: Statistics,
    /// Bound of its own error, um.
    pub error_um: f64,
}

/// The referee's verdict on one flank.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// The flank that the rays left, normal, mm.
    pub simulated: Topography,
    /// Dresser against worm.
    pub dressing: StageReport,
    /// Worm against workpiece; its error contains that of the worm surface.
    pub grinding: StageReport,
}

/// Spacing of the worm's rays: over the profile and along the worm, mm (spec 28 section 5).
const WORM_SPACING: [f64; 2] = [0.5, 1.0];
/// Part of the dressing margin that the rays use along the worm, mm; the rest covers the slope of the contact line.
const WORM_MARGIN: f64 = 2.0;
/// Continuation of the used profile at each end, as a share of it.
const PROFILE_MARGIN: f64 = 0.08;
/// Least stock that counts as this flank's, mm.
const STOCK: f64 = 0.2;

/// Runs both stages for every flank that is ground.
///
/// # Errors
/// Those of the stages, e.g. a ray that nothing reaches.
pub fn run(
    setup: &GrindingSetup,
    execution: &Execution,
    mode: GrindingMode,
    progress: &dyn Progress,
) -> Result<Sides<Option<Verdict>>, RemovalError> {
    Sides::try_from_fn(|flank| run_flank(setup, execution, flank, mode, progress))
}

fn run_flank(
    setup: &GrindingSetup,
    execution: &Execution,
    flank: Flank,
    mode: GrindingMode,
    progress: &dyn Progress,
) -> Result<Option<Verdict>, RemovalError> {
    let Some(executed) = &execution.flanks[flank] else { return Ok(None) };
    let (worm, work) = (setup.pair.worm.flank(flank), setup.pair.work.flank(flank));
    let dresser = &execution.tool.flanks[flank];
    let motion = executed.dressing(&execution.tool);
    let (from, to) = executed.corrections[0].interval();
    let margin = PROFILE_MARGIN * dresser.range.length();
    let w = [dresser.range.w_nf - margin, dresser.range.w_na + margin];
    let z = [execution.occupation[0] - WORM_MARGIN, execution.occupation[1] + WORM_MARGIN];
    let stock = STOCK.max(3.0 * executed.target.largest());
    let worm_grid = RayGrid::spaced(w, WORM_SPACING[0], z, WORM_SPACING[1])?;
    let dressed = dress(
        &Dressing { worm, dresser: &dresser.profile, motion: &motion, shift_range: [from, to], stock },
        &worm_grid,
        progress,
    )?;
    let surface = dressed.surface()?;
    let grid = RayGrid::new(executed.target.w.clone(), executed.target.z.clone())?;
    let ground = grind(
        &Grinding {
            worm,
            area: WormArea { w, z },
            modification: &surface,
            work,
            motion: &execution.motion,
            feed_range: execution.feed_range,
            stock,
            mode,
        },
        &grid,
        progress,
    )?;
    let simulated = Topography { f: ground.lengths()?, ..executed.target.clone() };
    Ok(Some(Verdict {
        simulated,
        dressing: StageReport { statistics: dressed.statistics, error_um: surface.error_um },
        grinding: StageReport { statistics: ground.statistics, error_um: ground.error_um },
    }))
}
