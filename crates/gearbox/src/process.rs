//! Electronic gearbox in the registry of processes.

use crate::job::{GearboxJob, LoadedGearboxJob};
use crate::workflow::GearboxResult;
use crate::workflow::derived::of_gearbox;
use crate::workflow::run_gearbox;
use ::job::ProcessJob;
use foundation::numerics::Progress;
use run::{DerivedGeometry, DocumentFormat, JobFailure, Process, Remark, Task, TaskOutcome};

/// Electronic gearbox.
pub struct ElectronicGearbox;

impl Process for ElectronicGearbox {
    type Job = GearboxJob;

    fn title(&self) -> &'static str {
        "Electronic gearbox"
    }

    fn tasks(&self) -> &'static [Task] {
        &[Task::Plan]
    }

    fn documents(&self) -> Vec<DocumentFormat> {
        vec![DocumentFormat::of::<GearboxResult>(GearboxJob::NAME, "result.json")]
    }

    fn carry_out(
        &self,
        task: Task,
        loaded: &LoadedGearboxJob,
        progress: &dyn Progress,
    ) -> Result<Box<dyn TaskOutcome>, JobFailure> {
        debug_assert_eq!(task, Task::Plan);
        Ok(Box::new(run_gearbox(loaded, progress)?))
    }

    /// A gearbox is run, not planned: its command is one of its own.
    fn commands(&self) -> Vec<&'static str> {
        vec!["gearbox"]
    }

    fn instead(&self, command: &str) -> &'static str {
        match command {
            "explore" => "run `flankwright gearbox FILE`, which carries out its table [explore] as well",
            _ => "run `flankwright gearbox FILE`",
        }
    }

    fn derived(&self, loaded: &LoadedGearboxJob) -> Result<(DerivedGeometry, Vec<Remark>), JobFailure> {
        Ok((of_gearbox(loaded)?, Vec::new()))
    }
}
