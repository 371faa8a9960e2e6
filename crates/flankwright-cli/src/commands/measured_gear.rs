//! `inspect` of measured gears: one by itself or against a job, or many as a series; writes their files, prints a summary.

use std::path::{Path, PathBuf};

use flankwright::exchange::job::Language;
use flankwright::exchange::{Diagnostic, LoadedJob, LoadedMillingJob, Problem};
use flankwright::workflow::JobFailure;
use flankwright::workflow::inspection::series::{
    InspectionSeries, SeriesOptions, inspect_series, measured_parts_in, series_summary,
    write_inspection_series,
};
use flankwright::workflow::inspection::{
    GearInspection, SheetOptions, Statements, inspect_bevel, inspect_for_job, inspect_for_milling,
    inspect_gear, inspect_simulated, write_bevel_inspection, write_gear_inspection,
};

use super::outcome::{ROWS, conclude, unwritten};
use crate::common_arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;
use crate::progress::Bars;

/// What the user asks for.
pub struct Asked<'a> {
    /// What stands on sheets.
    pub sheet: SheetOptions,
    /// What the files do not tell.
    pub statements: Statements,
    /// Language of the pages, if not that of the job.
    pub language: Option<Language>,
    /// Arguments that every command has.
    pub common: &'a CommonArguments,
}

/// Evaluates a measurement by itself.
///
/// # Errors
/// A file that is no measurement, files that cannot be written.
pub fn alone(file: &Path, asked: &Asked<'_>) -> Result<Exit, Failure> {
    let found =
        inspect_gear(file, &asked.statements, asked.sheet.tolerance_class).map_err(
            |failure| match failure {
                JobFailure::File(error) => Failure::from(*error),
                JobFailure::Job(failure) => Failure::of_no_job(failure),
            },
        )?;
    deliver(found, asked, &beside(file))
}

/// Judges a measurement against a job.
///
/// # Errors
/// As [`alone`]; everything that is wrong with the job, a measurement of another gear.
pub fn for_job(file: &Path, loaded: &LoadedJob, asked: &Asked<'_>) -> Result<Exit, Failure> {
    if file.is_dir() {
        let finding =
            Diagnostic::new(Problem::UnknownValue, "a folder is evaluated as a series, without a job")
                .field("FILE")
                .value(file.display())
                .allowed("one measurement")
                .way_out("leave `--job` out, or name one file of the folder");
        return Err(Failure::new(Exit::BadInput, finding));
    }
    let bars = Bars::new(asked.common.quiet);
    let found = inspect_for_job(loaded, file, &asked.statements, asked.sheet.tolerance_class, &bars);
    bars.finish();
    let found = found.map_err(|failure| Failure::of_job_or_file(&loaded.document, failure))?;
    deliver(found, asked, &beside(file))
}

/// Judges a measurement against a job of five-axis milling.
///
/// # Errors
/// As [`for_job`]; a workpiece that is no cylindrical gear.
pub fn for_milling(file: &Path, loaded: &LoadedMillingJob, asked: &Asked<'_>) -> Result<Exit, Failure> {
    let bars = Bars::new(asked.common.quiet);
    let found = inspect_for_milling(loaded, file, &asked.statements, asked.sheet.tolerance_class, &bars);
    bars.finish();
    let found = found.map_err(|failure| Failure::of_job_or_file(&loaded.document, failure))?;
    deliver(found, asked, &beside(file))
}

/// Judges points on the grid of a bevel gear against the job by which it was milled.
///
/// # Errors
/// As [`for_job`]; statements, which belong to files of measuring machines.
pub fn for_bevel(file: &Path, loaded: &LoadedMillingJob, asked: &Asked<'_>) -> Result<Exit, Failure> {
    let bars = Bars::new(asked.common.quiet);
    let found = inspect_bevel(loaded, file, asked.sheet.tolerance_class, &bars);
    bars.finish();
    let mut found = found.map_err(|failure| Failure::of_job_or_file(&loaded.document, failure))?;
    found.language = asked.language.unwrap_or(found.language);
    let beside = beside(file);
    let directory = asked.common.output.as_deref().unwrap_or(&beside);
    let written = write_bevel_inspection(&found, directory).map_err(unwritten)?;
    conclude(asked.common, &found, ROWS, &written)
}

/// Measures and corrects the simulated machine of a job.
///
/// # Errors
/// Everything that is wrong with the job, files that cannot be written.
pub fn simulated(loaded: &LoadedJob, asked: &Asked<'_>) -> Result<Exit, Failure> {
    let bars = Bars::new(asked.common.quiet);
    let found = inspect_simulated(loaded, asked.sheet.tolerance_class, &bars);
    bars.finish();
    let found = found.map_err(|failure| Failure::of_run(&loaded.document, failure))?;
    let directory = loaded.beside(&format!("{}.inspected", loaded.job.job.name));
    deliver(found, asked, &directory)
}

/// `part.mka.inspected/` beside `part.mka`; of a folder that has no name here, such as `.`, by its real name.
pub fn beside(file: &Path) -> PathBuf {
    let named = if file.file_name().is_some() { None } else { file.canonicalize().ok() };
    let file = named.as_deref().unwrap_or(file);
    let mut name = file.file_name().unwrap_or("part".as_ref()).to_owned();
    name.push(".inspected");
    file.with_file_name(name)
}

fn deliver(mut found: GearInspection, asked: &Asked<'_>, directory: &Path) -> Result<Exit, Failure> {
    found.language = asked.language.unwrap_or(found.language);
    let directory = asked.common.output.as_deref().unwrap_or(directory);
    let written = write_gear_inspection(&found, &asked.sheet, directory).map_err(unwritten)?;
    conclude(asked.common, &found, ROWS, &written)
}

/// Evaluates all measurements of a folder as a series.
///
/// # Errors
/// A folder without measurements, a class that is none, files that cannot be written.
pub fn series(folder: &Path, asked: Asked<'_>) -> Result<Exit, Failure> {
    let found = measured_parts_in(folder).map_err(Failure::of_no_job)?;
    let options = SeriesOptions {
        language: asked.language.unwrap_or_default(),
        sheet: asked.sheet,
        statements: asked.statements,
        left_out: found.left_out,
        ..SeriesOptions::default()
    };
    let series = inspect_series(&found.parts, &options).map_err(Failure::of_no_job)?;
    deliver_series(&series, &beside(folder), asked.common)
}

/// Writes the files of a series and prints its summary. Files that were refused are named, whatever else is quiet.
///
/// # Errors
/// Files that cannot be written.
pub fn deliver_series(
    series: &InspectionSeries,
    directory: &Path,
    common: &CommonArguments,
) -> Result<Exit, Failure> {
    let directory = common.output.as_deref().unwrap_or(directory);
    let written = write_inspection_series(series, directory).map_err(unwritten)?;
    if common.json {
        output::print_json(&series.result)?;
    } else if !common.quiet {
        let page = written.last().map(|page| format!("  report: {}\n", page.display()));
        output::print(&(series_summary(series) + &page.unwrap_or_default()))?;
    }
    Ok(if series.result.verdict.is_accepted() { Exit::Done } else { Exit::TargetMissed })
}
