//! `inspect` of measured gears: one by itself or against a job, or many as a series; writes their files, prints a summary.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use flankwright::exchange::{Diagnostic, LoadedJob, Problem};
use flankwright::workflow::inspection::series::{
    InspectionSeries, SeriesOptions, inspect_series, measured_parts_in, series_summary,
    write_inspection_series,
};
use flankwright::workflow::inspection::{
    GearInspection, GearInspectionResult, RoundResult, SheetOptions, Statements, inspect_for_job,
    inspect_gear, inspect_simulated, write_gear_inspection,
};
use flankwright::workflow::{JobFailure, Remark, Status};

use super::outcome::{Verdict, closing, conclude, fixed, opening, tell, unwritten};
use crate::arguments::CommonArguments;
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
    deliver(&found, asked, &beside(file))
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
    let found = found.map_err(|failure| Failure::of_job_or_file(loaded, failure))?;
    deliver(&found, asked, &beside(file))
}

/// Measures and corrects the simulated machine of a job.
///
/// # Errors
/// Everything that is wrong with the job, files that cannot be written.
pub fn simulated(loaded: &LoadedJob, asked: &Asked<'_>) -> Result<Exit, Failure> {
    let bars = Bars::new(asked.common.quiet);
    let found = inspect_simulated(loaded, asked.sheet.tolerance_class, &bars);
    bars.finish();
    let found = found.map_err(|failure| Failure::of_run(loaded, failure))?;
    let directory = loaded.beside(&format!("{}.inspected", loaded.job.job.name));
    deliver(&found, asked, &directory)
}

/// `part.mka.inspected/` beside `part.mka`; of a folder that has no name here, such as `.`, by its real name.
pub fn beside(file: &Path) -> PathBuf {
    let named = if file.file_name().is_some() { None } else { file.canonicalize().ok() };
    let file = named.as_deref().unwrap_or(file);
    let mut name = file.file_name().unwrap_or("part".as_ref()).to_owned();
    name.push(".inspected");
    file.with_file_name(name)
}

fn deliver(found: &GearInspection, asked: &Asked<'_>, directory: &Path) -> Result<Exit, Failure> {
    let directory = asked.common.output.as_deref().unwrap_or(directory);
    let written = write_gear_inspection(found, &asked.sheet, directory).map_err(unwritten)?;
    let result = &found.result;
    let verdict = verdict(result);
    conclude(asked.common, result, verdict, || summary(result, &written))
}

