//! Uploaded measurements: files of measuring machines, evaluated alone, as a series, or against a job; in their place a part of the store.

use std::sync::Arc;

use axum::Json;
use axum::extract::State;
use axum::extract::multipart::{Field, Multipart, MultipartRejection};
use axum::http::StatusCode;
use flankwright::workflow::Task;
use flankwright_store::{RunFile, StoredMeasurement};
use serde::de::DeserializeOwned;

use super::error::{Answer, Refused};
use super::runs::{listed_name, taken};
use super::short::fit;
use crate::app::App;
use crate::shelf::MOST_FILES;
use crate::wire::{Failure, Finding, InspectOptions, Job, Request, RunBegun, wrong_option};

/// What a request is made of; for the interface document.
#[derive(utoipa::ToSchema)]
#[expect(dead_code, reason = "describes the parts of a multipart body")]
pub struct MeasurementsRequest {
    /// The files, at least one, unless a stored part is named.
    #[schema(value_type = Option<Vec<String>>, format = Binary)]
    file: Vec<Vec<u8>>,
    /// A part of the store in place of files: its number, or the beginning of its digest. What was stated when it was stored holds, unless the
    /// options state something.
    part: Option<String>,
    /// A job, as JSON.
    job: Option<String>,
    /// Options, as JSON.
    options: Option<String>,
}

fn wrong(field: &str, message: impl Into<String>, way_out: &str) -> Refused {
    Refused::bad(Failure::single(Finding::new("invalid-request", message, way_out).field(field)))
}

/// Evaluates measurements.
#[utoipa::path(post, path = "/api/measurements", operation_id = "begin_inspection",
    request_body(content = MeasurementsRequest, content_type = "multipart/form-data"),
    responses((status = 202, body = RunBegun), (status = 422, body = Failure), (status = 429, body = Failure)))]
pub async fn begin(
    State(app): State<Arc<App>>,
    parts: Result<Multipart, MultipartRejection>,
) -> Answer<(StatusCode, Json<RunBegun>)> {
    // As many as the memory holds; whoever comes late tries again.
    let _room = app.uploads.try_acquire().map_err(|_| Refused::busy("others hand in measurements"))?;
    let mut parts = parts?;
    let TakenIn { mut files, part, job, mut options } = match TakenIn::all_of(&mut parts).await {
        Ok(taken_in) => taken_in,
        Err(refused) => {
            // A browser listens only when everything is sent.
            while let Ok(Some(_)) = parts.next_field().await {}
            return Err(refused);
        }
    };
    if let Some(part) = part {
        if !files.is_empty() {
            return Err(wrong("part", "there are both a stored part and files", "send one of them"));
        }
        let StoredMeasurement { content, .. } = app.store.measurement(&part).await?;
        let stored = app.store.files_of(&content)?;
        files = stored.into_iter().map(|file| RunFile { name: file.name, bytes: file.bytes }).collect();
        // The run holds all that it needs: what becomes of the part later does not matter to it.
        options = Some(options.unwrap_or_default().with_stated(content.statements()));
    }
    if files.is_empty() {
        return Err(wrong(
            "file",
            "there is no measurement",
            "send at least one file of a measuring machine, or name a part of the store",
        ));
    }
    if let Some(Err((key, allowed))) = options.as_ref().map(InspectOptions::taken) {
        return Err(Refused::bad(wrong_option(key, allowed)));
    }
    if job.is_none() && options.as_ref().is_some_and(|options| options.blank) {
        let message = "the stock of a blank is that over the gear of a job";
        return Err(wrong("job", message, "send the job by which the gear is going to be ground"));
    }
    job.as_ref().map_or(Ok(()), fit)?;
    let first = files[0].name.clone();
    let name = if files.len() > 1 { format!("{first} and {} more", files.len() - 1) } else { first };
    taken(&app, Request { kind: Task::Inspect, job, options }, listed_name(&name), files).await
}

/// The parts of a request.
#[derive(Default)]
struct TakenIn {
    files: Vec<RunFile>,
    part: Option<String>,
    job: Option<Job>,
    options: Option<InspectOptions>,
}

impl TakenIn {
    async fn all_of(parts: &mut Multipart) -> Answer<Self> {
        let mut taken_in = Self::default();
        while let Some(part) = parts.next_field().await? {
            taken_in.take(part).await?;
        }
        Ok(taken_in)
    }

    async fn take(&mut self, part: Field<'_>) -> Answer<()> {
        match part.name() {
            Some("file") => {
                let file = measured(part, &self.files).await?;
                self.files.push(file);
            }
            Some("part") => {
                let text = part.text().await?;
                let named = Some(text.trim().to_owned()).filter(|text| !text.is_empty());
                once("part", &mut self.part, named)?;
            }
            Some("job") => once("job", &mut self.job, json("job", part).await?)?,
            Some("options") => once("options", &mut self.options, json("options", part).await?)?,
            other => {
                let message = format!("there is no part `{}`", other.unwrap_or_default());
                return Err(wrong("part", message, "send file or part, job, options"));
            }
        }
        Ok(())
    }
}

fn once<T>(name: &str, place: &mut Option<T>, given: Option<T>) -> Answer<()> {
    if place.is_some() && given.is_some() {
        return Err(wrong(name, format!("there are two parts `{name}`"), "send one of them"));
    }
    *place = given.or(place.take());
    Ok(())
}

/// A file under its bare name.
async fn measured(part: Field<'_>, before: &[RunFile]) -> Answer<RunFile> {
    let given = part.file_name().unwrap_or_default().to_owned();
    let name: String = given.rsplit(['/', '\\']).next().unwrap_or_default().to_owned();
    if name.is_empty() || name.starts_with('.') || name.len() > 120 || name.chars().any(char::is_control) {
        return Err(wrong(
            "file",
            "a measurement has no usable name",
            "give the file a name of at most 120 bytes",
        ));
    }
    if before.iter().any(|file| file.name == name) {
        return Err(wrong("file", format!("there are two files `{name}`"), "rename one of them"));
    }
    if before.len() >= MOST_MEASUREMENTS {
        let message = format!("more than {MOST_MEASUREMENTS} files at once");
        return Err(wrong(
            "file",
            message,
            "hand them in by portions, or use `flankwright inspect` on their folder",
        ));
    }
    Ok(RunFile { name, bytes: part.bytes().await?.to_vec() })
}

/// Measurements at once.
const MOST_MEASUREMENTS: usize = 8 * MOST_FILES;

async fn json<T: DeserializeOwned>(name: &str, part: Field<'_>) -> Answer<Option<T>> {
    let text = part.text().await?;
    if text.trim().is_empty() {
        return Ok(None);
    }
    let read = serde_json::from_str(&text);
    read.map(Some)
        .map_err(|error| wrong(name, format!("the part `{name}` cannot be read: {error}"), "send it as JSON"))
}
