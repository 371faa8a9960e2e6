//! `flankwright simulate`: the settings stand in the job; what comes out.

use std::path::PathBuf;

use clap::Args;
use flankwright::exchange::AnyJob;
use flankwright::exchange::job::Process;
use flankwright::workflow::simulate_job;

use super::{outcome, skiving, tangential};
use crate::arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;
use crate::progress::Bars;

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
    let loaded = match output::load_any_job(&arguments.job)? {
        AnyJob::Grinding(loaded) => loaded,
        AnyJob::Tangential(loaded) => return tangential::simulate(&loaded, &arguments.common),
        AnyJob::Gearbox(loaded) => return Err(output::gearbox_only(&loaded, "simulate")),
        AnyJob::Milling(loaded) => {
            return Err(output::refused(&loaded, Process::FiveAxisMilling, "simulate"));
        }
        AnyJob::Skiving(loaded) => return skiving::simulate(&loaded, &arguments.common),
    };
    let bars = Bars::new(arguments.common.quiet);
    let simulated = simulate_job(&loaded, &bars);
    bars.finish();
    outcome::deliver(&arguments.common, &loaded, simulated)
}
