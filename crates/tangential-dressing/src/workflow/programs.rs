//! The programs of a run of tangential dressing: its passes as work for a machine, and its referee asked with motions from a text.

use crate::workflow::{
    DrivenMotions, TangentialPass, TangentialPrepared, TangentialRun, passes_of_runs, referee, worm_rays,
};
use crate::{TangentialFlank, TangentialStrokes};
use contact::{Lever, Measure};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::DressingMotion;
use foundation::numerics::{Silent, equidistant};
use generating_grinding::workflow::programs::clearance;
use generating_grinding::workflow::programs::indexing::Indexing;
use generating_grinding::workflow::programs::judge::{Judge, ReadBack, RunFlank};
use generating_grinding::workflow::programs::proof::THREAD_GRID;
use generating_grinding::workflow::programs::run_programs::RunPrograms;
use generating_grinding::workflow::programs::task::ProgramTask;
use generating_grinding::workflow::programs::work::{DressingWork, GrindingWork};
use machine::GearCoupling;
use metrology::Topography;
use motion::{ReadStroke, dresser_contacts};
use run::RunFailure;
use run::program_check::dialects;

/// Contacts looked at along the line in which the dresser touches a flank.
const CONTACTS: usize = 5;

/// Programs of a run that was prepared with a machine; `None` without one.
///
/// # Errors
/// [`RunFailure`]: a machine that cannot do it; programs that are not proven.
pub fn programs_of_tangential(
    ready: &TangentialPrepared,
    runs: &Sides<Option<TangentialRun>>,
) -> Result<Option<RunPrograms>, RunFailure> {
    let Some(machine) = &ready.machine else { return Ok(None) };
    let strokes = Strokes::new(ready, runs)?;
    let pair = &ready.model.pair;
    let gear = pair.work.data();
    let task = ProgramTask {
        job: &ready.info.name,
        machine,
        dialects: &dialects(&ready.output.programs, machine),
        technology: ready.technology.clone(),
        dressing: strokes.dressing.clone(),
        lines: Vec::new(),
        grinding: strokes.grinding.clone(),
        indexing: strokes.indexing.clone(),
        coupling: GearCoupling {
            threads: pair.worm.data().teeth.unsigned_abs(),
            teeth: gear.teeth,
            shift: pair.flanks.left.shift_coupling,
            feed: pair.flanks.left.feed_coupling,
            crossed_axes_angle: pair.chain.crossed_axes_angle,
        },
        areas: vec![0.0],
    };
    let judge = Rays { ready, runs, passes: &strokes.passes };
    let mut programs = RunPrograms::new(&task, ready.gives_feed, &flanks_of(runs), &judge)?;
    programs.result.clearance = clearance::check(&task, &programs.built)?;
    Ok(Some(programs))
}

/// The strokes of a run, pass by pass.
pub(super) struct Strokes {
    pub indexing: Indexing,
    pub passes: Vec<Vec<Flank>>,
    pub dressing: Vec<DressingWork>,
    pub grinding: Vec<GrindingWork>,
}

impl Strokes {
    pub fn new(ready: &TangentialPrepared, runs: &Sides<Option<TangentialRun>>) -> Result<Self, RunFailure> {
        let worm = ready.model.pair.worm.data();
        let mut strokes = Self {
            indexing: Indexing::new(worm.teeth.unsigned_abs(), ready.model.pair.work.data().teeth, None),
            passes: Vec::new(),
            dressing: Vec::new(),
            grinding: Vec::new(),
        };
        for pass in passes_of_runs(runs) {
            let (dressing, grinding) = work_of_pass(ready, &pass)?;
            strokes.passes.push(pass.flanks());
            strokes.dressing.push(dressing);
            strokes.grinding.push(grinding);
        }
        Ok(strokes)
    }
}

/// The flanks of a run: the referee's rays stand along the normals, deviations are in the measure of the job.
pub(super) fn flanks_of(runs: &Sides<Option<TangentialRun>>) -> Sides<Option<RunFlank>> {
    Sides::from_fn(|flank| {
        let run = runs[flank].as_ref()?;
        let deviation = run.simulated.minus(&run.target);
        Some(RunFlank { rays: run.refereed.verdict.simulated.clone(), deviation })
    })
}

/// The referee of a run.
pub(super) struct Rays<'a> {
    pub ready: &'a TangentialPrepared,
    pub runs: &'a Sides<Option<TangentialRun>>,
    pub passes: &'a [Vec<Flank>],
}

/// Motions of a pass over all that its flanks need.
fn work_of_pass(
    ready: &TangentialPrepared,
    of_pass: &TangentialPass<'_>,
) -> Result<(DressingWork, GrindingWork), RunFailure> {
    let first = of_pass.runs.first().zip(of_pass.ground(ready));
    let Some((&(first, run), flank)) = first else { return Err(RunFailure::no_settings()) };
    let pass = of_pass.flanks();
    let strokes = TangentialStrokes { dressing: of_pass.dressing(), feed: of_pass.feed(), ..run.strokes };
    let driven = DrivenMotions::of_flank(&flank, &strokes)?;
    let pair = &ready.model.pair;
    let sin_an = |flank: Flank| pair.work.data().pressure_angle[flank].sin();
    let per_distance = pass.iter().map(|&flank| sin_an(flank)).fold(0.0, f64::max);
    let arm = |flank: Flank| {
        let f = pair.work.flank(flank);
        f.base_radius * f.base_helix_angle.cos()
    };
    let shown = match pass.as_slice() {
        [only] => format!("{} FLANK", only.name().to_uppercase()),
        _ => "BOTH FLANKS".to_owned(),
    };
    let contacts = of_pass
        .runs
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
        phase: driven.grinding.phase[first],
        motion: driven.grinding,
        feeds: driven.feed,
        levers: Sides::from_fn(|flank| {
            pass.contains(&flank).then(|| Lever { sine: sin_an(flank), arm: arm(flank) })
        }),
    };
    Ok((dressing, grinding))
}

impl Judge for Rays<'_> {
    fn flanks(&self, read: &ReadBack, _: f64) -> Result<Sides<Option<Topography>>, RunFailure> {
        let mut flanks = Sides { left: None, right: None };
        for ((dressing, grinding), pass) in read.dressing.iter().zip(&read.grinding).zip(self.passes) {
            let driven = DrivenMotions {
                dressing: dressing.motion.clone(),
                shift_range: dressing.range,
                grinding: grinding.motion.clone(),
                feed: grinding.range,
            };
            for &flank in pass {
                let Some(run) = &self.runs[flank] else { continue };
                let bodies =
                    TangentialFlank::new(&self.ready.model, flank, pass, &run.settings, Measure::Ray);
                let refereed = referee(&bodies, &run.strokes, &driven, &run.target, &Silent)?;
                flanks[flank] = Some(refereed.verdict.simulated);
            }
        }
        Ok(flanks)
    }

    fn thread(
        &self,
        dressing: &[ReadStroke<DressingMotion>],
        _: f64,
    ) -> Result<Sides<Option<Vec<f64>>>, RunFailure> {
        let mut lengths = Sides { left: None, right: None };
        for (stroke, pass) in dressing.iter().zip(self.passes) {
            for &flank in pass {
                let Some(run) = &self.runs[flank] else { continue };
                let bodies =
                    TangentialFlank::new(&self.ready.model, flank, pass, &run.settings, Measure::Ray);
                let driven = (&stroke.motion, stroke.range);
                lengths[flank] = Some(worm_rays(&bodies, &run.strokes, driven, &run.target, THREAD_GRID)?);
            }
        }
        Ok(lengths)
    }
}
