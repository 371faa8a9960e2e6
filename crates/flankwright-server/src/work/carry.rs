//! Carries one run out: puts its files down, has the workflow do what was asked, takes the results up. Whatever goes wrong becomes the end
//! of that run and of no other.

use std::fs;
use std::path::Path;

use flankwright::exchange::AnyJob;
use flankwright::numerics::Progress;
use flankwright::workflow::inspection::series::{
    PartsOfFolder, SeriesOptions, inspect_series, measured_parts_in, write_inspection_series,
};
use flankwright::workflow::inspection::{
    SheetOptions, Statements, inspect_for_job, inspect_gear, write_gear_inspection,
};
use flankwright::workflow::scene::Scene;
use flankwright::workflow::skiving::{inspect_skiving, write_skiving};
use flankwright::workflow::{JobFailure, WriteError, carry_out};
use flankwright_store::{RunEnd, RunFile, RunState, StoreAddress};
use flate2::Compression;
use flate2::write::GzEncoder;
use serde_json::Value;

use super::cancel::{self, Ended};
use super::{SCENE, Task, ended, now};
use crate::shelf::Shelf;
use crate::wire::{Failure, Finding, InspectOptions, Job, Request, refused_run};
use crate::work::keep::keep;

/// Where measurements lie on the shelf.
const MEASURED: &str = "measured";

/// The end of a run.
pub(super) fn carry(task: &Task, place: &StoreAddress) -> RunEnd {
    let shelf = match shelf_of(task) {
        Ok(shelf) => shelf,
        Err(failure) => return failed(&failure),
    };
    let done = cancel::run(task.live.cancelled(), &*task.live, |progress| {
        done(&task.request, !task.inputs.is_empty(), &shelf, place, progress)
    });
    match done {
        Ended::Done(Ok((document, scene))) => match results(&shelf, task.request.job.as_ref()) {
            Ok(mut files) => {
                files.extend(scene.map(|bytes| RunFile { name: SCENE.to_owned(), bytes }));
                RunEnd { state: RunState::Done, ended: now(), document: Some(told(document, &shelf)), files }
            }
            Err(error) => failed(&Failure::internal(format!("the results cannot be read: {error}"))),
        },
        Ended::Done(Err(failure)) => failed(&failure),
        Ended::Cancelled => ended(task.live.ended_as()),
        Ended::Failed(words) => failed(&Failure::internal(shelf.tell(&words))),
    }
}

fn failed(failure: &Failure) -> RunEnd {
    RunEnd { document: serde_json::to_value(failure).ok(), ..ended(RunState::Failed) }
}

fn shelf_of(task: &Task) -> Result<Shelf, Failure> {
    let job = task.request.job.clone().unwrap_or_default();
    let shelf = Shelf::new(&job).map_err(|error| unshelved(&error))?;
    for file in &task.inputs {
        shelf.put(&format!("{MEASURED}/{}", file.name), &file.bytes).map_err(|error| unshelved(&error))?;
    }
    Ok(shelf)
}

/// Files that cannot be put down.
pub fn unshelved(error: &crate::shelf::ShelfError) -> Failure {
    let finding = Finding::new("invalid-file-name", error.to_string(), "rename the file, or leave it out")
        .field("files");
    Failure::single(finding)
}

/// The document, and the scene where there is one.
type Done = (Value, Option<Vec<u8>>);

fn done(
    request: &Request,
    measured: bool,
    shelf: &Shelf,
    place: &StoreAddress,
    progress: &dyn Progress,
) -> Result<Done, Failure> {
    let text = request.job.as_ref().map(|job| job.text.as_str());
    let job =
        text.map(|text| shelf.load(text).map_err(|error| Failure::of_error(&error, shelf))).transpose()?;
    let told = |failure: JobFailure| refused_run(&failure, text.unwrap_or_default(), shelf);
    let results = shelf.results();
    if measured {
        let options = request.options.clone().unwrap_or_default();
        let (sheet, statements) = options.taken().map_err(|(key, allowed)| wrong_option(key, allowed))?;
        let document = measurement(shelf, job.as_ref(), &sheet, &statements, progress)
            .map_err(|failure| failure.told(&told))?;
        if options.keep {
            keep(&shelf.path().join(MEASURED), &options, statements, place, progress)?;
        }
        return Ok((document, None));
    }
    let Some(job) = job else {
        return Err(Failure::single(
            Finding::new("missing-key", "there is no job", "hand in a job").field("job"),
        ));
    };
    let completed = carry_out(request.kind.task(), &job, progress).map_err(told)?;
    completed.write(&results).map_err(|error| unwritten(&error))?;
    let document = completed.document().map_err(|error| Failure::internal(error.to_string()))?;
    // A result without its view in space is a result all the same.
    let scene = completed.scene().and_then(|scene| match scene.map_err(JobFailure::from) {
        Ok(scene) => packed(&scene).inspect_err(|error| eprintln!("a scene cannot be packed: {error}")).ok(),
        Err(failure) => {
            let told = told(failure);
            eprintln!("a scene cannot be drawn: {}", told.errors[0].message);
            None
        }
    });
    Ok((document, scene))
}

