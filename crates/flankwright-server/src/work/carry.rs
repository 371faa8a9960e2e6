//! Carries one run out: puts its files down, has the workflow do what was asked, takes the results up. Whatever goes wrong becomes the end
//! of that run and of no other.

use std::fs;
use std::io;

use flankwright::numerics::Progress;
use flankwright::workflow::cancel::{self, Ended};
use flankwright::workflow::scene::Scene;
use flankwright::workflow::{JobFailure, RunFailure, carry_out, write_refusal};
use flankwright_store::{RunEnd, RunFile, RunState, StoreAddress};
use flate2::Compression;
use flate2::write::GzEncoder;
use serde_json::Value;

use super::end::failed;
use super::unwritten::unwritten;
use super::{CHARTS, Live, SCENE, ended, measured, now};
use crate::charts;
use crate::log::say;
use crate::scratch::Scratch;
use crate::shelf::Shelf;
use crate::wire::{Failure, Finding, Job, Request, refused_run, unshelved};

/// What is to be done, as the store keeps it.
pub(super) struct Task {
    /// The request, JSON.
    pub request: String,
    /// Uploaded files.
    pub inputs: Vec<RunFile>,
}

/// Why a run has no result, and what it has written all the same: the report of a job that its bodies cannot make.
struct Stopped {
    failure: Failure,
    files: Vec<RunFile>,
}

impl From<Failure> for Stopped {
    fn from(failure: Failure) -> Self {
        Self { failure, files: Vec::new() }
    }
}

/// The end of a run.
pub(super) fn carry(task: &Task, live: &Live, place: &StoreAddress, scratch: &Scratch) -> RunEnd {
    match cancel::run(live.cancelled(), live, |progress| carried(task, place, scratch, progress)) {
        Ended::Done(Ok((document, files))) => {
            RunEnd { state: RunState::Done, ended: now(), document: Some(document), files }
        }
        Ended::Done(Err(stopped)) => RunEnd { files: stopped.files, ..failed(&stopped.failure) },
        Ended::Cancelled => ended(live.ended_as()),
        Ended::Failed(words) => failed(&Failure::internal(scratch.tell(&words))),
    }
}

fn carried(
    task: &Task,
    place: &StoreAddress,
    scratch: &Scratch,
    progress: &dyn Progress,
) -> Result<(Value, Vec<RunFile>), Stopped> {
    let request: Request = serde_json::from_str(&task.request)
        .map_err(|error| Failure::internal(format!("the run cannot be read: {error}")))?;
    let none = Job::default();
    let job = request.job.as_ref().unwrap_or(&none);
    let shelf = Shelf::of_job(scratch, &job.text, &job.files);
    let shelf = shelf.map_err(|error| unshelved(&error))?;
    let (document, hidden) = if task.inputs.is_empty() {
        done(&request, &shelf, progress).map_err(|failure| {
            // The failure is told whatever becomes of its files.
            let files = results(&shelf, request.job.as_ref()).unwrap_or_default();
            Stopped { failure, files: with_charts(files).unwrap_or_default() }
        })?
    } else {
        (measured::measured(&request, &task.inputs, &shelf, place, progress)?, Vec::new())
    };
    let unread =
        |error: io::Error| Failure::internal(format!("the results cannot be read: {}", error.kind()));
    let mut files = with_charts(results(&shelf, request.job.as_ref()).map_err(unread)?)?;
    files.extend(hidden);
    Ok((told(document, &shelf), files))
}

/// Files of a run and, not listed, which charts they hold and where; none where there is no file.
fn with_charts(mut files: Vec<RunFile>) -> Result<Vec<RunFile>, Failure> {
    if files.is_empty() {
        return Ok(files);
    }
    let placed = charts::of_result(|name| {
        files.iter().find(|file| file.name == name).map(|file| file.bytes.as_slice())
    });
    let placed = serde_json::to_vec(&placed).map_err(|error| Failure::internal(error.to_string()))?;
    files.push(RunFile { name: CHARTS.to_owned(), bytes: placed });
    Ok(files)
}

/// The document of a job, and files that are not listed.
fn done(request: &Request, shelf: &Shelf, progress: &dyn Progress) -> Result<(Value, Vec<RunFile>), Failure> {
    let Some(Job { text, .. }) = &request.job else {
        return Err(Failure::single(
            Finding::new("missing-key", "there is no job", "hand in a job").field("job"),
        ));
    };
    let job = shelf.load(text).map_err(|error| Failure::of_error(&error, shelf))?;
    let told = |failure: JobFailure| refused_run(&failure, text, shelf);
    let completed = carry_out(request.kind, &job, progress);
    if let Err(JobFailure::Job(RunFailure::NotProducible(finding))) = &completed {
        write_refusal(&job, finding, &shelf.results()).map_err(|error| unwritten(&error))?;
    }
    let completed = completed.map_err(told)?;
    completed.write(&shelf.results()).map_err(|error| unwritten(&error))?;
    let document = completed.document().map_err(|error| Failure::internal(error.to_string()))?;
    // A result without its view in space is a result all the same.
    let scene = completed.scene().and_then(|scene| match scene.map_err(JobFailure::from) {
        Ok(scene) => {
            packed(&scene).inspect_err(|error| say(format!("a scene cannot be packed: {error}"))).ok()
        }
        Err(failure) => {
            let told = told(failure);
            say(format!("a scene cannot be drawn: {}", told.errors[0].message));
            None
        }
    });
    Ok((document, scene.map(|bytes| RunFile { name: SCENE.to_owned(), bytes }).into_iter().collect()))
}

/// The scene as it goes over the wire.
fn packed(scene: &Scene) -> io::Result<Vec<u8>> {
    let mut packing = GzEncoder::new(Vec::new(), Compression::default());
    serde_json::to_writer(&mut packing, scene)?;
    packing.finish()
}

/// The results without the place of the shelf. Files of the job that the run has added to, such as the history of a tool, are among them.
fn results(shelf: &Shelf, job: Option<&Job>) -> io::Result<Vec<RunFile>> {
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
