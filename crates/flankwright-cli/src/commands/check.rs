//! `flankwright check`: parses and validates a job, prints what follows from it, writes nothing.

use std::path::PathBuf;

use clap::Args;
use flankwright::exchange::job::JobInfo;
use flankwright::exchange::{AnyJob, Loaded};
use flankwright::workflow::{Remark, RunFailure};
use serde::Serialize;
use serde_json::json;

use super::catalogue;
use super::derived::{
    DerivedGeometry, derived_gearbox, derived_geometry, derived_milling, derived_skiving, derived_tangential,
};
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
    match output::load_any_job(&arguments.job)? {
        AnyJob::Grinding(loaded) => {
            let catalogue = catalogue::of_job(&loaded)?;
            let derived = derived_geometry(&loaded, catalogue.as_ref());
            show(&arguments.common, &loaded, &loaded.job.job, derived)
        }
        AnyJob::Tangential(loaded) => {
            let derived = derived_tangential(&loaded).map(|derived| (derived, Vec::new()));
            show(&arguments.common, &loaded, &loaded.job.job, derived)
        }
        AnyJob::Gearbox(loaded) => {
            let derived = derived_gearbox(&loaded)?;
            show(&arguments.common, &loaded, &loaded.job.job, Ok((derived, Vec::new())))
        }
        AnyJob::Milling(loaded) => {
            let derived = derived_milling(&loaded).map(|derived| (derived, Vec::new()));
            show(&arguments.common, &loaded, &loaded.job.job, derived)
        }
        AnyJob::Skiving(loaded) => {
            let derived = derived_skiving(&loaded).map(|derived| (derived, Vec::new()));
            show(&arguments.common, &loaded, &loaded.job.job, derived)
        }
    }
}

fn show<J: Serialize>(
    common: &CommonArguments,
    loaded: &Loaded<J>,
    info: &JobInfo,
    derived: Result<(DerivedGeometry, Vec<Remark>), RunFailure>,
) -> Result<Exit, Failure> {
    let (derived, warnings) = derived.map_err(|failure| Failure::of_run(loaded, failure))?;
    let directory = output::directory(common, loaded, info).display().to_string();
    let file = loaded.document.source().name();
    if common.json {
        output::print_json(&json!({
            "file": file,
            "job": loaded.job,
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
