//! What every command takes: how it prints, and where its files go.

use std::path::PathBuf;

use clap::Args;

/// Arguments that every command has.
#[derive(Args, Clone, Debug, Default)]
pub struct CommonArguments {
    /// Print one JSON document on standard output and nothing else there
    #[arg(long)]
    pub json: bool,
    /// Print no progress and no summary
    #[arg(long, short)]
    pub quiet: bool,
    /// Directory for files; default `<job name>.out/` beside the job
    #[arg(long = "output", short, value_name = "DIR")]
    pub output: Option<PathBuf>,
}
