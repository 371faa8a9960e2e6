//! Arguments of `flankwright simulate`: the settings stand in the job; what comes out.

use std::path::PathBuf;

use clap::Args;

use crate::arguments::CommonArguments;

/// Arguments of `simulate`.
#[derive(Args, Debug)]
#[command(after_help = "Example:\n  flankwright simulate examples/radial-feed-crowning.toml --json")]
pub struct SimulateArguments {
    /// The job file (TOML or JSON); `-` reads standard input
    #[arg(value_name = "JOB")]
    pub job: PathBuf,
    /// Arguments that every command has.
    #[command(flatten)]
    pub common: CommonArguments,
}
