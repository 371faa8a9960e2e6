//! The scene of generating grinding: gear, worm and dresser; the worm dressed flank by flank, then the gear ground. Knows no file.

use super::disc::{dresser_disc, narrow_disc};
use super::dressing::{Parked, ShownDressing, WormExtent, dressing_frame, parked_dresser};
use super::finish::{finished, unmeshed};
use super::generating::{ShownFlank, ShownGenerating};
use super::shape::{Body, BodyKind, Coordinate, Scene, Stage};
use super::toothed::Toothed;
use crate::contact::{ContactSolution, ExactContact, ModifiedThread, Pair, ToolSurface, Unmodified};
use crate::exchange::LoadedJob;
use crate::exchange::job::{DressingFlanks, Job};
use crate::geometry::{Blank, Flank, Sides};
use crate::kinematics::{DressingMotion, GeneratingMotion};
use crate::numerics::{Chebyshev, equidistant};
use crate::process::dressing::{DressedWorm, DresserSection, DresserTool, DressingError, TipDisc};
use crate::process::generating::GeneratingError;
use crate::workflow::execution::{ExecutedFlank, ExecutedTool};
use crate::workflow::finding::RunFailure;
use crate::workflow::line_dressing::WrittenFlank;
use crate::workflow::run::Outcome;
use nalgebra::Vector3;

/// Points of the line in which dresser and worm touch.
const LINE: usize = 25;
/// The line is looked for this share of the used profile beside it.
const BESIDE: f64 = 0.1;
/// Frames of a worm that is written line by line.
const WRITTEN_FRAMES: usize = 241;

/// Gear, worm and dresser of a run, and its strokes: one stage for each dressing motion, one for grinding.
///
/// # Errors
/// [`RunFailure`] for bodies that cannot be meshed and motions without numbers.
pub fn scene_of_grinding(loaded: &LoadedJob, outcome: &Outcome) -> Result<Scene, RunFailure> {
    let job = &loaded.job;
    let setup = &outcome.prepared.setup;
    let execution = &outcome.execution;
    let faces = worm_faces(job, outcome);
    let radii = [setup.worm_root_radius, setup.worm_tip_radius];
    let slope = setup.pair.worm.data().cone_angle.tan();
    let extent = WormExtent { radii, slope, faces };
    let mut bodies = gear_and_worm(&setup.pair, &setup.input.blank, radii, faces)?;
    let depth = radii[1] - radii[0];

    let flanks: Vec<(Flank, &ExecutedFlank)> = Flank::BOTH
        .into_iter()
        .filter_map(|flank| Some((flank, execution.flanks[flank].as_ref()?)))
        .collect();
    let pair = &setup.pair;
    let solvers: Vec<Box<dyn Fn(f64, f64) -> Option<ContactSolution> + '_>> = flanks
        .iter()
        .map(|&(flank, executed)| solver(outcome, pair, &execution.motion, flank, executed))
        .collect();
    let shown = flanks.iter().zip(&solvers).map(|(&(flank, _), solve)| ShownFlank {
        flank,
        roll: setup.fields[flank].roll(),
        face: setup.fields[flank].face(),
        solve: solve.as_ref(),
    });
    let grinding = ShownGenerating {
        id: "grinding".into(),
        title: "Grinding the gear".into(),
        pair,
        motion: &execution.motion,
        feed: execution.feed_range,
        flanks: shown.collect(),
    };

    let dressers = dressers(job, outcome)?;
    bodies.extend(dressers.iter().map(|dresser| dresser.body.clone()));
    let mut strokes = Vec::new();
    for &(flank, executed) in &flanks {
        strokes.extend(strokes_of(outcome, flank, executed, &dressers));
    }
    let gear: Parked = ("gear".into(), grinding.parked_gear(depth));
    let mut aside: Vec<Parked> = Vec::new();
    for dresser in &dressers {
        let first = strokes.iter().find(|stroke| stroke.dresser == dresser.body.id);
        let position = match (first, &outcome.written) {
            (Some(stroke), _) => Some(stroke.motion.position(stroke.driven[0])),
            (None, Sides { left, right }) => {
                left.iter().chain(right).find_map(|w| Some(w.positions.first()?.first()?.1))
            }
        };
        aside.extend(position.map(|position| (dresser.body.id.clone(), parked_dresser(&position, depth))));
    }
    let beside_dressing: Vec<Parked> = std::iter::once(gear).chain(aside.iter().cloned()).collect();
    let mut stages: Vec<Stage> = strokes
        .iter()
        .map(|stroke| {
            let surface = DressedWorm::new(stroke.tool, stroke.flank, stroke.corrections);
            let line = |v: f64| -> Vec<Vector3<f64>> {
                // Circles beyond the tip radius are not there.
                let profile = &stroke.tool.flanks[stroke.flank].profile;
                let there = |t: &f64| profile.covers(*t) && profile.at(*t).r <= stroke.tip_radius;
                let touched = equidistant(stroke.profile, LINE).into_iter().filter(there);
                touched.filter_map(|t| Some(surface.jet(t, v)?.p)).collect()
            };
            let shown = ShownDressing {
                id: stroke.id.clone(),
                title: stroke.title.clone(),
                motion: stroke.motion,
                driven: stroke.driven,
                dresser: &stroke.dresser,
                offset: stroke.offset,
                line: &line,
            };
            shown.stage(&extent, &beside_dressing)
        })
        .collect();
    for (flank, written) in outcome.written.iter() {
        let Some(written) = written else { continue };
        stages.extend(written_stage(flank, written, pair, &extent, &beside_dressing));
    }
    stages.push(grinding.stage(&aside));
    finished(Scene { bodies, stages })
}

