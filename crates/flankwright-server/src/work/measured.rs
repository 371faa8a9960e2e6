//! Uploaded measurements: one gear or a series, alone or against a job, a blank before grinding, and switching angles of a skiving tool.

use std::fs;
use std::path::{Path, PathBuf};

use flankwright::exchange::{AnyJob, Job as GrindingJob, MillingJob, SkivingJob};
use flankwright::numerics::Progress;
use flankwright::workflow::inspection::series::{
    PartsOfFolder, SeriesOptions, inspect_series, measured_parts_in, write_inspection_series,
};
use flankwright::workflow::inspection::{
    LeftOutFile, blank_of_file, inspect_bevel, inspect_for_job, inspect_for_milling, inspect_gear,
    write_bevel_inspection, write_blank, write_gear_inspection,
};
use flankwright::workflow::skiving::{inspect_skiving, write_skiving};
use flankwright::workflow::{JobFailure, WriteError};
use flankwright_store::{RunFile, StoreAddress};
use serde_json::Value;

use super::keep::keep;
use super::unwritten::unwritten;
use crate::shelf::Shelf;
use crate::wire::{Asked, Failure, Finding, HandedIn, Request, refused_run, wrong_option};

/// Why a measurement has no result.
enum Unmeasured {
    Refused(JobFailure),
    Unwritten(WriteError),
    Wrong(Box<Failure>),
}

impl<F: Into<JobFailure>> From<F> for Unmeasured {
    fn from(failure: F) -> Self {
        Self::Refused(failure.into())
    }
}

/// The document of measurements; results are on the shelf then. What became of the files stands in the document too ([`HandedIn`]).
pub(super) fn measured(
    request: &Request,
    inputs: &[RunFile],
    shelf: &Shelf,
    place: &StoreAddress,
    progress: &dyn Progress,
) -> Result<Value, Failure> {
    let folder = shelf.measured();
    let put = |file: &RunFile| fs::write(folder.join(&file.name), &file.bytes);
    fs::create_dir(&folder)
        .and_then(|()| inputs.iter().try_for_each(put))
        .map_err(|error| Failure::disk(&error))?;
    let text = request.job.as_ref().map_or("", |job| job.text.as_str());
    let job = request.job.as_ref().map(|job| shelf.load(&job.text)).transpose();
    let job = job.map_err(|error| Failure::of_error(&error, shelf))?;
    let options = request.options.clone().unwrap_or_default();
    let asked = options.taken().map_err(|(key, allowed)| wrong_option(key, allowed))?;
    let document = if let Some(loaded) = job.as_ref().and_then(AnyJob::of::<SkivingJob>) {
        if options.is_about_gears() {
            return Err(wrong_option(
                "options",
                "nothing but a language for a skiving tool: they are about measured gears",
            ));
        }
        let mut loaded = loaded.clone();
        loaded.job.output.language = asked.language.unwrap_or(loaded.job.output.language);
        (|| {
            let file = only_file(&folder).ok_or_else(|| several("switching angles"))?;
            let outcome = inspect_skiving(&loaded, &file, progress)?;
            write_skiving(&outcome, &shelf.results()).map_err(Unmeasured::Unwritten)?;
            Ok((json(&outcome.result)?, Vec::new()))
        })()
    } else if options.blank {
        blank(&folder, &shelf.results(), job.as_ref(), &asked)
    } else {
        gears(&folder, &shelf.results(), job.as_ref(), &asked, progress)
    };
    let (mut document, left_out) = document.map_err(|failure| match failure {
        Unmeasured::Refused(failure) => refused_run(&failure, text, shelf),
        Unmeasured::Unwritten(error) => unwritten(&error),
        Unmeasured::Wrong(failure) => *failure,
    })?;
    let kept =
        options.keep.then(|| keep(&folder, &options, asked.statements, place, progress)).transpose()?;
    let handed_in = serde_json::to_value(HandedIn { kept, left_out });
    let handed_in = handed_in.map_err(|error| Failure::internal(error.to_string()))?;
    if let (Value::Object(document), Value::Object(more)) = (&mut document, handed_in) {
        document.extend(more);
    }
    Ok(document)
}

