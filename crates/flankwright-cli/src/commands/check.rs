//! `flankwright check`: parses and validates a job, prints what follows from it, writes nothing.

use std::path::PathBuf;

use clap::Args;
use flankwright::exchange::LoadedJob;
use flankwright::workflow::Remark;
use serde_json::json;

use super::catalogue;
use super::derived::{DerivedGeometry, derived_geometry};
use crate::arguments::CommonArguments;
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
    let loaded = output::load_job(&arguments.job)?;
    let catalogue = catalogue::of_job(&loaded)?;
    let (derived, warnings) =
        derived_geometry(&loaded, catalogue.as_ref()).map_err(|failure| Failure::of_run(&loaded, failure))?;
    let directory = output::directory(&arguments.common, &loaded).display().to_string();
    if arguments.common.json {
        output::print_json(&json!({
            "file": loaded.document.source().name(),
            "job": loaded.job,
            "derived": derived.to_json(),
            "warnings": warnings,
            "output_directory": directory,
        }))?;
    } else if !arguments.common.quiet {
        output::print(&text(&loaded, &derived, &warnings, &directory))?;
    }
    Ok(Exit::Done)
}

fn text(loaded: &LoadedJob, derived: &DerivedGeometry, warnings: &[Remark], directory: &str) -> String {
    let info = &loaded.job.job;
    let mut text = format!(
        "{}: valid job \"{}\" ({})\n",
        loaded.document.source().name(),
        info.name,
        info.process.name()
    );
    if let Some(description) = &info.description {
        text += &format!("{description}\n");
    }
    text += &derived.to_text();
    for warning in warnings {
        text += &format!("\nwarning: {} ({})\n", warning.text, warning.way_out);
    }
    text + &format!("\nresults would go to {directory}\n")
}
