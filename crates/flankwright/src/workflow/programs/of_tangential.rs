//! The programs of a run of tangential dressing: its passes as work for a machine, and its referee asked with motions from a text.

use super::proof::ReadBack;
use super::run_programs::{RunPrograms, dialects};
use super::task::{DressingWork, GrindingWork, ProgramTask, machine_of_job};
use super::technology::Technology;
use crate::contact::Measure;
use crate::exchange::LoadedTangentialJob;
use crate::geometry::{Flank, Sides};
use crate::machine::GearCoupling;
use crate::metrology::Topography;
use crate::motion::dresser_contacts;
use crate::numerics::{Silent, equidistant, extremes};
use crate::process::tangential_dressing::TangentialFlank;
use crate::workflow::finding::RunFailure;
use crate::workflow::tangential::{DrivenMotions, TangentialPrepared, TangentialRun, referee};

/// Contacts looked at along the line in which the dresser touches a flank.
const CONTACTS: usize = 5;

/// Programs of a run whose job names a machine; `None` for one that names none.
///
/// # Errors
/// [`RunFailure`]: a machine that is none or cannot do it; programs that are not proven.
pub(in crate::workflow) fn programs_of_tangential(
    loaded: &LoadedTangentialJob,
    ready: &TangentialPrepared,
    runs: &Sides<Option<TangentialRun>>,
) -> Result<Option<RunPrograms>, RunFailure> {
    let job = &loaded.job;
    let Some(job_machine) = &job.machine else { return Ok(None) };
    let machine = machine_of_job(loaded, job_machine)?;
    let pair = &ready.model.pair;
    let worm = pair.worm.data();
    let hand = if worm.helix_angle < 0.0 { -1.0 } else { 1.0 };
    let sizes = (hand, ready.worm_tip_radius, worm.normal_module, job.worm.width);
    let technology = Technology::new(job_machine, sizes, job.grinding.feed_per_revolution);
    let mut passes: Vec<Vec<Flank>> = Vec::new();
    for (_, run) in runs.iter() {
        if let Some(run) = run
            && !passes.contains(&run.pass)
        {
            passes.push(run.pass.clone());
        }
    }
    let mut dressing = Vec::with_capacity(passes.len());
    let mut grinding = Vec::with_capacity(passes.len());
    for pass in &passes {
        let (dress, grind) = work_of_pass(ready, runs, pass)?;
        dressing.push(dress);
        grinding.push(grind);
    }
    let gear = pair.work.data();
    let task = ProgramTask {
        job: &job.job.name,
        machine: &machine,
        dialects: &dialects(&job.output.programs, &machine),
        technology,
        dressing,
        grinding,
        coupling: GearCoupling {
            threads: worm.teeth.unsigned_abs(),
            teeth: gear.teeth,
            shift: pair.flanks.left.shift_coupling,
            feed: pair.flanks.left.feed_coupling,
            crossed_axes_angle: pair.chain.crossed_axes_angle,
        },
        gear: [gear.normal_module, gear.helix_angle],
    };
    // The referee's rays stand along the normals, whatever the job measures along.
    let target = Sides::from_fn(|flank| runs[flank].as_ref().map(|run| run.target.clone()));
    let simulated =
        Sides::from_fn(|flank| runs[flank].as_ref().map(|run| run.refereed.verdict.simulated.clone()));
    let given = job.grinding.feed_per_revolution.is_some();
    RunPrograms::new(&task, given, &[target, simulated], |read| simulate(ready, runs, &passes, read))
        .map(Some)
}

/// Motions of a pass over all that its flanks need.
fn work_of_pass(
    ready: &TangentialPrepared,
    runs: &Sides<Option<TangentialRun>>,
    pass: &[Flank],
) -> Result<(DressingWork, GrindingWork), RunFailure> {
    let of_pass: Vec<(Flank, &TangentialRun)> =
        pass.iter().filter_map(|&flank| Some((flank, runs[flank].as_ref()?))).collect();
    let first = of_pass.first().map(|(flank, run)| {
        (TangentialFlank::new(&ready.model, *flank, pass, &run.settings, Measure::Ray), *run)
    });
    let Some((flank, run)) = first else { return Err(RunFailure::no_settings()) };
    let ends = |f: &dyn Fn(&TangentialRun) -> [f64; 2]| extremes(of_pass.iter().flat_map(|(_, run)| f(run)));
    let mut strokes = run.strokes.clone();
    strokes.dressing = ends(&|run| run.strokes.dressing);
    strokes.feed = ends(&|run| run.strokes.feed);
    let driven = DrivenMotions::of_flank(&flank, &strokes)?;
    let pair = &ready.model.pair;
    let sin_an = |flank: Flank| pair.work.data().pressure_angle[flank].sin();
    let per_distance = pass.iter().map(|&flank| sin_an(flank)).fold(0.0, f64::max);
    let per_turn = pass.iter().map(|&flank| {
        let f = pair.work.flank(flank);
        f.base_radius * f.base_helix_angle.cos()
    });
    let shown = match pass {
        [only] => format!("{} FLANK", only.name().to_uppercase()),
        _ => "BOTH FLANKS".to_owned(),
    };
    let contacts = of_pass
        .iter()
        .flat_map(|(flank, run)| {
            let rolls = equidistant(run.strokes.worm_rolls, CONTACTS);
            dresser_contacts(pair.worm.flank(*flank), driven.dressing.chain.worm_angle, &rolls)
        })
        .collect();
    let dressing = DressingWork {
        name: format!("DRESSING {shown}"),
        motion: driven.dressing,
        interval: driven.shift_range,
        contacts,
        per_distance,
    };
    let grinding = GrindingWork {
        name: format!("GRINDING {shown}"),
        phase: driven.grinding.phase[pass[0]],
        motion: driven.grinding,
        feeds: driven.feed,
        per_turn: per_turn.fold(0.0, f64::max),
        per_distance,
    };
    Ok((dressing, grinding))
}

/// The referee's flanks with the motions of the texts in place of those of the run.
fn simulate(
    ready: &TangentialPrepared,
    runs: &Sides<Option<TangentialRun>>,
    passes: &[Vec<Flank>],
    read: &ReadBack,
) -> Result<Sides<Option<Topography>>, RunFailure> {
    let mut flanks = Sides { left: None, right: None };
    for ((dressing, grinding), pass) in read.dressing.iter().zip(&read.grinding).zip(passes) {
        let driven = DrivenMotions {
            dressing: dressing.motion.clone(),
            shift_range: dressing.range,
            grinding: grinding.motion.clone(),
            feed: grinding.range,
        };
        for &flank in pass {
            let Some(run) = &runs[flank] else { continue };
            let bodies = TangentialFlank::new(&ready.model, flank, pass, &run.settings, Measure::Ray);
            let refereed = referee(&bodies, &run.strokes, &driven, &run.target, &Silent)?;
            flanks[flank] = Some(refereed.verdict.simulated);
        }
    }
    Ok(flanks)
}