/// The document, and what was uploaded beside the measurements where the document does not tell.
fn gears(
    folder: &Path,
    results: &Path,
    job: Option<&AnyJob>,
    asked: &Asked,
    progress: &dyn Progress,
) -> Result<(Value, Vec<LeftOutFile>), Unmeasured> {
    let Asked { sheet, statements, language } = asked;
    // With a job a table of traces will do, which by itself tells of no gear.
    let alone = job.is_some().then(|| only_file(folder)).flatten();
    let found = match alone {
        Some(file) => PartsOfFolder { parts: vec![file], left_out: Vec::new() },
        None => measured_parts_in(folder)?,
    };
    let grinding = job.and_then(AnyJob::of::<GrindingJob>);
    let milling = job.and_then(AnyJob::of::<MillingJob>);
    if let (Some(loaded), [one]) =
        (milling.filter(|loaded| loaded.job.bevel.is_some()), found.parts.as_slice())
    {
        let mut bevel = inspect_bevel(loaded, one, sheet.tolerance_class, progress)?;
        bevel.language = language.unwrap_or(bevel.language);
        write_bevel_inspection(&bevel, results).map_err(Unmeasured::Unwritten)?;
        return Ok((json(&bevel.result)?, found.left_out));
    }
    let mut gear = match (job, grinding, found.parts.as_slice()) {
        (None, _, [one]) => inspect_gear(one, statements, sheet.tolerance_class)?,
        (Some(_), Some(loaded), [one]) => {
            inspect_for_job(loaded, one, statements, sheet.tolerance_class, progress)?
        }
        (Some(_), Some(_), _) => return Err(several("the gear")),
        (Some(_), None, parts) => match (milling, parts) {
            (Some(loaded), [one]) => {
                inspect_for_milling(loaded, one, statements, sheet.tolerance_class, progress)?
            }
            (Some(_), _) => return Err(several("the gear")),
            (None, _) => return Err(other_process()),
        },
        (None, _, _) => {
            let options = SeriesOptions {
                sheet: sheet.clone(),
                statements: statements.clone(),
                left_out: found.left_out,
                language: language.unwrap_or_default(),
                ..SeriesOptions::default()
            };
            let series = inspect_series(&found.parts, &options)?;
            write_inspection_series(&series, results).map_err(Unmeasured::Unwritten)?;
            return Ok((json(&series.result)?, Vec::new()));
        }
    };
    gear.language = language.unwrap_or(gear.language);
    write_gear_inspection(&gear, sheet, results).map_err(Unmeasured::Unwritten)?;
    Ok((json(&gear.result)?, found.left_out))
}

/// The document of the stock of a blank.
fn blank(
    folder: &Path,
    results: &Path,
    job: Option<&AnyJob>,
    asked: &Asked,
) -> Result<(Value, Vec<LeftOutFile>), Unmeasured> {
    let loaded = job.and_then(AnyJob::of::<GrindingJob>).ok_or_else(other_process)?;
    let (file, left_out) = match only_file(folder) {
        Some(file) => (file, Vec::new()),
        // Curves and values of one part are two files.
        None => match measured_parts_in(folder)? {
            PartsOfFolder { parts, left_out } if parts.len() == 1 => (parts[0].clone(), left_out),
            _ => return Err(several("the blank")),
        },
    };
    let found = blank_of_file(loaded, &file, &asked.statements)?;
    write_blank(&found, results).map_err(Unmeasured::Unwritten)?;
    Ok((json(&found.result)?, left_out))
}

fn other_process() -> Unmeasured {
    let finding = Finding::new(
        "process-not-available",
        "measured gears are compared with a job of generating grinding or five-axis milling",
        "leave the job out, or take the one by which the gear was made",
    );
    Unmeasured::Wrong(Box::new(Failure::single(finding.field("job.process"))))
}

fn json(value: &impl serde::Serialize) -> Result<Value, Unmeasured> {
    serde_json::to_value(value)
        .map_err(|error| Unmeasured::Wrong(Box::new(Failure::internal(error.to_string()))))
}

fn several(what: &str) -> Unmeasured {
    let message = format!("with a job, exactly one measurement of {what} is evaluated");
    let finding =
        Finding::new("several-measurements", message, "hand in one, or leave the job out for a series");
    Unmeasured::Wrong(Box::new(Failure::single(finding.field("file"))))
}

fn only_file(folder: &Path) -> Option<PathBuf> {
    let mut files = fs::read_dir(folder).ok()?.flatten().map(|entry| entry.path());
    let first = files.next()?;
    files.next().is_none().then_some(first)
}
