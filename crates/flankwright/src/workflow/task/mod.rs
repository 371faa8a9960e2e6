//! A task on a job of any process, carried out whole: for callers that treat all processes alike, such as a server. A caller
//! that prints or plots what is special to a process calls that process itself.

mod completed;

pub use completed::Completed;

use super::finding::{JobFailure, RunFailure};
use super::gearbox::run_gearbox;
use super::inspection::inspect_simulated;
use super::milling::run_milling;
use super::skiving::{run_skiving, simulate_skiving};
use super::tangential::{plan_tangential, simulate_tangential};
use super::{
    explore_job, plan_from_catalogue, plan_job, rank_catalogue, simulate_job, study_dressing, study_free_worm,
};
use crate::exchange::catalogue::catalogue_of_job;
use crate::exchange::{AnyJob, Diagnostic, LoadedJob, Problem};
use crate::numerics::Progress;

/// What is to be done with a job.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Task {
    /// From the target to settings, motions and a proven flank; a job of the electronic gearbox is run.
    Plan,
    /// From settings to the flank.
    Simulate,
    /// What varies side by side, ranked.
    Explore,
    /// The simulated machine of the job, measured and corrected.
    Inspect,
}

impl Task {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Plan, Self::Simulate, Self::Explore, Self::Inspect];

    /// Its word, that of the command.
    pub fn name(self) -> &'static str {
        match self {
            Self::Plan => "plan",
            Self::Simulate => "simulate",
            Self::Explore => "explore",
            Self::Inspect => "inspect",
        }
    }
}

/// Carries a task out.
///
/// # Errors
/// [`JobFailure`]: a job or a file that it names is at fault, the process has no such task, or the bodies cannot make the target. A target
/// that is missed is no error.
pub fn carry_out(task: Task, job: &AnyJob, progress: &dyn Progress) -> Result<Completed, JobFailure> {
    Ok(match (task, job) {
        (Task::Plan, AnyJob::Grinding(loaded)) => return plan_grinding(loaded, progress),
        (Task::Plan, AnyJob::Tangential(loaded)) => {
            Completed::Tangential(loaded.clone(), Box::new(plan_tangential(loaded, progress)?))
        }
        (Task::Plan, AnyJob::Milling(loaded)) => {
            Completed::Milling(loaded.clone(), Box::new(run_milling(loaded, progress)?))
        }
        (Task::Plan, AnyJob::Skiving(loaded)) => {
            Completed::Skiving(loaded.clone(), Box::new(run_skiving(loaded, progress)?))
        }
        (Task::Plan, AnyJob::Gearbox(loaded)) => {
            Completed::Gearbox(loaded.clone(), Box::new(run_gearbox(loaded, progress)?))
        }
        (Task::Simulate, AnyJob::Grinding(loaded)) => {
            Completed::Grinding(loaded.clone(), Box::new(simulate_job(loaded, progress)?), None)
        }
        (Task::Simulate, AnyJob::Tangential(loaded)) => {
            Completed::Tangential(loaded.clone(), Box::new(simulate_tangential(loaded, progress)?))
        }
        (Task::Simulate, AnyJob::Skiving(loaded)) => {
            Completed::Skiving(loaded.clone(), Box::new(simulate_skiving(loaded, progress)?))
        }
        (Task::Explore, AnyJob::Grinding(loaded)) => return explore_grinding(loaded, progress),
        (Task::Inspect, AnyJob::Grinding(loaded)) => {
            Completed::Inspection(Box::new(inspect_simulated(loaded, None, progress)?))
        }
        (task, other) => return Err(RunFailure::bad_input(no_such_task(task, other)).into()),
    })
}

fn plan_grinding(loaded: &LoadedJob, progress: &dyn Progress) -> Result<Completed, JobFailure> {
    let Some(catalogue) = catalogue_of_job(loaded)? else {
        return Ok(Completed::Grinding(loaded.clone(), Box::new(plan_job(loaded, progress)?), None));
    };
    let plan = plan_from_catalogue(loaded, &catalogue, progress)?;
    let (variant, outcome) = plan.planned?;
    Ok(Completed::Grinding(variant, outcome, Some(Box::new(plan.ranking))))
}

fn explore_grinding(loaded: &LoadedJob, progress: &dyn Progress) -> Result<Completed, JobFailure> {
    if let Some(catalogue) = catalogue_of_job(loaded)? {
        return Ok(if loaded.job.explore.is_some() {
            Completed::FreeWorm(Box::new(study_free_worm(loaded, &catalogue, progress)?))
        } else {
            Completed::Catalogue(Box::new(rank_catalogue(loaded, &catalogue, progress)?))
        });
    }
    if loaded.job.explore.as_ref().is_some_and(|explore| explore.dressing.is_some()) {
        return Ok(Completed::DressingStudy(Box::new(study_dressing(loaded, progress)?)));
    }
    Ok(Completed::Exploration(Box::new(explore_job(loaded, progress)?)))
}

fn no_such_task(task: Task, job: &AnyJob) -> Diagnostic {
    let (name, process) = (task.name(), job.info().process);
    let message = format!("`{name}` does not take a job of the process \"{}\"", process.name());
    Diagnostic::new(Problem::ProcessNotAvailable, message)
        .field("job.process")
        .value(format!("\"{}\"", process.name()))
        .allowed(match task {
            Task::Simulate => "\"generating-grinding\", \"tangential-dressing\", \"skiving-tool-measuring\"",
            _ => "\"generating-grinding\"",
        })
        .way_out("plan the job instead; its report compares what can be compared")
}
