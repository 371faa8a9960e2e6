//! `flankwright plan`: from the target to settings, motions and a proven flank.

use std::path::PathBuf;

use clap::Args;
use flankwright::exchange::AnyJob;
use flankwright::workflow::plan_job;

use super::{catalogue, milling, outcome, skiving, tangential};
use crate::arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;
use crate::progress::Bars;

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
    let loaded = match output::load_any_job(&arguments.job)? {
        AnyJob::Grinding(loaded) => loaded,
        AnyJob::Tangential(loaded) => return tangential::plan(&loaded, &arguments.common),
        AnyJob::Gearbox(loaded) => return Err(output::gearbox_only(&loaded, "plan")),
        AnyJob::Milling(loaded) => return milling::plan(&loaded, &arguments.common),
        AnyJob::Skiving(loaded) => return skiving::plan(&loaded, &arguments.common),
    };
    if let Some(catalogue) = catalogue::of_job(&loaded)? {
        return catalogue::plan(&loaded, &catalogue, &arguments.common);
    }
    let bars = Bars::new(arguments.common.quiet);
    let planned = plan_job(&loaded, &bars);
    bars.finish();
    outcome::deliver(&arguments.common, &loaded, planned)
}
