//! Measuring a skiving tool in the registry of processes.

use crate::job::{LoadedSkivingJob, SkivingJob};
use crate::workflow::SkivingResult;
use crate::workflow::derived::of_skiving;
use crate::workflow::{SkivingCheck, run_skiving, simulate_skiving};
use ::job::ProcessJob;
use foundation::numerics::Progress;
use job::machine::LoadedMachine;
use run::program_check::ProgramCheck;
use run::{DerivedGeometry, DocumentFormat, JobFailure, Process, Remark, RunFailure, Task, TaskOutcome};

/// Measuring a skiving tool.
pub struct SkivingToolMeasuring;

impl Process for SkivingToolMeasuring {
    type Job = SkivingJob;

    fn title(&self) -> &'static str {
        "Measuring a skiving tool"
    }

    fn tasks(&self) -> &'static [Task] {
        &[Task::Plan, Task::Simulate]
    }

    fn documents(&self) -> Vec<DocumentFormat> {
        vec![DocumentFormat::of::<SkivingResult>(SkivingJob::NAME, "result.json")]
    }

    fn carry_out(
        &self,
        task: Task,
        loaded: &LoadedSkivingJob,
        progress: &dyn Progress,
    ) -> Result<Box<dyn TaskOutcome>, JobFailure> {
        let outcome = match task {
            Task::Simulate => simulate_skiving(loaded, progress)?,
            Task::Plan | Task::Explore | Task::Inspect => run_skiving(loaded, progress)?,
        };
        Ok(Box::new(outcome))
    }

    fn commands(&self) -> Vec<&'static str> {
        vec!["plan", "simulate", "inspect", "program check"]
    }

    fn derived(&self, loaded: &LoadedSkivingJob) -> Result<(DerivedGeometry, Vec<Remark>), JobFailure> {
        Ok((of_skiving(loaded)?, Vec::new()))
    }

    fn machine_file<'a>(&self, job: &'a SkivingJob) -> Option<&'a str> {
        job.machine.as_ref().map(|machine| machine.file.as_str())
    }

    fn tolerance_um(&self, job: &SkivingJob) -> Option<f64> {
        Some(job.target.tolerance_um)
    }

    fn program_check<'a>(
        &self,
        loaded: &'a LoadedSkivingJob,
        machine: &'a LoadedMachine,
        _: &dyn Progress,
    ) -> Option<Result<Box<dyn ProgramCheck + 'a>, RunFailure>> {
        Some(SkivingCheck::new(loaded, machine).map(|check| Box::new(check) as Box<dyn ProgramCheck>))
    }
}
