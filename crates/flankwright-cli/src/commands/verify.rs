//! Arguments of `flankwright verify`: recomputes every expected value of reference files.

use std::path::PathBuf;

use clap::Args;

use crate::arguments::CommonArguments;

/// Arguments of `verify`.
#[derive(Args, Debug)]
#[command(
    after_help = "Example:\n  flankwright verify tests/reference/10-gears.json tests/reference/28-planning.json\n\n\
    Exit status 0 only if no check failed and, without --allow-uncovered, no block was left out."
)]
pub struct VerifyArguments {
    /// Reference files
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,
    /// Directory with the data files that cases name
    #[arg(long, value_name = "DIR")]
    pub data: Option<PathBuf>,
    /// Blocks that are not covered yet are listed and are no failure
    #[arg(long)]
    pub allow_uncovered: bool,
    /// Arguments that every command has.
    #[command(flatten)]
    pub common: CommonArguments,
}
