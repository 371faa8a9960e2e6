//! Generating grinding in the registry of processes.

use crate::catalogue::catalogue_of_job;
use crate::job::{Job, LoadedJob};
use crate::workflow::derived::of_grinding;
use crate::workflow::programs::{BodiesCheck, OnGrinding};
use crate::workflow::refusal::Evidence;
use crate::workflow::{
    CatalogueOutcome, DressingStudyOutcome, ExploreOutcome, FreeOutcome, JobOutcome, JobResult, Outcome,
    WormLifeOutcome,
};
use crate::workflow::{
    explore_job, plan_from_catalogue, plan_job, preview_job, rank_catalogue, simulate_job, study_dressing,
    study_free_worm, study_worm_life, try_changes,
};
use ::job::ProcessJob;
use foundation::numerics::Progress;
use job::Diagnostic;
use job::machine::LoadedMachine;
use run::program_check::ProgramCheck;
use run::{
    DerivedGeometry, DocumentFormat, JobFailure, Preview, Process, Remark, RunFailure, Task, TaskOutcome,
};

/// What carries out `inspect` for a job: measuring the simulated machine is the room of inspection, which stands above this one.
pub type InspectSimulated = fn(&LoadedJob, &dyn Progress) -> Result<Box<dyn TaskOutcome>, JobFailure>;

/// Generating grinding with a dressed worm.
pub struct GeneratingGrinding {
    /// How the simulated machine of a job is measured and corrected.
    pub inspect: InspectSimulated,
}

impl Process for GeneratingGrinding {
    type Job = Job;

    fn title(&self) -> &'static str {
        "Generating grinding"
    }

    fn tasks(&self) -> &'static [Task] {
        &Task::ALL
    }

    fn commands(&self) -> Vec<&'static str> {
        vec!["plan", "simulate", "explore", "inspect", "convert", "program check"]
    }

    fn documents(&self) -> Vec<DocumentFormat> {
        vec![
            DocumentFormat::of::<JobResult>(Job::NAME, "result.json"),
            DocumentFormat::of::<ExploreOutcome>("exploration", "explore.json"),
            DocumentFormat::of::<CatalogueOutcome>("catalogue", "explore.json"),
            DocumentFormat::of::<FreeOutcome>("free-worm", "explore.json"),
            DocumentFormat::of::<DressingStudyOutcome>("dressing-study", "explore.json"),
            DocumentFormat::of::<WormLifeOutcome>("worm-life", "explore.json"),
        ]
    }

    fn carry_out(
        &self,
        task: Task,
        loaded: &LoadedJob,
        progress: &dyn Progress,
    ) -> Result<Box<dyn TaskOutcome>, JobFailure> {
        match task {
            Task::Plan => plan(loaded, progress),
            Task::Simulate => Ok(with_job(loaded, simulate_job(loaded, progress)?)),
            Task::Explore => explore(loaded, progress),
            Task::Inspect => (self.inspect)(loaded, progress),
        }
    }

    fn derived(&self, loaded: &LoadedJob) -> Result<(DerivedGeometry, Vec<Remark>), JobFailure> {
        let catalogue = catalogue_of_job(loaded)?;
        Ok(of_grinding(loaded, catalogue.as_ref())?)
    }

    fn machine_file<'a>(&self, job: &'a Job) -> Option<&'a str> {
        job.machine.as_ref().map(|machine| machine.file.as_str())
    }

    fn tolerance_um(&self, job: &Job) -> Option<f64> {
        Some(job.target.tolerance_um)
    }

    fn has_preview(&self) -> bool {
        true
    }

    fn preview(&self, loaded: &LoadedJob) -> Option<Result<Preview, JobFailure>> {
        Some(preview_job(loaded).map_err(JobFailure::from))
    }

    fn program_check<'a>(
        &self,
        loaded: &'a LoadedJob,
        machine: &'a LoadedMachine,
        progress: &dyn Progress,
    ) -> Option<Result<Box<dyn ProgramCheck + 'a>, RunFailure>> {
        let made = OnGrinding::new(loaded, progress);
        Some(made.map(|bodies| Box::new(BodiesCheck { machine, bodies }) as Box<dyn ProgramCheck>))
    }

    fn evidence(&self, loaded: &LoadedJob, finding: &Diagnostic) -> Option<Box<dyn run::Evidence>> {
        Evidence::of_job(loaded, finding).map(|found| Box::new(found) as Box<dyn run::Evidence>)
    }
}

fn with_job(loaded: &LoadedJob, outcome: Outcome) -> Box<dyn TaskOutcome> {
    Box::new(JobOutcome { loaded: loaded.clone(), outcome })
}

fn plan(loaded: &LoadedJob, progress: &dyn Progress) -> Result<Box<dyn TaskOutcome>, JobFailure> {
    let Some(catalogue) = catalogue_of_job(loaded)? else {
        let mut outcome = plan_job(loaded, progress)?;
        try_changes(loaded, &mut outcome, progress);
        return Ok(with_job(loaded, outcome));
    };
    Ok(Box::new(plan_from_catalogue(loaded, &catalogue, progress)?))
}

fn explore(loaded: &LoadedJob, progress: &dyn Progress) -> Result<Box<dyn TaskOutcome>, JobFailure> {
    if let Some(catalogue) = catalogue_of_job(loaded)? {
        return Ok(if loaded.job.explore.is_some() {
            Box::new(study_free_worm(loaded, &catalogue, progress)?)
        } else {
            Box::new(rank_catalogue(loaded, &catalogue, progress)?)
        });
    }
    if loaded.job.explore.as_ref().is_some_and(|explore| explore.dressing.is_some()) {
        return Ok(Box::new(study_dressing(loaded, progress)?));
    }
    if let Some(study) = loaded.job.explore.as_ref().and_then(|explore| explore.worm_life) {
        return Ok(Box::new(study_worm_life(loaded, study, progress)?));
    }
    Ok(Box::new(explore_job(loaded, progress)?))
}
