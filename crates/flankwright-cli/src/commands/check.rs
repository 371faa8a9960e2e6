//! `flankwright check`: parses and validates a job, prints what follows from it, writes nothing.

use std::path::PathBuf;

use clap::Args;
use flankwright::exchange::job::JobInfo;
use flankwright::exchange::{AnyJob, Loaded};
use flankwright::workflow::{DerivedGeometry, Remark, derived_geometry};
use serde::Serialize;
use serde_json::json;

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
    let job = output::load_any_job(&arguments.job)?;
    match &job {
        AnyJob::Grinding(loaded) => show(&arguments.common, &job, loaded, &loaded.job.job),
        AnyJob::Tangential(loaded) => show(&arguments.common, &job, loaded, &loaded.job.job),
        AnyJob::Gearbox(loaded) => show(&arguments.common, &job, loaded, &loaded.job.job),
        AnyJob::Milling(loaded) => show(&arguments.common, &job, loaded, &loaded.job.job),
        AnyJob::Skiving(loaded) => show(&arguments.common, &job, loaded, &loaded.job.job),
    }
}

fn show<J: Serialize>(
    common: &CommonArguments,
    job: &AnyJob,
    loaded: &Loaded<J>,
    info: &JobInfo,
) -> Result<Exit, Failure> {
    let (derived, warnings) =
        derived_geometry(job).map_err(|failure| Failure::of_job_or_file(loaded, failure))?;
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
