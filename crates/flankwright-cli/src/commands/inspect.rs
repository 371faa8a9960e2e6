//! `flankwright inspect`: reads measurements and evaluates them, by themselves or for a job.

use std::path::{Path, PathBuf};

use clap::Args;
use flankwright::exchange::{
    AnyJob, Diagnostic, Job, LoadedJob, MillingJob, Problem, ProcessJob, SkivingJob,
};
use flankwright::workflow::inspection::SheetOptions;
use flankwright::workflow::skiving::inspect_skiving;
use flankwright::workflow::{Task, TaskOutcome};
use flankwright_store::StoreAddress;

use super::measured_gear::Asked;
use super::page_language::LanguageArguments;
use super::statements::StatementArguments;
use super::store::place::failed;
use super::{blank, measured_gear, outcome};
use crate::common_arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;
use crate::progress::Bars;

/// Arguments of `inspect`.
#[derive(Args, Debug)]
#[command(after_help = "Example:\n  flankwright inspect part.mka\n  \
    flankwright inspect measured/ --language de -o series\n  \
    flankwright inspect examples/inspection/measured.csv --job examples/inspection/measured.toml\n  \
    flankwright inspect --job examples/inspection/closed-loop.toml\n  \
    flankwright inspect examples/inspection/bevel.csv --job examples/inspection/bevel.toml --class 6\n  \
    flankwright inspect examples/skiving/readings.csv --job examples/skiving/measured-ring.toml\n  \
    flankwright inspect examples/inspection/blank.csv --job examples/cycles/measured-blank.toml --blank\n  \
    flankwright inspect --part 17 --job ground.toml --blank --store shop.sqlite\n\n\
    A gear: .mka or .mew (each finds the other beside it), .rexs, .rexsj, .rexsz, or .csv with the columns kind, tooth, flank, position, \
    abscissa, f_um (traces) or tooth, flank, w_mm, z_mm, f_um (fields); of a bevel gear with its milling job .csv with the columns tooth, flank, \
    row, column, f_um or x_mm, y_mm, z_mm (its measuring grid). A folder: every measurement in it, with statistics, trends and \
    capability. With a job of generating grinding or five-axis milling: what is systematic, which settings correct it, and the corrected job; without a file, \
    the measurement that its table [inspection.simulated] describes.\n\
    A skiving tool: switching angles at a light barrier (columns flank, track, sense, revolution, angle_deg), always with its job.\n\n\
    Files go into FILE.inspected/ beside the measurement (JOB name.inspected/ beside the job where it simulates one), or where -o says.\n\n\
    Exit status 3: the measured flank misses the tolerance of the job; a part is beyond the class of --class, or its file lacks what the \
    class needs; a file holds nothing that can be evaluated, or one of a folder was refused; the tool is worn, teeth leave their band, or the workpiece's \
    profile will leave its tolerance.")]
pub struct InspectArguments {
    /// The measurement, or a folder of measurements
    #[arg(value_name = "FILE", required_unless_present = "job", group = "measured")]
    pub file: Option<PathBuf>,
    /// The job (TOML or JSON) that tells what was made or measured; `-` reads standard input
    #[arg(long, value_name = "JOB")]
    pub job: Option<PathBuf>,
    /// Class of ISO 1328-1:2013 that parts have to reach, of a bevel gear class of ISO 17485:2006 (2 to 11); its tolerances are the limits of
    /// sheets and series
    #[arg(long, value_name = "CLASS", value_parser = clap::value_parser!(i32).range(1..=11))]
    pub class: Option<i32>,
    /// The measured gear is the blank before grinding: writes the stock that it has over the gear of the job, tooth by tooth, as stock.csv for
    /// the key `stock.map`
    #[arg(long, requires = "job", requires = "measured", conflicts_with = "class")]
    pub blank: bool,
    /// A blank of the store in place of a file: the number of the part, or the beginning of its digest
    #[arg(long, value_name = "PART", group = "measured", requires = "blank")]
    pub part: Option<String>,
    /// The store of that part: a path, sqlite:PATH or postgres://...; default FLANKWRIGHT_STORE, else a file among the user's data
    #[arg(long, value_name = "ADDRESS", requires = "part")]
    pub store: Option<String>,
    /// Helix traces of sheets with the top of the measuring machine upwards instead of the datum face downwards
    #[arg(long)]
    pub top_up: bool,
    /// Language of the pages.
    #[command(flatten)]
    pub language: LanguageArguments,
    /// What the files do not tell.
    #[command(flatten)]
    pub statements: StatementArguments,
    /// Arguments that every command has.
    #[command(flatten)]
    pub common: CommonArguments,
}

impl InspectArguments {
    fn asked(&self) -> Asked<'_> {
        let sheet =
            SheetOptions { tolerance_class: self.class, top_up: self.top_up, ..SheetOptions::default() };
        let (statements, language) = (self.statements.statements(), self.language.given());
        Asked { sheet, statements, language, common: &self.common }
    }
}

