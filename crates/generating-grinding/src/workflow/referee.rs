//! The referee's run: rays of the worm against the dresser, then rays of the workpiece against the worm that those rays
//! left (`docs/mathematics/planning.md#the-referee`). Nothing of the process's own formulas enters here, only bodies and motions.

use super::executed_strokes::ExecutedStrokes;
use super::execution::{ExecutedDressing, ExecutedTool, Execution};
use super::stroke_plan::StrokePlan;
use dressing::DresserTool;
use foundation::geometry::{Flank, InvoluteFlank, Sides};
use foundation::numerics::{CubicSpline, Progress, Silent};
use generating::{FinishedArea, GrindingSetup, StrokeLayout};
use metrology::Topography;
use referee::{
    ActiveThreads, DressedSurface, Dressing, Grinding, GrindingMode, RayGrid, RemovalError, Statistics,
    WormArea, WormModification, dress_in_strokes, grind,
};

/// What one stage did and how exact it is.
#[derive(Clone, Debug, PartialEq)]
pub struct StageReport {
    /// Counts.
    pub statistics: Statistics,
    /// Bound of its own error, um.
    pub error_um: f64,
}

/// How the strokes cut.
#[derive(Clone, Copy, Debug)]
pub struct Cutting<'a> {
    /// Axial feed per revolution of the gear, mm, for the true feed marks.
    pub feed_per_revolution: Option<f64>,
    /// Threads and strokes, where threads are left out.
    pub strokes: Option<&'a StrokePlan>,
}

impl<'a> Cutting<'a> {
    fn threads(&self) -> ActiveThreads<'a> {
        self.strokes.map_or(ActiveThreads::All, |plan| ActiveThreads::Only {
            threads: &plan.active_threads,
            strokes: &plan.index_pitches,
        })
    }
}

/// The referee's verdict on one flank.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// The flank that the rays left, normal, mm.
    pub simulated: Topography,
    /// Dresser against worm; `None` for a tool that is not dressed.
    pub dressing: Option<StageReport>,
    /// Worm against workpiece; its error contains that of the worm surface.
    pub grinding: StageReport,
    /// Height of the true feed marks over the envelope on a sample of rays, mm, or why they could not be followed; `None`
    /// without a feed.
    pub feed_mark: Option<Result<f64, RemovalError>>,
    /// The worm flank that the dresser left; `None` for a tool that is not dressed.
    pub dressed: Option<DressedSurface>,
}

impl Verdict {
    /// f_n1 of the worm that ground the flank: as the dresser left it, or as the table has it.
    pub fn worm<'a>(&'a self, tool: &'a ExecutedTool) -> Option<&'a dyn WormModification> {
        worm_function(tool, self.dressed.as_ref())
    }
}

/// f_n1 of the worm that grinds a flank: the surface that its dressing left, or its table, which is the tool itself where none was dressed.
fn worm_function<'a>(
    tool: &'a ExecutedTool,
    dressed: Option<&'a DressedSurface>,
) -> Option<&'a dyn WormModification> {
    match (tool, dressed) {
        (_, Some(dressed)) => Some(dressed),
        (ExecutedTool::Made(made), None) => Some(&made.spline),
        (ExecutedTool::Dressed(_) | ExecutedTool::Stroked(_), None) => None,
    }
}

/// Spacing of the worm's rays: over the profile and along the worm, mm (`docs/mathematics/planning.md#the-referee`).
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
    cutting: Cutting<'_>,
    progress: &dyn Progress,
) -> Result<Sides<Option<Verdict>>, RemovalError> {
    Sides::try_from_fn(|flank| run_flank(setup, execution, flank, cutting, progress))
}

/// Sections on which the spacing along the other axis is judged.
const SECTIONS: usize = 3;
/// The worm's spline may miss its rays by this much before a cell is halved, mm.
const SPLINE_TOLERANCE: f64 = 1e-6;
/// A second place in each cell at which its spline is judged: beside a kink the spline crosses the flank inside the cell, and a middle
/// that happens to lie there would pass for fine.
const BESIDE_MIDDLE: f64 = 0.25;
/// Halvings of a cell at the most; reliefs with a kink in the slope end here.
const HALVINGS: usize = 6;