/// Evaluates all measurements of a folder as a series.
///
/// # Errors
/// A folder without measurements, a class that is none, files that cannot be written.
pub fn series(folder: &Path, asked: Asked<'_>) -> Result<Exit, Failure> {
    let found = measured_parts_in(folder).map_err(Failure::of_no_job)?;
    let options = SeriesOptions {
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

fn verdict(result: &GearInspectionResult) -> Verdict<'_> {
    Verdict::of(&result.job, &result.verdict)
}

fn summary(result: &GearInspectionResult, written: &[PathBuf]) -> String {
    let mut text = match result.tolerance_um {
        Some(tolerance) if result.rounds.last().is_some_and(|round| !round.flanks.is_empty()) => {
            opening(&verdict(result), result.largest_um(), tolerance)
        }
        // Lines that make no surface are judged one by one; there is no largest deviation to tell.
        Some(tolerance) => {
            let missed = match result.verdict.status() {
                Status::Missed => "target MISSED",
                Status::Met => "target met",
                Status::NotJudged => "target NOT JUDGED",
            };
            let mut text = format!("{}: {missed} (tolerance {tolerance} um)\n", result.job);
            if let Some(reason) = result.verdict.reason() {
                tell(&mut text, reason);
            }
            text
        }
        None => {
            let values = match result.printed_values {
                0 => String::new(),
                count => format!(", {count} printed values read"),
            };
            let judged = match (result.verdict.status(), result.tolerance_class) {
                (Status::Met, Some(class)) => format!("class {class} reached"),
                (Status::Missed, Some(class)) => format!("class {class} MISSED"),
                (_, Some(class)) => format!("class {class} NOT JUDGED"),
                (_, None) => "not judged".to_owned(),
            };
            let mut text =
                format!("{}: {judged}; {} traces evaluated{values}\n", result.job, result.traces.len());
            if let Some(reason) = result.verdict.reason() {
                tell(&mut text, reason);
            }
            text
        }
    };
    evaluated(&mut text, result);
    for round in &result.rounds {
        of_round(&mut text, round, result.rounds.len());
    }
    if !result.not_understood.is_empty() {
        // Writing to a text cannot fail.
        let _ = writeln!(
            text,
            "  {} lines were not understood: they are listed in result.json",
            result.not_understood.len()
        );
    }
    let warnings: Vec<Remark> = result.warnings.iter().take(SHOWN).cloned().collect();
    closing(&mut text, &result.verdict, &warnings, &result.timing_s, written);
    if result.warnings.len() > SHOWN {
        let _ = writeln!(text, "  {} more warnings are in result.json", result.warnings.len() - SHOWN);
    }
    text
}

/// Warnings that are printed.
const SHOWN: usize = 10;

fn evaluated(text: &mut String, result: &GearInspectionResult) {
    let one = |row: &flankwright::workflow::inspection::SummaryResult| {
        let tag = if row.tag.is_empty() { String::new() } else { format!(" {}", row.tag) };
        let range = row.range_um.map_or_else(String::new, |um| format!(" (range {})", fixed(um, 2)));
        format!("{}{tag} {}{range}", row.characteristic, fixed(row.mean_um, 2))
    };
    for kind in ["profile", "helix"] {
        for flank in ["left", "right"] {
            let rows = result.summary.iter().filter(|row| row.kind == kind && row.flank == flank);
            let told: Vec<String> = rows.map(one).collect();
            if !told.is_empty() {
                let _ = writeln!(text, "  {kind:<7} {flank:<5} {} um", told.join(", "));
            }
        }
    }
    for (flank, pitch) in &result.pitch {
        let _ = writeln!(
            text,
            "  pitch   {flank:<5} fp {:.2}, fu {:.2}, Fp {:.2} um",
            pitch.single_um, pitch.neighbours_um, pitch.total_um
        );
    }
    if let Some(run_out) = result.run_out_um {
        let _ = writeln!(text, "  run-out {run_out:.2} um");
    }
    if !result.classes.is_empty() {
        let class = result.class.map_or_else(|| "worse than 11".to_owned(), |class| class.to_string());
        let part = if result.class_is_partial { ", of what could be evaluated" } else { "" };
        let _ = writeln!(text, "  class of ISO 1328-1:2013: {class}{part}");
    }
    if !result.printed.is_empty() {
        let _ = writeln!(
            text,
            "  {} of the {} values that the measuring machine printed are among these, within {:.3} um",
            result.printed.len(),
            result.printed_values,
            result.printed_difference_um
        );
    }
}

fn of_round(text: &mut String, round: &RoundResult, of: usize) {
    let number = if of > 1 { format!("round {}: ", round.round) } else { String::new() };
    for (flank, found) in &round.flanks {
        let explained = if found.explained { ", as the plan says" } else { "" };
        let _ = writeln!(
            text,
            "  {number}{flank} flank, measured less target: rms {:.3} um, largest {:.3} um{explained}",
            found.measured.rms_um, found.measured.largest_um
        );
    }
    for of in round.characteristics.iter().filter(|of| of.decision == "correct") {
        let sure = of.uncertainty_um.map_or_else(String::new, |u| format!(" (uncertainty {u:.3})"));
        let _ = writeln!(
            text,
            "    systematic: {} {} {} um{sure}",
            of.flank,
            of.characteristic,
            fixed(of.common_um, 3)
        );
    }
    if let Some(why) = &round.no_correction {
        let _ = writeln!(text, "    no correction: {why}");
    }
    let Some(correction) = &round.correction else { return };
    for setting in correction.settings.iter().filter(|setting| !setting.dropped) {
        let bound = if setting.at_bound { ", held by its bound" } else { "" };
        let _ = writeln!(text, "    turn {}: {}{bound}", setting.name, fixed(setting.change, 4));
    }
    for group in &correction.not_told_apart {
        let named: Vec<&str> = group.iter().map(|(name, _)| name.as_str()).collect();
        let _ = writeln!(
            text,
            "    the measured lines do not tell apart: {}; the smallest changes are given",
            named.join(", ")
        );
    }
    for (flank, proof) in &correction.proof {
        let _ = writeln!(
            text,
            "    the referee proves for the {flank} flank: rms {:.3} -> {:.3} um, largest {:.3} -> {:.3} um",
            proof.before.rms_um, proof.after.rms_um, proof.before.largest_um, proof.after.largest_um
        );
    }
}
