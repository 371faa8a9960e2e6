//! `flankwright simulate`: the settings stand in the job; what comes out.

use std::path::PathBuf;

use clap::Args;
use flankwright::workflow::Task;

use super::outcome;
use crate::common_arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;

/// Arguments of `simulate`.
#[derive(Args, Debug)]
#[command(
    after_help = "Example:\n  flankwright plan examples/twist-free-crowning.toml -o results\n  flankwright simulate results/settings.json\n\n\
    The settings are the table [settings] of the job; `plan` writes them into settings.json."
)]
pub struct SimulateArguments {
    /// The job file (TOML or JSON); `-` reads standard input
    #[arg(value_name = "JOB")]
    pub job: PathBuf,
    /// Arguments that every command has.
    #[command(flatten)]
    pub common: CommonArguments,
}

/// Runs the settings of the job, writes its files and prints a summary.
///
/// # Errors
/// As `plan`; a job without settings.
pub fn run(arguments: &SimulateArguments) -> Result<Exit, Failure> {
    let job = output::load_any_job(&arguments.job)?;
    outcome::run("simulate", Task::Simulate, &job, &arguments.common, outcome::ROWS)
}
