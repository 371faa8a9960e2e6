//! Tangential dressing in the registry of processes.

use crate::job::{LoadedTangentialJob, TangentialJob};
use crate::workflow::derived::of_tangential;
use crate::workflow::followed::OnTangential;
use crate::workflow::previewed::preview_tangential;
use crate::workflow::{TangentialExploration, TangentialJobOutcome, TangentialResult};
use crate::workflow::{explore_tangential, plan_tangential, simulate_tangential};
use ::job::ProcessJob;
use foundation::numerics::Progress;
use generating_grinding::workflow::programs::BodiesCheck;
use job::machine::LoadedMachine;
use run::program_check::ProgramCheck;
use run::{
    DerivedGeometry, DocumentFormat, JobFailure, Preview, Process, Remark, RunFailure, Task, TaskOutcome,
};

/// Tangential dressing.
pub struct TangentialDressing;

impl Process for TangentialDressing {
    type Job = TangentialJob;

    fn title(&self) -> &'static str {
        "Tangential dressing"
    }

    fn tasks(&self) -> &'static [Task] {
        &[Task::Plan, Task::Simulate, Task::Explore]
    }

    fn documents(&self) -> Vec<DocumentFormat> {
        vec![
            DocumentFormat::of::<TangentialResult>(TangentialJob::NAME, "result.json"),
            DocumentFormat::of::<TangentialExploration>("tangential-exploration", "explore.json"),
        ]
    }

    fn carry_out(
        &self,
        task: Task,
        loaded: &LoadedTangentialJob,
        progress: &dyn Progress,
    ) -> Result<Box<dyn TaskOutcome>, JobFailure> {
        let outcome = match task {
            Task::Simulate => simulate_tangential(loaded, progress)?,
            Task::Explore => return Ok(Box::new(explore_tangential(loaded, progress)?)),
            Task::Plan | Task::Inspect => plan_tangential(loaded, progress)?,
        };
        Ok(Box::new(TangentialJobOutcome { loaded: loaded.clone(), outcome }))
    }

    fn commands(&self) -> Vec<&'static str> {
        vec!["plan", "simulate", "explore", "program check"]
    }

    fn derived(&self, loaded: &LoadedTangentialJob) -> Result<(DerivedGeometry, Vec<Remark>), JobFailure> {
        Ok((of_tangential(loaded)?, Vec::new()))
    }

    fn machine_file<'a>(&self, job: &'a TangentialJob) -> Option<&'a str> {
        job.machine.as_ref().map(|machine| machine.file.as_str())
    }

    fn tolerance_um(&self, job: &TangentialJob) -> Option<f64> {
        Some(job.target.tolerance_um)
    }

    fn has_preview(&self) -> bool {
        true
    }

    fn preview(&self, loaded: &LoadedTangentialJob) -> Option<Result<Preview, JobFailure>> {
        Some(preview_tangential(loaded).map_err(JobFailure::from))
    }

    fn program_check<'a>(
        &self,
        loaded: &'a LoadedTangentialJob,
        machine: &'a LoadedMachine,
        progress: &dyn Progress,
    ) -> Option<Result<Box<dyn ProgramCheck + 'a>, RunFailure>> {
        let made = OnTangential::new(loaded, progress);
        Some(made.map(|bodies| Box::new(BodiesCheck { machine, bodies }) as Box<dyn ProgramCheck>))
    }
}
