//! Arguments of `flankwright plan`: from the target to settings, motions and a proven flank.

use std::path::PathBuf;

use clap::Args;

use crate::arguments::CommonArguments;

/// Arguments of `plan`.
#[derive(Args, Debug)]
#[command(after_help = "Example:\n  flankwright plan examples/twist-free-crowning.toml -o results\n\n\
    Exit status 3: made, but outside the tolerance; 4: not producible with these bodies.")]
pub struct PlanArguments {
    /// The job file (TOML or JSON); `-` reads standard input
    #[arg(value_name = "JOB")]
    pub job: PathBuf,
    /// Arguments that every command has.
    #[command(flatten)]
    pub common: CommonArguments,
}