/// Both ends and the middle of an axis.
fn sections(axis: &[f64]) -> Vec<f64> {
    (0..SECTIONS).map(|k| axis[k * (axis.len() - 1) / (SECTIONS - 1)]).collect()
}

/// Halves the cells over the profile and along the worm in which a spline misses the rays, until it does not:
/// reliefs bend the flank far more sharply than crownings.
fn refined(dressing: &[Dressing<'_>], even: &RayGrid) -> Result<RayGrid, RemovalError> {
    let rays = |w: &[f64], z: &[f64]| {
        let grid = RayGrid::new(w.to_vec(), z.to_vec())?;
        dress_in_strokes(dressing, &grid, &Silent)?.lengths().map(|f| (f, grid.z().len()))
    };
    let columns = sections(even.z());
    let over_profile = |w: &[f64]| {
        let (f, width) = rays(w, &columns)?;
        Ok(f.chunks(width).map(<[f64]>::to_vec).collect())
    };
    let w = halved(even.w(), over_profile)?;
    let rows = sections(even.w());
    let along_worm = |z: &[f64]| {
        let (f, width) = rays(&rows, z)?;
        Ok((0..width).map(|j| (0..SECTIONS).map(|i| f[i * width + j]).collect()).collect())
    };
    let z = halved(even.z(), along_worm)?;
    RayGrid::new(w, z)
}

/// The axis with every cell halved in which a spline through its values on the sections misses those inside.
fn halved(
    axis: &[f64],
    values: impl Fn(&[f64]) -> Result<Vec<Vec<f64>>, RemovalError>,
) -> Result<Vec<f64>, RemovalError> {
    let mut x = axis.to_vec();
    let mut f = values(&x)?;
    // Only cells that are new since the last round can still be too coarse.
    let mut fresh = vec![true; x.len() - 1];
    for _ in 0..HALVINGS {
        let cells: Vec<usize> = (0..fresh.len()).filter(|&k| fresh[k]).collect();
        let within =
            |share: f64| -> Vec<f64> { cells.iter().map(|&k| x[k] + share * (x[k + 1] - x[k])).collect() };
        let (middles, beside) = (within(0.5), within(BESIDE_MIDDLE));
        if middles.is_empty() {
            break;
        }
        let between = values(&middles)?;
        let controls = values(&beside)?;
        let mut coarse = vec![false; middles.len()];
        for section in 0..SECTIONS {
            let along: Vec<f64> = f.iter().map(|values| values[section]).collect();
            let spline = CubicSpline::new(&x, &along)?;
            let misses = |at: f64, ray: f64| (spline.value(at) - ray).abs() > SPLINE_TOLERANCE;
            for (k, coarse) in coarse.iter_mut().enumerate() {
                *coarse |= misses(middles[k], between[k][section]) || misses(beside[k], controls[k][section]);
            }
        }
        let mut next = (Vec::new(), Vec::new(), Vec::new());
        let mut looked = cells.iter().zip(middles.iter().zip(between).zip(coarse)).peekable();
        for k in 0..x.len() {
            next.0.push(x[k]);
            next.1.push(f[k].clone());
            let here = looked.next_if(|(cell, _)| **cell == k);
            match here {
                Some((_, ((&middle, values), true))) => {
                    next.0.push(middle);
                    next.1.push(values);
                    next.2.extend([true, true]);
                }
                _ => next.2.push(false),
            }
        }
        next.2.truncate(next.0.len() - 1);
        (x, f, fresh) = next;
    }
    Ok(x)
}

/// The worm as the rays of stage one left it.
pub struct RayedWorm {
    /// The worm as its rays left it.
    pub surface: DressedSurface,
    /// The part of it that the rays cover.
    pub area: WormArea,
    /// What the rays took.
    pub statistics: Statistics,
}

/// Dressing stages of a worm flank, given on to `take` with the lengths of roll and the worm positions on which rays stand, mm.
fn of_dressed<T>(
    setup: &GrindingSetup,
    dresser: &DresserTool,
    dressing: &ExecutedDressing,
    (flank, expected): (Flank, f64),
    take: impl FnOnce(&[Dressing<'_>], [f64; 2], [f64; 2]) -> Result<T, RemovalError>,
) -> Result<T, RemovalError> {
    // Only where rays stand follows from the finished area. Beyond its tip the worm does not exist; what it does not reach
    // stays uncut and is told.
    let FinishedArea { w, z, largest } = FinishedArea::new(setup, dresser, flank, &dressing.corrections);
    let z = [z[0] + WORM_MARGIN, z[1] - WORM_MARGIN];
    let worm = setup.pair.worm.flank(flank);
    let stage = Dressing {
        worm,
        dresser: &dresser.flanks[flank].profile,
        motion: &dressing.motion,
        shift_range: dressing.driven,
        stock: stock(worm, expected.max(largest)),
    };
    take(&[stage], w, z)
}

/// The same of a worm that several strokes leave, each by the part of its dresser that cuts.
fn of_stroked<T>(
    setup: &GrindingSetup,
    layout: &StrokeLayout,
    strokes: &ExecutedStrokes,
    (flank, expected): (Flank, f64),
    take: impl FnOnce(&[Dressing<'_>], [f64; 2], [f64; 2]) -> Result<T, RemovalError>,
) -> Result<T, RemovalError> {
    let mut bodies = Vec::with_capacity(strokes.strokes.len());
    for stroke in &strokes.strokes {
        let Some(tool) = layout.dressers.get(stroke.place.dresser) else { continue };
        let [from, to] = stroke.place.area.touching();
        bodies.push((tool.flanks[flank].profile.part(from, to), stroke));
    }
    let stages: Vec<Dressing<'_>> = bodies
        .iter()
        .map(|(body, stroke)| Dressing {
            worm: setup.pair.worm.flank(flank),
            dresser: body,
            motion: &stroke.motion,
            shift_range: stroke.driven,
            stock: stock(setup.pair.worm.flank(flank), expected),
        })
        .collect();
    // Only where rays stand follows from the process: what the strokes do not reach there stays uncut and is told.
    let (w, z) = strokes.area;
    take(&stages, w, [z[0] + WORM_MARGIN, z[1] - WORM_MARGIN])
}

/// Largest length of a ray that counts as this flank's, mm: above what is expected (mm) by far, but no more than a quarter of the normal
/// base pitch of the worm, beyond which the next flank begins.
pub fn stock(worm: &InvoluteFlank, expected: f64) -> f64 {
    let base_pitch = 2.0 * std::f64::consts::PI * worm.base_radius * worm.base_helix_angle.cos() / worm.teeth;
    STOCK.max(3.0 * expected).min(0.24 * base_pitch)
}

/// The surface through the rays over lengths of roll w and worm positions z.
pub fn rayed(
    stages: &[Dressing<'_>],
    w: [f64; 2],
    z: [f64; 2],
    progress: &dyn Progress,
) -> Result<RayedWorm, RemovalError> {
    let even = RayGrid::spaced(w, WORM_SPACING[0], z, WORM_SPACING[1])?;
    let dressed = dress_in_strokes(stages, &refined(stages, &even)?, progress)?;
    Ok(RayedWorm { surface: dressed.surface()?, area: WormArea { w, z }, statistics: dressed.statistics })
}

/// What `take` makes of the dressing stages of a flank; `None` for one that is not ground and for a tool that is not dressed.
fn on_worm<T>(
    setup: &GrindingSetup,
    execution: &Execution,
    flank: Flank,
    take: impl FnOnce(&[Dressing<'_>], [f64; 2], [f64; 2]) -> Result<T, RemovalError>,
) -> Result<Option<T>, RemovalError> {
    let Some(executed) = &execution.flanks[flank] else { return Ok(None) };
    let of = (flank, executed.target.largest());
    match (&executed.tool, &execution.dresser, &setup.strokes) {
        (ExecutedTool::Dressed(dressing), Some(dresser), _) => {
            of_dressed(setup, dresser, dressing, of, take).map(Some)
        }
        (ExecutedTool::Stroked(strokes), _, Some(layout)) => {
            of_stroked(setup, layout, strokes, of, take).map(Some)
        }
        _ => Ok(None),
    }
}

/// Lengths of rays over the worm flanks that the dressing strokes leave, on a grid of so many over the profile and along the worm, mm.
///
/// # Errors
/// Those of the stage.
pub fn worm_rays(
    setup: &GrindingSetup,
    execution: &Execution,
    [over_profile, along_worm]: [usize; 2],
) -> Result<Sides<Option<Vec<f64>>>, RemovalError> {
    Sides::try_from_fn(|flank| {
        on_worm(setup, execution, flank, |stages, w, z| {
            dress_in_strokes(stages, &RayGrid::equidistant(w, over_profile, z, along_worm)?, &Silent)?
                .lengths()
        })
    })
}

/// The stage in which a worm with this modification grinds a flank.
fn grinding<'a>(
    setup: &'a GrindingSetup,
    execution: &'a Execution,
    (flank, stock): (Flank, f64),
    modification: &'a dyn WormModification,
    cutting: Cutting<'a>,
) -> Grinding<'a> {
    let [w, z] = modification.domain();
    Grinding {
        worm: setup.pair.worm.flank(flank),
        area: WormArea { w, z },
        modification,
        work: setup.pair.work.flank(flank),
        motion: &execution.motion,
        feed_range: execution.feed_range,
        stock,
        threads: cutting.threads(),
        mode: GrindingMode::Continuous,
    }
}

/// Lengths of rays at other places of a flank that the worm of a verdict ground, row by row over the profile, mm; `None` for a flank that
/// is not ground.
///
/// # Errors
/// Those of the stage.
pub fn rays_at(
    setup: &GrindingSetup,
    execution: &Execution,
    (flank, verdict): (Flank, &Verdict),
    cutting: Cutting<'_>,
    grid: &RayGrid,
) -> Result<Option<Vec<f64>>, RemovalError> {
    let Some(executed) = &execution.flanks[flank] else { return Ok(None) };
    let Some(modification) = verdict.worm(&executed.tool) else { return Ok(None) };
    let stock = stock(setup.pair.worm.flank(flank), executed.target.largest());
    let grinding = grinding(setup, execution, (flank, stock), modification, cutting);
    grind(&grinding, grid, &Silent)?.lengths().map(Some)
}

fn run_flank(
    setup: &GrindingSetup,
    execution: &Execution,
    flank: Flank,
    cutting: Cutting<'_>,
    progress: &dyn Progress,
) -> Result<Option<Verdict>, RemovalError> {
    let Some(executed) = &execution.flanks[flank] else { return Ok(None) };
    let stock = stock(setup.pair.worm.flank(flank), executed.target.largest());
    let dressed = on_worm(setup, execution, flank, |stages, w, z| rayed(stages, w, z, progress))?;
    let Some(modification) = worm_function(&executed.tool, dressed.as_ref().map(|worm| &worm.surface)) else {
        return Ok(None);
    };
    let grid = RayGrid::new(executed.target.w.clone(), executed.target.z.clone())?;
    let grinding = grinding(setup, execution, (flank, stock), modification, cutting);
    let ground = grind(&grinding, &grid, progress)?;
    let feed_mark =
        cutting.feed_per_revolution.map(|feed| feed_mark(&grinding, feed, &executed.target, progress));
    let simulated = Topography { f: ground.lengths()?, ..executed.target.clone() };
    Ok(Some(Verdict {
        simulated,
        dressing: dressed
            .as_ref()
            .map(|d| StageReport { statistics: d.statistics, error_um: d.surface.error_um }),
        grinding: StageReport { statistics: ground.statistics, error_um: ground.error_um },
        feed_mark,
        dressed: dressed.map(|dressed| dressed.surface),
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
