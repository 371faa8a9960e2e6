//! `flankwright explore`: diagonal ratios and worms side by side, ranked.

use std::path::PathBuf;

use clap::Args;
use flankwright::workflow::Task;

use super::outcome;
use crate::common_arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;

/// Arguments of `explore`.
#[derive(Args, Debug)]
#[command(
    after_help = "Example:\n  flankwright explore examples/twist-free-crowning.toml --top 5 -o study\n\n\
    What varies stands in the table [explore] of the job, e.g. diagonal_ratio = { from = -3.0, to = 3.0, count = 61 };\n\
    without it the diagonal ratio runs over both signs. A job with a [catalogue] has all its pairs of worm and dresser ranked. Writes explore.json, explore.csv and explore.html.\n\
    Exit status 3: what can be made misses the tolerance; 4: nothing can be made with these bodies."
)]
pub struct ExploreArguments {
    /// The job file (TOML or JSON); `-` reads standard input
    #[arg(value_name = "JOB")]
    pub job: PathBuf,
    /// Rows of the ranking to print; the files hold all
    #[arg(long, value_name = "N", default_value_t = 20)]
    pub top: usize,
    /// Arguments that every command has.
    #[command(flatten)]
    pub common: CommonArguments,
}

/// Judges every combination, writes the files and prints the head of the ranking.
///
/// # Errors
/// Everything that is wrong with the job for all combinations, files that cannot be written.
pub fn run(arguments: &ExploreArguments) -> Result<Exit, Failure> {
    let job = output::load_any_job(&arguments.job)?;
    outcome::run("explore", Task::Explore, &job, &arguments.common, arguments.top)
}
