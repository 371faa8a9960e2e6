//! The programs of a run of tangential dressing: its passes as work for a machine, and its referee asked with motions from a text.

use super::technology::technology;
use crate::job::{LoadedTangentialJob, TangentialJob};
use crate::workflow::{
    DrivenMotions, TangentialOutcome, TangentialPass, TangentialPrepared, TangentialRun, passes_of_runs,
    plan_tangential, referee, simulate_tangential, worm_rays,
};
use crate::{TangentialFlank, TangentialStrokes};
use contact::Measure;
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::DressingMotion;
use foundation::numerics::{Progress, Silent, equidistant};
use generating_grinding::workflow::programs::follow::{Followed, follow};
use generating_grinding::workflow::programs::indexing::Indexing;
use generating_grinding::workflow::programs::proof::{Judge, ReadBack, RunFlank, Sought, THREAD_GRID};
use generating_grinding::workflow::programs::run_programs::RunPrograms;
use generating_grinding::workflow::programs::task::{DressingWork, GrindingWork, ProgramTask};
use generating_grinding::workflow::programs::technology::Technology;
use generating_grinding::workflow::programs::{FollowedBodies, clearance};
use job::tables::Machine as JobMachine;
use machine::{GearCoupling, Machine};
use metrology::Topography;
use motion::{ReadStroke, Tracked, dresser_contacts};
use run::RunFailure;
use run::program_check::{dialects, machine_of_job};

/// The worm is one area.
const ONE_AREA: [f64; 1] = [0.0];
/// Contacts looked at along the line in which the dresser touches a flank.
const CONTACTS: usize = 5;

/// Programs of a run whose job names a machine; `None` for one that names none.
///
/// # Errors
/// [`RunFailure`]: a machine that is none or cannot do it; programs that are not proven.
pub fn programs_of_tangential(
    loaded: &LoadedTangentialJob,
    ready: &TangentialPrepared,
    runs: &Sides<Option<TangentialRun>>,
) -> Result<Option<RunPrograms>, RunFailure> {
    let job = &loaded.job;
    let Some(job_machine) = &job.machine else { return Ok(None) };
    let machine = machine_of_job(&loaded.document, &job_machine.file)?;
    let strokes = Strokes::new(job, job_machine, ready, runs)?;
    let pair = &ready.model.pair;
    let gear = pair.work.data();
    let task = ProgramTask {
        job: &job.job.name,
        machine: &machine,
        dialects: &dialects(&job.output.programs, &machine),
        technology: strokes.technology.clone(),
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
    let given = job.grinding.feed_per_revolution.is_some();
    let judge = Rays { ready, runs, passes: &strokes.passes };
    let mut programs = RunPrograms::new(&task, given, &flanks_of(runs), &judge)?;
    programs.result.clearance = clearance::check(&task, &programs.built)?;
    Ok(Some(programs))
}

/// The strokes of a run, pass by pass.
struct Strokes {
    technology: Technology,
    indexing: Indexing,
    passes: Vec<Vec<Flank>>,
    dressing: Vec<DressingWork>,
    grinding: Vec<GrindingWork>,
}

impl Strokes {
    fn new(
        job: &TangentialJob,
        machine: &JobMachine,
        ready: &TangentialPrepared,
        runs: &Sides<Option<TangentialRun>>,
    ) -> Result<Self, RunFailure> {
        let worm = ready.model.pair.worm.data();
        let technology =
            technology(machine, ready, job).with_dresser(0.5 * job.dresser.tip_diameter, worm.normal_module);
        let mut strokes = Self {
            technology,
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
fn flanks_of(runs: &Sides<Option<TangentialRun>>) -> Sides<Option<RunFlank>> {
    Sides::from_fn(|flank| {
        let run = runs[flank].as_ref()?;
        let deviation = run.simulated.minus(&run.target);
        Some(RunFlank { rays: run.refereed.verdict.simulated.clone(), deviation })
    })
}

/// The referee of a run.
struct Rays<'a> {
    ready: &'a TangentialPrepared,
    runs: &'a Sides<Option<TangentialRun>>,
    passes: &'a [Vec<Flank>],
}

/// The run of a job with its strokes, for programs to be followed on its bodies.
pub struct OnTangential {
    run: TangentialOutcome,
    strokes: Strokes,
    tolerance_um: f64,
}

impl OnTangential {
    /// Its own run, by its settings if it has some.
    ///
    /// # Errors
    /// Those of the run.
    pub fn new(loaded: &LoadedTangentialJob, progress: &dyn Progress) -> Result<Self, RunFailure> {
        let mut plain = loaded.clone();
        plain.job.machine = None;
        let run = if plain.job.settings.is_some() {
            simulate_tangential(&plain, progress)?
        } else {
            plan_tangential(&plain, progress)?
        };
        let clamped = loaded.job.machine.clone().unwrap_or_default();
        let strokes = Strokes::new(&loaded.job, &clamped, &run.prepared, &run.flanks)?;
        Ok(Self { run, strokes, tolerance_um: loaded.job.target.tolerance_um })
    }

    /// How the job clamps its bodies.
    pub fn technology(&self) -> &Technology {
        &self.strokes.technology
    }

    /// Follows a program and says what it makes of the flanks.
    ///
    /// # Errors
    /// Those of [`follow`].
    pub fn follow(&self, machine: &Machine, tracked: &Tracked) -> Result<Followed, RunFailure> {
        let Self { run, strokes, tolerance_um } = self;
        let sought = Sought {
            machine,
            technology: &strokes.technology,
            indexing: &strokes.indexing,
            areas: &ONE_AREA,
            dressing: strokes.dressing.iter().collect(),
            grinding: strokes.grinding.iter().collect(),
        };
        let judge = Rays { ready: &run.prepared, runs: &run.flanks, passes: &strokes.passes };
        follow(tracked, &sought, &flanks_of(&run.flanks), *tolerance_um, &judge)
    }
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
    let per_turn = pass.iter().map(|&flank| {
        let f = pair.work.flank(flank);
        f.base_radius * f.base_helix_angle.cos()
    });
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
        per_turn: per_turn.fold(0.0, f64::max),
        per_distance,
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

impl FollowedBodies for OnTangential {
    fn follow(&self, machine: &Machine, tracked: &Tracked) -> Result<Followed, RunFailure> {
        OnTangential::follow(self, machine, tracked)
    }

    fn technology(&self) -> &Technology {
        OnTangential::technology(self)
    }
}
