//! The referee's run: rays of the worm against the dresser, then rays of the workpiece against the worm that those rays
//! left (spec 28 section 5). Nothing of the process's own formulas enters here, only bodies and motions.

use super::execution::Execution;
use crate::geometry::{Flank, Sides};
use crate::metrology::Topography;
use crate::numerics::{CubicSpline, Progress, Silent};
use crate::process::generating::{GrindingSetup, finished_area};
use crate::removal::{
    ActiveThreads, Dressing, Grinding, GrindingMode, RayGrid, RemovalError, Statistics, WormArea, dress,
    grind,
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
    /// Height of the true feed marks over the envelope on a sample of rays, mm, or why they could not be followed; `None`
    /// without a feed.
    pub feed_mark: Option<Result<f64, RemovalError>>,
}

/// Spacing of the worm's rays: over the profile and along the worm, mm (spec 28 section 5).
const WORM_SPACING: [f64; 2] = [0.5, 1.0];
/// Distance of the outermost worm rays from the ends of the dressed length, mm.
const WORM_MARGIN: f64 = 0.5;
/// Least stock that counts as this flank's, mm.
const STOCK: f64 = 0.2;

/// Runs both stages for every flank that is ground.
///
/// # Errors
/// Those of the stages, e.g. a ray that nothing reaches.
pub fn run(
    setup: &GrindingSetup,
    execution: &Execution,
    feed_per_revolution: Option<f64>,
    progress: &dyn Progress,
) -> Result<Sides<Option<Verdict>>, RemovalError> {
    Sides::try_from_fn(|flank| run_flank(setup, execution, flank, feed_per_revolution, progress))
}

/// Columns along the worm on which the spacing over the profile is judged.
const COLUMNS: usize = 3;
/// The worm's spline may miss its rays by this much before a cell is halved, mm.
const SPLINE_TOLERANCE: f64 = 1e-6;
/// Halvings of a cell at the most; reliefs with a kink in the slope end here.
const HALVINGS: usize = 6;

/// Halves the cells over the profile in which a spline misses the rays in the middle, until it does not: reliefs bend the
/// profile far more sharply than crownings.
fn refined(dressing: &Dressing<'_>, even: &RayGrid) -> Result<RayGrid, RemovalError> {
    let z = even.z();
    let columns: Vec<f64> = (0..COLUMNS).map(|k| z[k * (z.len() - 1) / (COLUMNS - 1)]).collect();
    let rays = |w: &[f64]| dress(dressing, &RayGrid::new(w.to_vec(), columns.clone())?, &Silent)?.lengths();
    let mut w = even.w().to_vec();
    let mut f = rays(&w)?;
    for _ in 0..HALVINGS {
        let middles: Vec<f64> = w.windows(2).map(|cell| 0.5 * (cell[0] + cell[1])).collect();
        let between = rays(&middles)?;
        let mut coarse = vec![false; middles.len()];
        for column in 0..COLUMNS {
            let along: Vec<f64> = f.chunks(COLUMNS).map(|row| row[column]).collect();
            let spline = CubicSpline::new(&w, &along)?;
            for (k, &middle) in middles.iter().enumerate() {
                coarse[k] |= (spline.value(middle) - between[k * COLUMNS + column]).abs() > SPLINE_TOLERANCE;
            }
        }
        if !coarse.contains(&true) {
            break;
        }
        let mut merged: Vec<(f64, Vec<f64>)> =
            w.iter().zip(f.chunks(COLUMNS)).map(|(&w, row)| (w, row.to_vec())).collect();
        let halved = middles.iter().zip(between.chunks(COLUMNS)).zip(&coarse).filter(|(_, coarse)| **coarse);
        merged.extend(halved.map(|((&w, row), _)| (w, row.to_vec())));
        merged.sort_by(|a, b| a.0.total_cmp(&b.0));
        w = merged.iter().map(|m| m.0).collect();
        f = merged.into_iter().flat_map(|m| m.1).collect();
    }
    RayGrid::new(w, z.to_vec())
}

fn run_flank(
    setup: &GrindingSetup,
    execution: &Execution,
    flank: Flank,
    feed_per_revolution: Option<f64>,
    progress: &dyn Progress,
) -> Result<Option<Verdict>, RemovalError> {
    let Some(executed) = &execution.flanks[flank] else { return Ok(None) };
    let (worm, work) = (setup.pair.worm.flank(flank), setup.pair.work.flank(flank));
    let dresser = &execution.tool.flanks[flank];
    let motion = executed.dressing(&execution.tool);
    let (from, to) = executed.corrections[0].interval();
    // Only where rays stand follows from the finished area. Beyond its tip the worm does not exist; what it does not reach
    // stays uncut and is told.
    let (w, z) = finished_area(setup, &execution.tool, flank, &executed.corrections);
    let z = [z[0] + WORM_MARGIN, z[1] - WORM_MARGIN];
    // The stages take up to a quarter of the normal base pitch, beyond which the next flank begins.
    let base_pitch = 2.0 * std::f64::consts::PI * worm.base_radius * worm.base_helix_angle.cos() / worm.teeth;
    let stock = STOCK.max(3.0 * executed.target.largest()).min(0.24 * base_pitch);
    let dressing =
        Dressing { worm, dresser: &dresser.profile, motion: &motion, shift_range: [from, to], stock };
    let even = RayGrid::spaced(w, WORM_SPACING[0], z, WORM_SPACING[1])?;
    let worm_grid = refined(&dressing, &even)?;
    let dressed = dress(&dressing, &worm_grid, progress)?;
    let surface = dressed.surface()?;
    let grid = RayGrid::new(executed.target.w.clone(), executed.target.z.clone())?;
    let grinding = Grinding {
        worm,
        area: WormArea { w, z },
        modification: &surface,
        work,
        motion: &execution.motion,
        feed_range: execution.feed_range,
        stock,
        threads: ActiveThreads::All,
        mode: GrindingMode::Continuous,
    };
    let ground = grind(&grinding, &grid, progress)?;
    let feed_mark = feed_per_revolution.map(|feed| feed_mark(&grinding, feed, &executed.target, progress));
    let simulated = Topography { f: ground.lengths()?, ..executed.target.clone() };
    Ok(Some(Verdict {
        simulated,
        dressing: StageReport { statistics: dressed.statistics, error_um: surface.error_um },
        grinding: StageReport { statistics: ground.statistics, error_um: ground.error_um },
        feed_mark,
    }))
}

/// Rays of the feed-mark sample over the profile and over the face width: their phases in the marks differ.
const MARK_SAMPLE: usize = 9;

/// Largest height of the true feed marks over the envelope on a sample of rays, mm.
fn feed_mark(
    grinding: &Grinding<'_>,
    feed_per_revolution: f64,
    target: &Topography,
    progress: &dyn Progress,
) -> Result<f64, RemovalError> {
    let sample = |x: &[f64]| -> Vec<f64> {
        let last = MARK_SAMPLE - 1;
        (0..MARK_SAMPLE).map(|k| x[0] + (x[x.len() - 1] - x[0]) * k as f64 / last as f64).collect()
    };
    let grid = RayGrid::new(sample(&target.w), sample(&target.z))?;
    let envelope = grind(grinding, &grid, progress)?.lengths()?;
    let start = grinding.feed_range[0];
    let passes = Grinding { mode: GrindingMode::FeedMarks { feed_per_revolution, start }, ..*grinding };
    let marked = grind(&passes, &grid, progress)?.lengths()?;
    Ok(marked.iter().zip(&envelope).map(|(m, e)| m - e).fold(0.0, f64::max))
}
