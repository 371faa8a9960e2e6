//! `flankwright inspect`: reads measurements and evaluates them, by themselves or for a job.

use std::path::{Path, PathBuf};

use clap::Args;
use flankwright::exchange::job::Process;
use flankwright::exchange::{AnyJob, Diagnostic, Loaded, LoadedJob, LoadedSkivingJob, Problem};

use super::{measured_gear, skiving};
use crate::arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;

/// Arguments of `inspect`.
#[derive(Args, Debug)]
#[command(after_help = "Example:\n  flankwright inspect part.mka\n  \
    flankwright inspect measured/ -o series\n  \
    flankwright inspect examples/inspection/measured.csv --job examples/inspection/measured.toml\n  \
    flankwright inspect --job examples/inspection/closed-loop.toml\n  \
    flankwright inspect examples/skiving/readings.csv --job examples/skiving/measured-ring.toml\n\n\
    A gear: .mka or .mew (each finds the other beside it), .rexs, .rexsj, .rexsz, or .csv with the columns kind, tooth, flank, position, \
    abscissa, f_um (traces) or tooth, flank, w_mm, z_mm, f_um (fields). A folder: every measurement in it, with statistics, trends and \
    capability. With a job of generating grinding: what is systematic, which settings correct it, and the corrected job; without a file, \
    the measurement that its table [inspection.simulated] describes.\n\
    A skiving tool: switching angles at a light barrier (columns flank, track, sense, revolution, angle_deg), always with its job.\n\n\
    Files go into FILE.inspected/ beside the measurement (JOB name.inspected/ beside the job where it simulates one), or where -o says.\n\n\
    Exit status 3: the measured flank misses the tolerance of the job; of a series, values beyond the class or files that were refused; the tool is worn, teeth leave their band, or the workpiece's \
    profile will leave its tolerance.")]
pub struct InspectArguments {
    /// The measurement, or a folder of measurements
    #[arg(value_name = "FILE", required_unless_present = "job")]
    pub file: Option<PathBuf>,
    /// The job (TOML or JSON) that tells what was made or measured; `-` reads standard input
    #[arg(long, value_name = "JOB")]
    pub job: Option<PathBuf>,
    /// Class of ISO 1328-1:2013 whose tolerances are the limits of sheets and series
    #[arg(long, value_name = "CLASS", value_parser = clap::value_parser!(i32).range(1..=11))]
    pub class: Option<i32>,
    /// Arguments that every command has.
    #[command(flatten)]
    pub common: CommonArguments,
}

/// Evaluates the measurement, writes its files and prints a summary.
///
/// # Errors
/// Everything that is wrong with job and measurement, files that cannot be written.
pub fn run(arguments: &InspectArguments) -> Result<Exit, Failure> {
    let (file, common) = (arguments.file.as_deref(), &arguments.common);
    match (file, &arguments.job) {
        (Some(folder), None) if folder.is_dir() => measured_gear::series(folder, arguments.class, common),
        (Some(file), None) => measured_gear::alone(file, arguments.class, common),
        (_, Some(job)) => match output::load_any_job(job)? {
            AnyJob::Skiving(loaded) => of_tool(&loaded, file, common),
            AnyJob::Grinding(loaded) => of_gear(&loaded, file, arguments),
            AnyJob::Tangential(loaded) => Err(other_process(&loaded, loaded.job.job.process)),
            AnyJob::Gearbox(loaded) => Err(other_process(&loaded, loaded.job.job.process)),
            AnyJob::Milling(loaded) => Err(other_process(&loaded, loaded.job.job.process)),
        },
        (None, None) => Err(Failure::internal("neither a measurement nor a job".into())),
    }
}

fn of_gear(loaded: &LoadedJob, file: Option<&Path>, arguments: &InspectArguments) -> Result<Exit, Failure> {
    let (class, common) = (arguments.class, &arguments.common);
    match file {
        Some(file) => measured_gear::for_job(file, loaded, class, common),
        None => measured_gear::simulated(loaded, class, common),
    }
}

fn of_tool(
    loaded: &LoadedSkivingJob,
    file: Option<&Path>,
    common: &CommonArguments,
) -> Result<Exit, Failure> {
    let Some(file) = file else {
        let finding = Diagnostic::new(Problem::MissingKey, "there is no measurement of the tool")
            .field("FILE")
            .way_out("name the file of switching angles; `flankwright simulate` writes one");
        return Err(Failure::of_job(Exit::BadInput, loaded, finding));
    };
    skiving::inspect(loaded, file, common)
}

fn other_process<J>(loaded: &Loaded<J>, process: Process) -> Failure {
    let message = format!("`inspect` does not take a job of the process \"{}\"", process.name());
    let finding = Diagnostic::new(Problem::ProcessNotAvailable, message)
        .field("job.process")
        .value(format!("\"{}\"", process.name()))
        .allowed(format!(
            "\"{}\", \"{}\"",
            Process::GeneratingGrinding.name(),
            Process::SkivingToolMeasuring.name()
        ))
        .way_out("give the job by which the gear was ground, or for whose tool the angles were taken");
    loaded.error(finding).into()
}
