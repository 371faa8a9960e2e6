//! `flankwright gearbox`: the electronic gearbox on a stimulus.

use std::path::PathBuf;

use clap::Args;
use flankwright::exchange::{Diagnostic, GearboxJob, Problem, ProcessJob};
use flankwright::workflow::Task;

use super::outcome;
use crate::common_arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;

/// Arguments of `gearbox`.
#[derive(Args, Debug)]
#[command(
    after_help = "Example:\n  flankwright gearbox examples/gearbox/feed-to-and-fro.toml -o results\n\n\
    Takes jobs of the process \"electronic-gearbox\" (flankwright new electronic-gearbox). Writes result.json and report.html,\n\
    errors.csv for a motion, servo.csv with [servo], set-ups.csv with [explore], pulses.csv with output.pulse_trace.\n\
    Exit status 3: errors beyond target.tolerance_um, alarms or a motor at its limit where a tolerance is given, or [explore] found no\n\
    set-up that is accurate enough. Without target.tolerance_um errors are reported and not judged."
)]
pub struct GearboxArguments {
    /// The job file (TOML or JSON); `-` reads standard input
    #[arg(value_name = "JOB")]
    pub job: PathBuf,
    /// Arguments that every command has.
    #[command(flatten)]
    pub common: CommonArguments,
}

/// Runs the gearbox, writes its files and prints counters and errors.
///
/// # Errors
/// Everything that is wrong with job and reference pulses, files that cannot be written.
pub fn run(arguments: &GearboxArguments) -> Result<Exit, Failure> {
    let job = output::load_any_job(&arguments.job)?;
    if job.of::<GearboxJob>().is_none() {
        return Err(job.error(other_process(job.info().process.name())).into());
    }
    outcome::run("gearbox", Task::Plan, &job, &arguments.common, outcome::ROWS)
}

fn other_process(name: &str) -> Diagnostic {
    let message = format!("`gearbox` does not take a job of the process \"{name}\"");
    Diagnostic::new(Problem::ProcessNotAvailable, message)
        .field("job.process")
        .value(format!("\"{name}\""))
        .allowed(format!("\"{}\"", GearboxJob::NAME))
        .way_out("plan it with `flankwright plan`, or begin with `flankwright new electronic-gearbox`")
}