/// The scene as it goes over the wire.
fn packed(scene: &Scene) -> std::io::Result<Vec<u8>> {
    let mut packing = GzEncoder::new(Vec::new(), Compression::default());
    serde_json::to_writer(&mut packing, scene)?;
    packing.finish()
}

/// An option that is none.
pub fn wrong_option(key: &str, allowed: &str) -> Failure {
    let finding =
        Finding::new("invalid-option", format!("the option {key} takes {allowed}"), "choose one of these");
    Failure::single(finding.field(key).allowed(allowed))
}

fn unwritten(error: &WriteError) -> Failure {
    Failure::internal(format!("the results cannot be written: {error}"))
}

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

impl Unmeasured {
    fn told(self, told: &dyn Fn(JobFailure) -> Failure) -> Failure {
        match self {
            Self::Refused(failure) => told(failure),
            Self::Unwritten(error) => unwritten(&error),
            Self::Wrong(failure) => *failure,
        }
    }
}

fn measurement(
    shelf: &Shelf,
    job: Option<&AnyJob>,
    sheet: &SheetOptions,
    statements: &Statements,
    progress: &dyn Progress,
) -> Result<Value, Unmeasured> {
    let results = shelf.results();
    let folder = shelf.path().join(MEASURED);
    if let Some(AnyJob::Skiving(loaded)) = job {
        let file = only_file(&folder).ok_or_else(|| several("switching angles"))?;
        let outcome = inspect_skiving(loaded, &file, progress)?;
        write_skiving(&loaded.job, &outcome, &results).map_err(Unmeasured::Unwritten)?;
        return document(&outcome.result);
    }
    // With a job a table of traces will do, which by itself tells of no gear.
    let alone = job.is_some().then(|| only_file(&folder)).flatten();
    let found = match alone {
        Some(file) => PartsOfFolder { parts: vec![file], left_out: Vec::new() },
        None => measured_parts_in(&folder)?,
    };
    let found = match (job, found.parts.as_slice()) {
        (None, [one]) => inspect_gear(one, statements)?,
        (Some(AnyJob::Grinding(loaded)), [one]) => inspect_for_job(loaded, one, statements, progress)?,
        (Some(AnyJob::Grinding(_)), _) => return Err(several("the gear")),
        (Some(_), _) => {
            let finding = Finding::new(
                "process-not-available",
                "measured gears are compared with a job of generating grinding",
                "leave the job out, or take the one by which the gear was ground",
            );
            return Err(Unmeasured::Wrong(Box::new(Failure::single(finding.field("job.process")))));
        }
        (None, _) => {
            let options = SeriesOptions {
                sheet: sheet.clone(),
                statements: statements.clone(),
                left_out: found.left_out,
                ..SeriesOptions::default()
            };
            let series = inspect_series(&found.parts, &options)?;
            write_inspection_series(&series, &results).map_err(Unmeasured::Unwritten)?;
            return document(&series.result);
        }
    };
    write_gear_inspection(&found, sheet, &results).map_err(Unmeasured::Unwritten)?;
    document(&found.result)
}

fn document(result: &impl serde::Serialize) -> Result<Value, Unmeasured> {
    serde_json::to_value(result)
        .map_err(|error| Unmeasured::Wrong(Box::new(Failure::internal(error.to_string()))))
}

fn several(what: &str) -> Unmeasured {
    let message = format!("with a job, exactly one measurement of {what} is evaluated");
    let finding =
        Finding::new("several-measurements", message, "hand in one, or leave the job out for a series");
    Unmeasured::Wrong(Box::new(Failure::single(finding.field("file"))))
}

fn only_file(folder: &Path) -> Option<std::path::PathBuf> {
    let mut files = fs::read_dir(folder).ok()?.flatten().map(|entry| entry.path());
    let first = files.next()?;
    files.next().is_none().then_some(first)
}

/// The results without the place of the shelf. Files of the job that the run has added to, such as the history of a tool, are among them.
fn results(shelf: &Shelf, job: Option<&Job>) -> std::io::Result<Vec<RunFile>> {
    let cleaned = |bytes: Vec<u8>| match String::from_utf8(bytes) {
        Ok(text) => shelf.tell(&text).into_bytes(),
        Err(binary) => binary.into_bytes(),
    };
    let written = shelf.written()?.into_iter();
    let mut files: Vec<RunFile> =
        written.map(|(name, bytes)| RunFile { name, bytes: cleaned(bytes) }).collect();
    for (name, text) in job.iter().flat_map(|job| &job.files) {
        let bytes = fs::read(shelf.source("").beside(name))?;
        if bytes != text.as_bytes() && files.iter().all(|file| file.name != *name) {
            files.push(RunFile { name: name.clone(), bytes });
        }
    }
    Ok(files)
}

fn told(document: Value, shelf: &Shelf) -> Value {
    match document {
        Value::String(text) => Value::String(shelf.tell(&text)),
        Value::Array(items) => items.into_iter().map(|item| told(item, shelf)).collect(),
        Value::Object(keys) => keys.into_iter().map(|(key, value)| (key, told(value, shelf))).collect(),
        other => other,
    }
}

/// Options of measurements that were handed in.
pub fn checked(options: &InspectOptions) -> Result<(), Failure> {
    options.taken().map(|_| ()).map_err(|(key, allowed)| wrong_option(key, allowed))
}
