//! Whether roughing strokes stay above the finished flank that shift by a ratio of their own, or whose area of the worm has a modification of
//! its own. The worm's lines then lie elsewhere on the gear: the stroke leaves another twist, which the stock that it is to leave has to cover.

use super::execution::{ExecutedTool, Execution};
use super::prepare::Prepared;
use super::programs::StrokeLaw;
use super::programs::areas::ProgramAreas;
use super::programs::work::{levers_of, shared};
use super::referee::{self, Cutting};
use super::roughing_pass::{RoughingArea, RoughingPass};
use contact::{ContactSolution, StandOff};
use dressing::DressedWorm;
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::GeneratingMotion;
use foundation::numerics::{Silent, extremes};
use generating::PlanningGrid;
use verdict::{Remark, Verdict};

/// One flank after a roughing stroke.
pub struct Roughed {
    /// Number of the stroke, from 1.
    stroke: usize,
    flank: Flank,
    /// What the stroke is to leave, mm.
    left: f64,
    /// Whether it uses an area of the worm that is kept for it.
    in_area: bool,
    /// Least and largest height over the finished flank, mm; why they are not known otherwise.
    heights: Result<[f64; 2], String>,
}

impl Roughed {
    /// Whether the stroke goes below the finished flank.
    pub fn is_too_deep(&self) -> bool {
        self.heights.as_ref().is_ok_and(|[least, _]| *least < 0.0)
    }
}

