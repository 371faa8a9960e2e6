//! The registry of processes: a line for each. Command, server, Python, schema, templates and examples ask it.

use foundation::numerics::Progress;
use generating_grinding::GeneratingGrinding;
use generating_grinding::job::LoadedJob;
use inspection::workflow::inspect_simulated;
use run::{AnyProcess, JobFailure, Processes, TaskOutcome};
use std::sync::{Mutex, OnceLock, PoisonError};
use thiserror::Error;

static ADDED: Mutex<Vec<Box<dyn AnyProcess>>> = Mutex::new(Vec::new());
static ALL: OnceLock<Processes> = OnceLock::new();

/// The processes of this project, in the order in which they are listed; a job that names none is taken for one of the first.
fn own() -> Vec<Box<dyn AnyProcess>> {
    vec![
        Box::new(GeneratingGrinding { inspect: inspect_as_task }),
        Box::new(tangential_dressing::TangentialDressing),
        Box::new(gearbox::ElectronicGearbox),
        Box::new(milling::FiveAxisMilling),
        Box::new(skiving::SkivingToolMeasuring),
    ]
}

fn inspect_as_task(job: &LoadedJob, progress: &dyn Progress) -> Result<Box<dyn TaskOutcome>, JobFailure> {
    Ok(Box::new(inspect_simulated(job, None, progress)?))
}

/// All processes: those of this project, then those that were added.
pub fn processes() -> &'static Processes {
    ALL.get_or_init(|| {
        let mut all = own();
        all.append(&mut ADDED.lock().unwrap_or_else(PoisonError::into_inner));
        Processes::new(all)
    })
}

/// The registry was asked already: what it said would no longer hold.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[error("processes are added before the first job is read")]
pub struct TooLate;

/// Adds a process, for programs that bring their own; before anything else is asked of the registry.
///
/// # Errors
/// [`TooLate`] once the registry was asked.
pub fn add_process(process: impl AnyProcess + 'static) -> Result<(), TooLate> {
    let mut added = ADDED.lock().unwrap_or_else(PoisonError::into_inner);
    if ALL.get().is_some() {
        return Err(TooLate);
    }
    added.push(Box::new(process));
    Ok(())
}