/// The bodies of the gear and of the worm.
///
/// # Errors
/// [`RunFailure`] where a mesh cannot be made.
pub(super) fn gear_and_worm(
    pair: &Pair,
    blank: &Blank,
    [worm_root, worm_tip]: [f64; 2],
    worm_faces: [f64; 2],
) -> Result<Vec<Body>, RunFailure> {
    let half = 0.5 * blank.face_width;
    let gear = Toothed {
        gear: &pair.work,
        tip: 0.5 * blank.tip_diameter,
        root: 0.5 * blank.root_diameter,
        form: 0.5 * blank.form_diameter,
        faces: [-half, half],
    };
    let worm =
        Toothed { gear: &pair.worm, tip: worm_tip, root: worm_root, form: worm_root, faces: worm_faces };
    let gear = gear.mesh().map_err(|e| unmeshed("gear", &e))?;
    let worm = worm.mesh().map_err(|e| unmeshed("worm", &e))?;
    Ok(vec![Body::new("gear", BodyKind::Gear, true, &gear), Body::new("worm", BodyKind::Worm, true, &worm)])
}

/// The faces of the worm: its width, else what it needs.
fn worm_faces(job: &Job, outcome: &Outcome) -> [f64; 2] {
    let [from, to] = outcome.execution.occupation;
    let run_in = outcome.prepared.setup.run_in();
    match job.worm.width {
        Some(width) => [-0.5 * width, 0.5 * width],
        None => [from - run_in, to + run_in],
    }
}

/// The exact contact of a flank with the tool that was made for it; with the unmodified tool where that was dressed in strokes.
fn solver<'a>(
    outcome: &'a Outcome,
    pair: &'a Pair,
    motion: &'a GeneratingMotion,
    flank: Flank,
    executed: &'a ExecutedFlank,
) -> Box<dyn Fn(f64, f64) -> Option<ContactSolution> + 'a> {
    match (&executed.tool, &outcome.execution.dresser) {
        (ExecutedTool::Dressed(dressing), Some(dresser)) => {
            solving(pair, flank, motion, DressedWorm::new(dresser, flank, &dressing.corrections))
        }
        (ExecutedTool::Made(made), _) => {
            solving(pair, flank, motion, ModifiedThread::new(*pair.worm.flank(flank), &made.spline))
        }
        (ExecutedTool::Dressed(_) | ExecutedTool::Stroked(_), _) => {
            solving(pair, flank, motion, ModifiedThread::new(*pair.worm.flank(flank), &Unmodified))
        }
    }
}