/// The flanks after each roughing stroke with a shift of its own, by the exact contact of the worm as it is dressed, and after each one in an area
/// with a ratio or a modification of its own, by rays: of the worm that the dresser leaves there, and of the flank that this worm leaves.
pub fn roughed_flanks(
    prepared: &Prepared,
    execution: &Execution,
    (finished, cutting): (&Sides<Option<referee::Verdict>>, Cutting<'_>),
) -> Vec<Roughed> {
    let mut found = by_own_shift(prepared, execution);
    found.extend(in_areas(prepared, execution, finished, cutting));
    found
}

/// Judges the flanks after roughing strokes.
pub fn judge_roughing(verdict: &mut Verdict, prepared: &Prepared, roughed: Vec<Roughed>) {
    for Roughed { stroke, flank, left, in_area, heights } in roughed {
        let listed = (stroke - 1) % prepared.technology.strokes_of_a_pass();
        let (item, why, instead) = if in_area {
            (
                format!("{flank} flank after stroke {stroke}, which has its own area of the worm"),
                "its area leaves another flank than the plan",
                "or a modification_share nearer to 1",
            )
        } else {
            (
                format!("{flank} flank after stroke {stroke}, which shifts by a ratio of its own"),
                "its shift leaves another twist than the plan",
                "or leave its shift.ratio out",
            )
        };
        match heights {
            Ok([least, most]) => {
                let detail = if least < 0.0 {
                    format!("up to {:.2} µm below the finished flank", -1e3 * least)
                } else if in_area {
                    format!("{:.2} to {:.2} µm over the finished flank", 1e3 * least, 1e3 * most)
                } else {
                    format!("{:.2} µm or more above the finished flank", 1e3 * least)
                };
                verdict.judge(item, least >= 0.0, detail, || {
                    Remark::new(
                        "roughing-below-finished",
                        format!(
                            "stroke {stroke} goes {:.2} um below the finished {flank} flank: {why}, more than the {:.1} um that it is to leave",
                            -1e3 * least,
                            1e3 * left
                        ),
                        format!(
                            "leave {:.1} um or more (technology.strokes[{}].left_um), {instead}",
                            1e3 * (left - least).max(0.0),
                            listed
                        ),
                    )
                });
            }
            Err(error) => verdict.owe(
                item,
                Remark::new(
                    "roughing-not-judged",
                    format!("what stroke {stroke} leaves on the {flank} flank is not known: {error}"),
                    "leave its shift.ratio out, or take a ratio nearer to that of the plan",
                ),
            ),
        }
    }
}

/// The contact of a raised worm moves along the face by this much at the most, mm.
const FEED_MARGIN: f64 = 3.0;

/// Strokes in areas of the worm that have a ratio or a modification of their own.
fn in_areas(
    prepared: &Prepared,
    execution: &Execution,
    finished: &Sides<Option<referee::Verdict>>,
    cutting: Cutting<'_>,
) -> Vec<Roughed> {
    if !prepared.cycle.roughing.iter().any(RoughingArea::is_own) {
        return Vec::new();
    }
    // What the areas cannot be laid out for, the partition of the result refuses.
    let Ok(Some(areas)) = ProgramAreas::of_execution(prepared, execution) else { return Vec::new() };
    let passes = areas.roughing_passes();
    let mut found = Vec::new();
    let mut numbers = Sides::both(0usize);
    for (k, stroke) in prepared.technology.strokes.iter().enumerate().filter(|(_, stroke)| !stroke.finishes())
    {
        for flank in stroke.ground.flanks() {
            let pass = &passes[numbers[flank] % passes.len()];
            numbers[flank] += 1;
            if execution.flanks[flank].is_none() || !pass.area.is_own() {
                continue;
            }
            let left = stroke.left[flank];
            let ground: Vec<Flank> =
                stroke.ground.flanks().filter(|&flank| execution.flanks[flank].is_some()).collect();
            let infeed = StandOff::of_ground(levers_of(&prepared.setup, &ground), stroke.left);
            let heights = rayed_heights(
                (prepared, execution, &areas),
                (flank, pass),
                (infeed, left),
                (finished[flank].as_ref(), cutting),
            );
            found.push(Roughed { stroke: k + 1, flank, left, in_area: true, heights });
        }
    }
    found
}

/// Least and largest height of a flank after a stroke in its area over the finished one, mm.
fn rayed_heights(
    (prepared, execution, areas): (&Prepared, &Execution, &ProgramAreas),
    (flank, pass): (Flank, &RoughingPass),
    (infeed, left): (StandOff, f64),
    (finished, cutting): (Option<&referee::Verdict>, Cutting<'_>),
) -> Result<[f64; 2], String> {
    const ONE_STROKE: &str = "the worm is not dressed in one stroke of the flank";
    let dresser = execution.dresser.as_ref().ok_or(ONE_STROKE)?;
    let planned = (&execution.motion.shift, execution.ratio);
    let mut motion = execution.motion.clone();
    let share = pass.area.share.unwrap_or(0.0);
    // Without a share of its own the motion of grinding is that of the plan.
    if pass.area.share.is_some() {
        for law in [&mut motion.delta_d, &mut motion.delta_phi_2] {
            *law = shared(law, execution.feed_range, share);
        }
    }
    motion.delta_d = motion.delta_d.raised(infeed.delta_d);
    motion.delta_phi_2 = motion.delta_phi_2.raised(infeed.delta_phi_2);
    motion.shift = pass.shift.clone();
    let [from, to] = execution.feed_range;
    let feeds = [from - FEED_MARGIN, to + FEED_MARGIN];
    let change = |corrections: &_| areas.roughed(pass, (dresser, &[flank]), planned, corrections);
    let roughed = execution.roughed(flank, change, (motion, feeds), left).ok_or(ONE_STROKE)?;
    let cutting = Cutting { feed_per_revolution: None, ..cutting };
    let rays =
        referee::run(&prepared.setup, &roughed, cutting, &Silent).map_err(|error| error.to_string())?;
    let (Some(rays), Some(finished)) = (&rays[flank], finished) else {
        return Err("no rays stand on it".into());
    };
    Ok(extremes(rays.simulated.minus(&finished.simulated).f))
}

/// Strokes with a shift of their own.
fn by_own_shift(prepared: &Prepared, execution: &Execution) -> Vec<Roughed> {
    let own: Vec<_> = (prepared.technology.strokes.iter().enumerate())
        .filter(|(_, stroke)| !stroke.finishes())
        .filter_map(|(k, stroke)| match &stroke.shift {
            StrokeLaw::Own(law) => Some((k, stroke, law)),
            StrokeLaw::Planned => None,
        })
        .collect();
    if own.is_empty() {
        return Vec::new();
    }
    let setup = &prepared.setup;
    let (profile_points, helix_points) = prepared.rules.grid();
    let grid = PlanningGrid::new(setup, profile_points, helix_points);
    let of = |flank: Flank, motion: &GeneratingMotion| flank_of(prepared, execution, (flank, &grid), motion);
    let finished = Sides::from_fn(|flank| of(flank, &execution.motion));
    let mut found = Vec::new();
    for (k, stroke, law) in own {
        let mut motion = execution.motion.clone();
        let ground: Vec<Flank> =
            stroke.ground.flanks().filter(|&flank| execution.flanks[flank].is_some()).collect();
        let infeed = StandOff::of_ground(levers_of(setup, &ground), stroke.left);
        motion.delta_d = motion.delta_d.raised(infeed.delta_d);
        motion.delta_phi_2 = motion.delta_phi_2.raised(infeed.delta_phi_2);
        motion.shift = law.clone();
        for &flank in &ground {
            let height = || {
                let finished = finished[flank].as_ref().map_err(Clone::clone)?;
                let roughed = of(flank, &motion)?;
                Ok(extremes(roughed.iter().zip(finished).map(|(above, below)| above.f_n - below.f_n)))
            };
            let left = stroke.left[flank];
            found.push(Roughed { stroke: k + 1, flank, left, in_area: false, heights: height() });
        }
    }
    found
}

/// The flank that the worm of a run leaves under a motion.
fn flank_of(
    prepared: &Prepared,
    execution: &Execution,
    (flank, grid): (Flank, &PlanningGrid),
    motion: &GeneratingMotion,
) -> Result<Vec<ContactSolution>, String> {
    let setup = &prepared.setup;
    let executed = execution.flanks[flank].as_ref().ok_or("it is not ground")?;
    let found = match (&executed.tool, &execution.dresser) {
        (ExecutedTool::Dressed(dressing), Some(dresser)) => {
            grid.ground(setup, flank, motion, &DressedWorm::new(dresser, flank, &dressing.corrections))
        }
        (ExecutedTool::Made(made), _) => grid.ground(setup, flank, motion, &made.surface(setup, flank)),
        _ => return Err("the worm is dressed in strokes".into()),
    };
    found.map_err(|error| error.to_string())
}
