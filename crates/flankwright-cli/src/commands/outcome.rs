//! What commands do with a task: carry it out, write its files, print its summary, tell by the exit status how it ended. The same for every
//! process.

use std::path::{Path, PathBuf};

use flankwright::exchange::AnyJob;
use flankwright::processes;
use flankwright::workflow::{
    Conclusion, JobFailure, RunFailure, Task, TaskOutcome, WriteError, write_refusal,
};

use crate::common_arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;
use crate::progress::Bars;

/// Rows of a ranking that are printed where the command has no say in it.
pub const ROWS: usize = 20;

/// Carries a task out on a job for the command of that name, writes its files and prints its summary; `rows` of a ranking.
///
/// # Errors
/// A process that the command does not take; everything that is wrong with the job, a target that these bodies cannot make, files that
/// cannot be written.
pub fn run(
    command: &str,
    task: Task,
    job: &AnyJob,
    common: &CommonArguments,
    rows: usize,
) -> Result<Exit, Failure> {
    if !processes().of(job).is_ok_and(|process| process.commands().contains(&command)) {
        return Err(output::refused(job, command));
    }
    let bars = Bars::new(common.quiet);
    let done = processes().carry_out(task, job, &bars);
    bars.finish();
    deliver(task, job, common, rows, done)
}

/// Writes the files of a task and prints its summary.
///
/// # Errors
/// A task that failed; files that cannot be written.
pub fn deliver(
    task: Task,
    job: &AnyJob,
    common: &CommonArguments,
    rows: usize,
    done: Result<Box<dyn TaskOutcome>, JobFailure>,
) -> Result<Exit, Failure> {
    let document = job.document();
    // A study may be repeated over the results of another one; a run has a folder of its own.
    let (directory, owned) = match task {
        Task::Explore => (output::directory(common, document, job.info()), false),
        _ => (output::own_directory(common, document, job.info())?, true),
    };
    let outcome = match done {
        Ok(outcome) => outcome,
        Err(JobFailure::Job(failure)) if owned => return Err(refuse(job, failure, &directory)),
        Err(failure) => return Err(Failure::of_job_or_file(document, failure)),
    };
    let written = outcome.write(&directory).map_err(unwritten)?;
    if owned {
        output::note_owner(common, document, &directory)?;
    }
    match outcome.refusal() {
        Some(refusal) => Err(refuse(job, refusal.clone(), &directory)),
        None => conclude(common, &*outcome, rows, &written),
    }
}

/// Writes what a refusal of the bodies hands over and makes the failure of it.
pub fn refuse(job: &AnyJob, failure: RunFailure, directory: &Path) -> Failure {
    let report = match &failure {
        RunFailure::NotProducible(finding) => match write_refusal(job, finding, directory) {
            Ok(written) => written.last().cloned(),
            Err(error) => return unwritten(error),
        },
        RunFailure::BadInput(_) => None,
    };
    Failure { report, ..Failure::of_run(job.document(), failure) }
}

/// Prints what the arguments ask for; the exit status says whether the target is met.
///
/// # Errors
/// Standard output cannot be written.
pub fn conclude(
    common: &CommonArguments,
    outcome: &dyn TaskOutcome,
    rows: usize,
    written: &[PathBuf],
) -> Result<Exit, Failure> {
    if common.json {
        output::print_json(outcome.result())?;
    } else if !common.quiet {
        output::print(&outcome.summary(written, rows))?;
    }
    if common.quiet
        && let Some(complaint) = outcome.complaint()
    {
        // A miss is printed even when all else is quiet.
        eprintln!("{complaint}");
    }
    Ok(match outcome.conclusion() {
        Conclusion::Done => Exit::Done,
        Conclusion::Missed => Exit::TargetMissed,
        Conclusion::NotProducible => Exit::NotProducible,
    })
}

/// Files that cannot be written.
pub fn unwritten(error: WriteError) -> Failure {
    match error {
        WriteError::Io { path, source } => Failure::cannot_write(&path.display().to_string(), &source),
        WriteError::Busy { path } => Failure::busy(&path.display().to_string()),
        other => Failure::internal(other.to_string()),
    }
}