fn solving<'a, S: ToolSurface + 'a>(
    pair: &'a Pair,
    flank: Flank,
    motion: &'a GeneratingMotion,
    surface: S,
) -> Box<dyn Fn(f64, f64) -> Option<ContactSolution> + 'a> {
    Box::new(move |w, z| ExactContact::new(pair, flank, motion, &surface).solve(w, z).ok())
}

/// A dresser as a body.
struct ShownDresser {
    body: Body,
    /// Its number among those of the job.
    number: usize,
    /// Outside radius, mm.
    tip_radius: f64,
    /// The flank in whose coordinates it is drawn.
    flank: Flank,
    /// How far it is shifted along its axis when it dresses the other flank, mm.
    across: f64,
}

/// A stroke of the dresser.
struct Stroke<'a> {
    id: String,
    title: String,
    flank: Flank,
    tool: &'a DresserTool,
    corrections: &'a [Chebyshev; 4],
    motion: &'a DressingMotion,
    driven: [f64; 2],
    /// What of the profile touches, as far as the tip radius lets it.
    profile: [f64; 2],
    tip_radius: f64,
    dresser: String,
    offset: f64,
}

/// All dressers of a run.
fn dressers(job: &Job, outcome: &Outcome) -> Result<Vec<ShownDresser>, RunFailure> {
    let setup = &outcome.prepared.setup;
    let first = Flank::BOTH.into_iter().find(|&flank| outcome.execution.flanks[flank].is_some());
    let Some(flank) = first else { return Ok(Vec::new()) };
    if let Some((dresser, tip_radius)) = job.point_dresser() {
        let failed = |e: DressingError| RunFailure::from(&GeneratingError::Dressing(e));
        let form = TipDisc::new(0.5 * dresser.tip_diameter, tip_radius).map_err(failed)?;
        let mesh = narrow_disc(&form).map_err(|e| unmeshed("dresser", &e))?;
        let body = Body::new("dresser", BodyKind::Dresser, true, &mesh);
        let tip_radius = form.outside_radius();
        return Ok(vec![ShownDresser { body, number: 0, tip_radius, flank, across: 0.0 }]);
    }
    let Some(tool) = &outcome.execution.dresser else { return Ok(Vec::new()) };
    let land = dresser_land(job, outcome);
    match (&setup.strokes, &setup.input.dresser) {
        (Some(layout), _) => {
            let given = layout.dressers.iter().zip(&layout.tip_radii).enumerate();
            given
                .map(|(number, (tool, &tip))| {
                    let land = land.filter(|_| number == 0);
                    shown_dresser(format!("dresser-{}", number + 1), number, (tool, tip), flank, land)
                })
                .collect()
        }
        (None, Some(choice)) => {
            let tip = 0.5 * choice.tip_diameter;
            Ok(vec![shown_dresser("dresser".into(), 0, (tool, tip), flank, land)?])
        }
        (None, None) => Ok(Vec::new()),
    }
}

/// Width of the land of the dresser: that of the job, else the largest that spares the worm; `None` for a disc whose flanks dress at once.
fn dresser_land(job: &Job, outcome: &Outcome) -> Option<f64> {
    if job.dressing.flanks == DressingFlanks::Two {
        return None;
    }
    let given = job.dresser.as_ref().and_then(|dresser| dresser.tip_land);
    let largest = outcome.result.settings.largest_tip_land_mm.as_ref();
    let least = largest.and_then(|lands| lands.left.into_iter().chain(lands.right).reduce(f64::min));
    given.or(least)
}

fn shown_dresser(
    id: String,
    number: usize,
    (tool, tip_radius): (&DresserTool, f64),
    flank: Flank,
    land: Option<f64>,
) -> Result<ShownDresser, RunFailure> {
    let failed = |e: DressingError| RunFailure::from(&GeneratingError::Dressing(e));
    let section = DresserSection::new(tool, flank, tip_radius).map_err(failed)?;
    let full = section.full_land();
    let land = land.map_or(full, |land| land.clamp(0.0, full));
    let mesh = dresser_disc(&section, land).map_err(failed)?.map_err(|e| unmeshed("dresser", &e))?;
    // The counter flank stands in by what the land is narrower; to dress, it stands where it was designed.
    let side = tool.flanks[flank].profile.at(tool.flanks[flank].designed.middle()).n_z.signum();
    let body = Body::new(id, BodyKind::Dresser, true, &mesh);
    Ok(ShownDresser { body, number, tip_radius, flank, across: -side * (full - land) })
}