/// Evaluates the measurement, writes its files and prints a summary.
///
/// # Errors
/// Everything that is wrong with job and measurement, files that cannot be written.
pub fn run(arguments: &InspectArguments) -> Result<Exit, Failure> {
    let (file, asked) = (arguments.file.as_deref(), arguments.asked());
    match (file, &arguments.job) {
        (Some(file), Some(job)) if arguments.blank => {
            blank::of_file(grinding(&output::load_any_job(job)?)?, file, &asked)
        }
        (None, Some(job)) if arguments.blank => {
            let part = arguments.part.as_deref().unwrap_or_default();
            let store = StoreAddress::chosen(arguments.store.as_deref()).map_err(failed)?;
            blank::of_part(grinding(&output::load_any_job(job)?)?, part, &store, &asked)
        }
        (Some(folder), None) if folder.is_dir() => measured_gear::series(folder, asked),
        (Some(file), None) => measured_gear::alone(file, &asked),
        (_, Some(job)) => for_job(&output::load_any_job(job)?, file, &asked),
        (None, None) => Err(Failure::internal("neither a measurement nor a job".into())),
    }
}

fn for_job(job: &AnyJob, file: Option<&Path>, asked: &Asked<'_>) -> Result<Exit, Failure> {
    if job.of::<SkivingJob>().is_some() {
        nothing_stated(job, asked)?;
        return of_tool(job, file, asked);
    }
    if let Some(loaded) = job.of::<MillingJob>() {
        return match file {
            Some(file) if loaded.job.bevel.is_some() => {
                nothing_stated(job, asked)?;
                measured_gear::for_bevel(file, loaded, asked)
            }
            Some(file) => measured_gear::for_milling(file, loaded, asked),
            None => Err(no_file(job)),
        };
    }
    let loaded = grinding(job)?;
    match file {
        Some(file) => measured_gear::for_job(file, loaded, asked),
        None => {
            nothing_stated(job, asked)?;
            measured_gear::simulated(loaded, asked)
        }
    }
}

/// The job by which gears are ground.
fn grinding(job: &AnyJob) -> Result<&LoadedJob, Failure> {
    job.of::<Job>().ok_or_else(|| other_process(job))
}

/// Statements belong to files of measured cylindrical gears.
fn nothing_stated(job: &AnyJob, asked: &Asked<'_>) -> Result<(), Failure> {
    if asked.statements.is_empty() {
        return Ok(());
    }
    let message = "statements about a measurement hold for the file of a measured gear";
    let finding = Diagnostic::new(Problem::UnknownValue, message)
        .field("--from-other-end, --slope-signs, --datum-face, --helix-slope-over, --profile-slope-over")
        .value("stated where no gear was measured")
        .allowed("with the measurement of a gear")
        .way_out("leave them out, or name the file of the measurement");
    Err(Failure::of_job(Exit::BadInput, job.document(), finding))
}

/// A milled gear is measured on a machine; none is simulated.
fn no_file(job: &AnyJob) -> Failure {
    let finding = Diagnostic::new(Problem::MissingKey, "there is no measurement of the milled gear")
        .field("FILE")
        .way_out("name the file of the measurement");
    Failure::of_job(Exit::BadInput, job.document(), finding)
}

fn of_tool(job: &AnyJob, file: Option<&Path>, asked: &Asked<'_>) -> Result<Exit, Failure> {
    let (Some(file), Some(loaded)) = (file, job.of::<SkivingJob>()) else {
        let finding = Diagnostic::new(Problem::MissingKey, "there is no measurement of the tool")
            .field("FILE")
            .way_out("name the file of switching angles; `flankwright simulate` writes one");
        return Err(Failure::of_job(Exit::BadInput, job.document(), finding));
    };
    let mut loaded = loaded.clone();
    if let Some(language) = asked.language {
        loaded.job.output.language = language;
    }
    let common = asked.common;
    let bars = Bars::new(common.quiet);
    let done = inspect_skiving(&loaded, file, &bars);
    bars.finish();
    let done = done.map(|outcome| Box::new(outcome) as Box<dyn TaskOutcome>);
    outcome::deliver(Task::Inspect, job, common, outcome::ROWS, done)
}

fn other_process(job: &AnyJob) -> Failure {
    let name = job.info().process.name();
    let message = format!("`inspect` does not take a job of the process \"{name}\"");
    let finding = Diagnostic::new(Problem::ProcessNotAvailable, message)
        .field("job.process")
        .value(format!("\"{name}\""))
        .allowed(format!("\"{}\", \"{}\", \"{}\"", Job::NAME, MillingJob::NAME, SkivingJob::NAME))
        .way_out(
            "give the job by which the gear was ground or milled, or for whose tool the angles were taken",
        );
    job.error(finding).into()
}
