//! `flankwright check`: parses and validates a job, prints what follows from it, writes nothing.

use std::path::PathBuf;

use clap::Args;
use flankwright::exchange::job::JobInfo;
use flankwright::workflow::{DerivedGeometry, Remark, derived_geometry};
use serde_json::json;

use crate::common_arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;

/// Arguments of `check`.
#[derive(Args, Debug)]
#[command(after_help = "Example:\n  flankwright check examples/twist-free-crowning.toml\n  \
    flankwright new generating-grinding | flankwright check -\n\nWrites nothing; with -o it says where results would go.")]
pub struct CheckArguments {
    /// The job file (TOML or JSON); `-` reads standard input
    #[arg(value_name = "JOB")]
    pub job: PathBuf,
    /// Arguments that every command has.
    #[command(flatten)]
    pub common: CommonArguments,
}

/// Checks the job and prints the derived geometry.
///
/// # Errors
/// Everything that is wrong with the job.
pub fn run(arguments: &CheckArguments) -> Result<Exit, Failure> {
    let job = output::load_any_job(&arguments.job)?;
    let (common, document, info) = (&arguments.common, job.document(), job.info());
    let (derived, warnings) =
        derived_geometry(&job).map_err(|failure| Failure::of_job_or_file(document, failure))?;
    let directory = output::directory(common, document, info).display().to_string();
    let file = document.source().name();
    if common.json {
        let value = job.to_value().map_err(|error| Failure::internal(error.to_string()))?;
        output::print_json(&json!({
            "file": file,
            "job": value,
            "derived": derived.to_json(),
            "warnings": warnings,
            "output_directory": directory,
        }))?;
    } else if !common.quiet {
        output::print(&text(file, info, &derived, &warnings, &directory))?;
    }
    Ok(Exit::Done)
}

fn text(
    file: &str,
    info: &JobInfo,
    derived: &DerivedGeometry,
    warnings: &[Remark],
    directory: &str,
) -> String {
    let mut text = format!("{file}: valid job \"{}\" ({})\n", info.name, info.process.name());
    if let Some(description) = &info.description {
        text += &format!("{description}\n");
    }
    text += &derived.to_text();
    for warning in warnings {
        text += &format!("\nwarning: {} ({})\n", warning.text, warning.way_out);
    }
    text + &format!("\nresults would go to {directory}\n")
}