/// The strokes in which a flank is dressed by discs in line contact.
fn strokes_of<'a>(
    outcome: &'a Outcome,
    flank: Flank,
    executed: &'a ExecutedFlank,
    dressers: &[ShownDresser],
) -> Vec<Stroke<'a>> {
    let shown = |number: usize| dressers.iter().find(|dresser| dresser.number == number);
    let offset = |dresser: &ShownDresser| if dresser.flank == flank { 0.0 } else { dresser.across };
    match &executed.tool {
        ExecutedTool::Dressed(dressing) => {
            let (Some(tool), Some(dresser)) = (&outcome.execution.dresser, shown(0)) else {
                return Vec::new();
            };
            let designed = tool.flanks[flank].designed;
            let beside = BESIDE * designed.length();
            vec![Stroke {
                id: format!("dressing-{flank}"),
                title: format!("Dressing the {flank} flank of the worm"),
                flank,
                tool,
                corrections: &dressing.corrections,
                motion: &dressing.motion,
                driven: dressing.driven,
                profile: [designed.w_nf - beside, designed.w_na + beside],
                tip_radius: dresser.tip_radius,
                dresser: dresser.body.id.clone(),
                offset: offset(dresser),
            }]
        }
        ExecutedTool::Stroked(strokes) => {
            let Some(layout) = &outcome.prepared.setup.strokes else { return Vec::new() };
            let of_stroke = |(k, stroke): (usize, &'a crate::workflow::executed_strokes::ExecutedStroke)| {
                let dresser = shown(stroke.place.dresser)?;
                Some(Stroke {
                    id: format!("dressing-{flank}-{}", k + 1),
                    title: format!("Dressing the {flank} flank of the worm, stroke {}", k + 1),
                    flank,
                    tool: layout.dressers.get(stroke.place.dresser)?,
                    corrections: &stroke.corrections,
                    motion: &stroke.motion,
                    driven: stroke.driven,
                    profile: stroke.place.area.touching(),
                    tip_radius: dresser.tip_radius,
                    dresser: dresser.body.id.clone(),
                    offset: offset(dresser),
                })
            };
            strokes.strokes.iter().enumerate().filter_map(of_stroke).collect()
        }
        ExecutedTool::Made(_) => Vec::new(),
    }
}

/// The stage of a flank that a narrow disc writes line by line: frames spread over all lines.
fn written_stage(
    flank: Flank,
    written: &WrittenFlank,
    pair: &Pair,
    extent: &WormExtent,
    parked: &[Parked],
) -> Option<Stage> {
    let worm = pair.worm.flank(flank);
    let driven: Vec<_> = written
        .plan
        .lines
        .iter()
        .zip(&written.positions)
        .enumerate()
        .flat_map(|(number, (line, positions))| {
            let count = positions.len() as f64;
            positions
                .iter()
                .enumerate()
                .map(move |(k, (t, position))| (number as f64 + k as f64 / count, line.point(*t), *position))
        })
        .collect();
    let last = driven.len().checked_sub(1)?;
    let frames = WRITTEN_FRAMES.min(driven.len());
    let chosen = (0..frames).map(|k| k * last / (frames - 1).max(1));
    let frame = |k: usize| {
        let (at, (w, z), position) = &driven[k];
        let touched = [worm.point(*w, *z)];
        let contact = touched.as_slice().get(..usize::from(extent.holds(&touched[0]))).unwrap_or_default();
        dressing_frame(*at, position, ("dresser", 0.0), contact, parked)
    };
    Some(Stage {
        id: format!("dressing-{flank}"),
        title: format!("Writing the {flank} flank of the worm line by line"),
        coordinate: Coordinate { label: "lines", unit: "1" },
        frames: chosen.map(frame).collect(),
    })
}
