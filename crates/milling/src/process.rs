//! Five-axis milling in the registry of processes.

use crate::job::{LoadedMillingJob, MillingJob};
use crate::workflow::MillingResult;
use crate::workflow::derived::of_milling;
use crate::workflow::{MillingCheck, run_milling};
use ::job::ProcessJob;
use foundation::numerics::Progress;
use job::machine::LoadedMachine;
use run::program_check::ProgramCheck;
use run::{DerivedGeometry, DocumentFormat, JobFailure, Process, Remark, RunFailure, Task, TaskOutcome};

/// Five-axis milling.
pub struct FiveAxisMilling;

impl Process for FiveAxisMilling {
    type Job = MillingJob;

    fn title(&self) -> &'static str {
        "Five-axis milling"
    }

    fn tasks(&self) -> &'static [Task] {
        &[Task::Plan]
    }

    fn documents(&self) -> Vec<DocumentFormat> {
        vec![DocumentFormat::of::<MillingResult>(MillingJob::NAME, "result.json")]
    }

    fn carry_out(
        &self,
        task: Task,
        loaded: &LoadedMillingJob,
        progress: &dyn Progress,
    ) -> Result<Box<dyn TaskOutcome>, JobFailure> {
        debug_assert_eq!(task, Task::Plan);
        Ok(Box::new(run_milling(loaded, progress)?))
    }

    fn commands(&self) -> Vec<&'static str> {
        vec!["plan", "program check"]
    }

    fn derived(&self, loaded: &LoadedMillingJob) -> Result<(DerivedGeometry, Vec<Remark>), JobFailure> {
        Ok((of_milling(loaded)?, Vec::new()))
    }

    fn machine_file<'a>(&self, job: &'a MillingJob) -> Option<&'a str> {
        job.machine.as_ref().map(|machine| machine.file.as_str())
    }

    fn tolerance_um(&self, job: &MillingJob) -> Option<f64> {
        Some(job.target.tolerance_um)
    }

    fn program_check<'a>(
        &self,
        loaded: &'a LoadedMillingJob,
        machine: &'a LoadedMachine,
        progress: &dyn Progress,
    ) -> Option<Result<Box<dyn ProgramCheck + 'a>, RunFailure>> {
        Some(
            MillingCheck::new(loaded, machine, progress)
                .map(|check| Box::new(check) as Box<dyn ProgramCheck>),
        )
    }
}
