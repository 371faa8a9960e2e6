//! The scene of grinding with a worm that is dressed tangentially: a stage for every dressed flank, then one for every pass of
//! grinding. Knows no file.

use crate::workflow::{TangentialOutcome, TangentialRun};
use crate::{TangentialFlank, TangentialModel};
use contact::Measure;
use foundation::geometry::{Flank, Revolution};
use foundation::numerics::{equidistant, extremes};
use generating_grinding::workflow::scene::disc::profiled_disc;
use generating_grinding::workflow::scene::dressing::{
    Parked, WORM_POSITION, WormExtent, dressing_frame, dressing_frames, parked_dresser,
};
use generating_grinding::workflow::scene::generating::{ShownFlank, ShownGenerating, Solver};
use generating_grinding::workflow::scene::grinding::gear_and_worm;
use nalgebra::Vector3;
use run::{RunFailure, finished, unmeshed};
use scene::{Body, BodyKind, Scene, Stage};

/// Points of the line in which dresser and worm touch.
const LINE: usize = 25;
/// The worm goes on beyond what is used by this share of its normal module at each end, where none is given.
const BESIDE: f64 = 1.5;
/// Depth of the worm's spaces below its pitch cylinder, in normal modules: the dresser's reach.
const DEDENDUM: f64 = 1.5;

/// A flank of the run with its motions.
struct Driven<'a> {
    flank: Flank,
    run: &'a TangentialRun,
    ground: TangentialFlank<'a>,
}

/// Gear, worm and dresser of a run, and its strokes: one stage for each dressed flank, one for each pass of grinding.
///
/// # Errors
/// [`RunFailure`] for bodies that cannot be meshed, a run without flanks, and motions without numbers.
pub fn scene_of_tangential(outcome: &TangentialOutcome) -> Result<Scene, RunFailure> {
    let ready = &outcome.prepared;
    let model = &ready.model;
    let driven: Vec<Driven<'_>> = Flank::BOTH
        .into_iter()
        .filter_map(|flank| {
            let run = outcome.flanks[flank].as_ref()?;
            let ground = TangentialFlank::new(model, flank, &run.pass, &run.settings, Measure::Ray);
            Some(Driven { flank, run, ground })
        })
        .collect();
    let pitch = model.pair.worm.pitch_radius();
    let module = model.pair.work.data().normal_module;
    let radii = [pitch - DEDENDUM * module, ready.worm_tip_radius];
    let used = extremes(driven.iter().flat_map(|d| d.run.strokes.worm_faces));
    let beside = BESIDE * module;
    let faces = match ready.worm_width {
        Some(width) => [-0.5 * width, 0.5 * width],
        None => [used[0] - beside, used[1] + beside],
    };
    let extent = WormExtent { radii, slope: 0.0, faces };
    let mut bodies = gear_and_worm(&model.pair, &ready.blank, radii, faces)?;
    bodies.push(dresser(outcome, &driven)?);

    let solvers: Vec<Solver<'_>> =
        driven.iter().map(|d| -> Solver<'_> { Box::new(move |w, z| d.ground.contact_at(w, z)) }).collect();
    let mut passes = Vec::new();
    for (number, pass) in ready.passes.iter().enumerate() {
        let of_pass: Vec<usize> = (0..driven.len()).filter(|&k| pass.contains(&driven[k].flank)).collect();
        let Some(&first) = of_pass.first() else { continue };
        let shown = of_pass.iter().map(|&k| ShownFlank {
            flank: driven[k].flank,
            roll: model.rolls(driven[k].flank),
            face: model.input().faces,
            solve: &solvers[k],
        });
        let names: Vec<&str> = of_pass.iter().map(|&k| driven[k].flank.name()).collect();
        let alone = ready.passes.len() == 1;
        passes.push(ShownGenerating {
            id: if alone { "grinding".into() } else { format!("grinding-{}", number + 1) },
            title: if alone {
                "Grinding the gear".into()
            } else {
                format!("Grinding the gear: {}", names.join(" and "))
            },
            pair: &model.pair,
            motion: driven[first].ground.motion(),
            feed: extremes(of_pass.iter().flat_map(|&k| driven[k].run.strokes.feed)),
            flanks: shown.collect(),
        });
    }
    let depth = radii[1] - radii[0];
    let gear: Vec<Parked> =
        passes.first().map(|pass| ("gear".to_owned(), pass.parked_gear(depth))).into_iter().collect();
    let first = driven.first().map(|d| d.ground.dressing_row(d.run.strokes.dressing[0]).stand());
    let aside: Vec<Parked> =
        first.map(|stand| ("dresser".to_owned(), parked_dresser(&stand, depth))).into_iter().collect();
    let mut stages: Vec<Stage> = driven.iter().map(|d| dressing(model, d, &extent, &gear)).collect();
    stages.extend(passes.iter().map(|pass| pass.stage(&aside)));
    finished(Scene { bodies, stages })
}

/// The dresser: both of its sides as they are, the other one plain where only one is used.
fn dresser(outcome: &TangentialOutcome, driven: &[Driven<'_>]) -> Result<Body, RunFailure> {
    let model = &outcome.prepared.model;
    let side = |flank: Flank| -> Revolution {
        match driven.iter().find(|d| d.flank == flank) {
            Some(d) => d.ground.dresser(),
            None => TangentialFlank::new(model, flank, &[flank], &Default::default(), Measure::Ray).dresser(),
        }
    };
    let sides = [side(Flank::Left), side(Flank::Right)];
    let [low, high] = model.dresser_heights();
    // A profile with a spline ends where the spline does.
    let from = sides.iter().map(|s| s.interval().0).fold(low, f64::max);
    let to = sides.iter().map(|s| s.interval().1).fold(high, f64::min);
    let mesh = profiled_disc([&sides[0], &sides[1]], [from, to]).map_err(|e| unmeshed("dresser", &e))?;
    Ok(Body::new("dresser", BodyKind::Dresser, true, &mesh))
}

/// The stage in which a flank is dressed: frames over the dresser's position, ascending in the worm's.
fn dressing(model: &TangentialModel, driven: &Driven<'_>, extent: &WormExtent, parked: &[Parked]) -> Stage {
    let (heights, screw_parameter) = (model.dresser_heights(), model.chain.screw_parameter);
    let Driven { flank, run, ground } = driven;
    let positions = run.strokes.dressing;
    let ends = positions.map(|x| ground.dressing_row(x).worm_shift);
    // The axis of the worm goes against x_D.
    let order = if ends[0] <= ends[1] { positions } else { [positions[1], positions[0]] };
    let count = dressing_frames(ends, screw_parameter);
    let frame = |x_d: f64| {
        let row = ground.dressing_row(x_d);
        let points = equidistant(heights, LINE).into_iter().filter_map(|s| ground.worm_point(s, x_d));
        let contact: Vec<Vector3<f64>> = points.filter(|point| extent.holds(point)).collect();
        dressing_frame(row.worm_shift, &row.stand(), ("dresser", 0.0), &contact, parked)
    };
    Stage {
        id: format!("dressing-{flank}"),
        title: format!("Dressing the {flank} flank of the worm"),
        coordinate: WORM_POSITION,
        frames: equidistant(order, count).into_iter().map(frame).collect(),
    }
}
