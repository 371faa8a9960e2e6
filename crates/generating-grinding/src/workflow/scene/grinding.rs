//! The scene of generating grinding: gear, worm and dresser; the worm dressed flank by flank, then the gear ground. Knows no file.

use super::dressing::{Parked, WormExtent, parked_dresser};
use super::generating::{ShownFlank, ShownGenerating, Solver};
use super::strokes::{dressers, strokes_of};
use super::written::written_stage;
use crate::workflow::execution::{ExecutedFlank, ExecutedTool};
use crate::workflow::run::Outcome;
use contact::{ExactContact, ModifiedThread, Pair, ToolSurface, Unmodified};
use dressing::DressedWorm;
use foundation::geometry::{Blank, Flank, Sides};
use foundation::kinematics::GeneratingMotion;
use run::{RunFailure, finished, unmeshed};
use scene::toothed::Toothed;
use scene::{Body, BodyKind, Scene, Stage};

/// Gear, worm and dresser of a run, and its strokes: one stage for each dressing motion, one for grinding.
///
/// # Errors
/// [`RunFailure`] for bodies that cannot be meshed and motions without numbers.
pub fn scene_of_grinding(outcome: &Outcome) -> Result<Scene, RunFailure> {
    let setup = &outcome.prepared.setup;
    let execution = &outcome.execution;
    let faces = worm_faces(outcome);
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
    let solvers: Vec<Solver<'_>> = flanks
        .iter()
        .map(|&(flank, executed)| solver(outcome, pair, &execution.motion, flank, executed))
        .collect();
    let shown = flanks.iter().zip(&solvers).map(|(&(flank, _), solve)| ShownFlank {
        flank,
        roll: setup.fields[flank].roll(),
        face: setup.fields[flank].face(),
        solve,
    });
    let grinding = ShownGenerating {
        id: "grinding".into(),
        title: "Grinding the gear".into(),
        pair,
        motion: &execution.motion,
        feed: execution.feed_range,
        flanks: shown.collect(),
    };

    let dressers = dressers(outcome)?;
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
            (Some(stroke), _) => Some(stroke.begin()),
            (None, Sides { left, right }) => {
                left.iter().chain(right).find_map(|w| Some(w.positions.first()?.first()?.1))
            }
        };
        aside.extend(position.map(|position| (dresser.body.id.clone(), parked_dresser(&position, depth))));
    }
    let beside_dressing: Vec<Parked> = std::iter::once(gear).chain(aside.iter().cloned()).collect();
    let mut stages: Vec<Stage> =
        strokes.iter().map(|stroke| stroke.stage(&extent, &beside_dressing)).collect();
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
pub fn gear_and_worm(
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
fn worm_faces(outcome: &Outcome) -> [f64; 2] {
    let [from, to] = outcome.execution.occupation;
    let run_in = outcome.prepared.setup.run_in();
    match outcome.prepared.setup.input.worm_width {
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
) -> Solver<'a> {
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
) -> Solver<'a> {
    Box::new(move |w, z| ExactContact::new(pair, flank, motion, &surface).solve(w, z).ok())
}
