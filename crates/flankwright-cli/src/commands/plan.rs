//! `flankwright plan`: from the target to settings, motions and a proven flank.

use std::path::PathBuf;

use clap::Args;
use flankwright::workflow::Task;

use super::outcome;
use crate::common_arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;

/// Arguments of `plan`.
#[derive(Args, Debug)]
#[command(after_help = "Example:\n  flankwright plan examples/twist-free-crowning.toml -o results\n\n\
    With a table [catalogue] in place of [worm] and [dresser] the best pair is chosen and planned; explore.html ranks all.\n\
    Exit status 3: made, but outside the tolerance; 4: not producible with these bodies; the report tells why, and what was tried.")]
pub struct PlanArguments {
    /// The job file (TOML or JSON); `-` reads standard input
    #[arg(value_name = "JOB")]
    pub job: PathBuf,
    /// Arguments that every command has.
    #[command(flatten)]
    pub common: CommonArguments,
}

/// Plans the job, writes its files and prints a summary.
///
/// # Errors
/// Everything that is wrong with the job, a target that these bodies cannot make, files that cannot be written.
pub fn run(arguments: &PlanArguments) -> Result<Exit, Failure> {
    let job = output::load_any_job(&arguments.job)?;
    outcome::run("plan", Task::Plan, &job, &arguments.common, outcome::ROWS)
}
