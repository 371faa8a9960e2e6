//! `flankwright inspect`: reads a measurement and evaluates it for a job.

use std::path::PathBuf;

use clap::Args;
use flankwright::exchange::job::Process;
use flankwright::exchange::{AnyJob, Diagnostic, Loaded, Problem};

use super::skiving;
use crate::arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;

/// Arguments of `inspect`.
#[derive(Args, Debug)]
#[command(after_help = "Example:\n  flankwright simulate examples/skiving/internal-ring.toml -o results\n  \
    flankwright inspect results/readings.csv --job examples/skiving/internal-ring.toml\n\n\
    Takes switching angles of a skiving tool at a light barrier (columns flank, track, sense, revolution, angle_deg).\n\
    Exit status 3: the tool is worn, teeth leave their band, or the workpiece's profile will leave its tolerance.")]
pub struct InspectArguments {
    /// The measurement
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// The job (TOML or JSON) that tells what was measured; `-` reads standard input
    #[arg(long, value_name = "JOB")]
    pub job: PathBuf,
    /// Arguments that every command has.
    #[command(flatten)]
    pub common: CommonArguments,
}

/// Evaluates the measurement, writes its files and prints a summary.
///
/// # Errors
/// Everything that is wrong with job and measurement, files that cannot be written.
pub fn run(arguments: &InspectArguments) -> Result<Exit, Failure> {
    match output::load_any_job(&arguments.job)? {
        AnyJob::Skiving(loaded) => skiving::inspect(&loaded, &arguments.file, &arguments.common),
        AnyJob::Grinding(loaded) => Err(other_process(&loaded, loaded.job.job.process)),
        AnyJob::Tangential(loaded) => Err(other_process(&loaded, loaded.job.job.process)),
        AnyJob::Gearbox(loaded) => Err(other_process(&loaded, loaded.job.job.process)),
        AnyJob::Milling(loaded) => Err(other_process(&loaded, loaded.job.job.process)),
    }
}

fn other_process<J>(loaded: &Loaded<J>, process: Process) -> Failure {
    let message = format!("`inspect` does not take a job of the process \"{}\"", process.name());
    let finding = Diagnostic::new(Problem::ProcessNotAvailable, message)
        .field("job.process")
        .value(format!("\"{}\"", process.name()))
        .allowed(format!("\"{}\"", Process::SkivingToolMeasuring.name()))
        .way_out("give the job for whose tool the angles were taken");
    loaded.error(finding).into()
}
