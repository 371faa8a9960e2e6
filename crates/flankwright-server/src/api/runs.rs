//! Runs: begun, listed, cancelled, begun again, taken out.

use std::sync::Arc;

use axum::Json;
use axum::extract::State;
use axum::http::header::{CACHE_CONTROL, ETAG, IF_NONE_MATCH};
use axum::http::{HeaderMap, StatusCode};
use axum::response::{IntoResponse, Response};
use flankwright::exchange::{Document, Source};
use flankwright_store::{RunFile as StoredFile, RunRecord, RunState, RunSummary};
use serde::Deserialize;
use serde_json::Value;

use super::error::{Answer, Refused};
use super::short::{fit, short};
use super::take::{Body, InPath, InQuery, bounded};
use crate::app::App;
use crate::shelf::JOB;
use crate::wire::{Failure, Job, ListedRun, NewRunRequest, Request, Run, RunBegun, RunFile, RunStateAnswer};
use crate::work::{Cancelled, NotTaken, SCENE, Told};

/// Runs in a list unless more are asked for.
const LISTED: u32 = 100;
/// Most of them.
const MOST_LISTED: u32 = 1000;

/// Letters of a name in lists; the rest is marked as left out.
const LONGEST_NAME: usize = 120;

/// How many are listed.
#[derive(Debug, Deserialize, utoipa::IntoParams)]
#[into_params(parameter_in = Query)]
#[serde(deny_unknown_fields)]
pub struct Most {
    /// Runs in the list, 1 to 1000.
    #[param(minimum = 1, maximum = 1000)]
    pub most: Option<u32>,
}

/// A name for a list, from a text that may be wrong otherwise.
fn name_of(job: &Job) -> Option<String> {
    let tree = Document::parse(Source::new(JOB, &job.text)).ok()?.to_value();
    tree.pointer("/job/name").and_then(Value::as_str).map(listed_name)
}

/// A name as lists show it.
pub(super) fn listed_name(name: &str) -> String {
    let name = name.replace(char::is_control, " ");
    let end = name.char_indices().nth(LONGEST_NAME).map(|(end, _)| end);
    end.map_or(name.clone(), |end| format!("{}...", &name[..end]))
}

pub(super) async fn taken(
    app: &App,
    request: Request,
    name: String,
    inputs: Vec<StoredFile>,
) -> Answer<(StatusCode, Json<RunBegun>)> {
    match app.work.take(&request, name, inputs).await {
        Ok(id) => Ok((StatusCode::ACCEPTED, Json(RunBegun { id }))),
        Err(NotTaken::Full) => Err(Refused::with(
            StatusCode::TOO_MANY_REQUESTS,
            "queue-full",
            format!("{} runs wait already", app.work.queue().waiting),
            "wait for some of them to end, or cancel them",
        )),
        Err(NotTaken::Ending) => Err(Refused::busy("the server ends")),
        Err(NotTaken::Unkept(why)) => Err(Refused::bad(Failure::internal(why))),
        Err(NotTaken::Store(error)) => Err(error.into()),
    }
}

/// Begins a run.
#[utoipa::path(post, path = "/api/runs", operation_id = "begin_run", request_body = NewRunRequest,
    responses((status = 202, body = RunBegun), (status = 422, body = Failure), (status = 429, body = Failure)))]
pub async fn begin(
    State(app): State<Arc<App>>,
    Body(request): Body<NewRunRequest>,
) -> Answer<(StatusCode, Json<RunBegun>)> {
    // Names of files are looked at now, while somebody listens.
    let (request, name) = short(&app, move |_| {
        fit(&request.job)?;
        let name = name_of(&request.job).unwrap_or_else(|| "unnamed".to_owned());
        Ok((request, name))
    })
    .await?;
    let request = Request { kind: request.kind, job: Some(request.job), options: None };
    taken(&app, request, name, Vec::new()).await
}

/// Whether a file of a run is a result, not something that the server keeps beside it.
pub(super) fn is_listed(name: &str) -> bool {
    !name.starts_with('.')
}

/// `told` was read before the summary was read: what the store says to have ended, has.
fn listed(told: Option<Told>, mut summary: RunSummary) -> ListedRun {
    let told = told.filter(|_| !summary.state.has_ended());
    if let Some(told) = &told {
        summary.state = told.state;
    }
    let progress = told.filter(|told| told.state == RunState::Running).map(|told| told.advance);
    ListedRun { summary, progress }
}

/// Runs, the newest first.
#[utoipa::path(get, path = "/api/runs", operation_id = "runs", params(Most), responses((status = 200, body = [ListedRun]),
    (status = 422, body = Failure)))]
pub async fn list(State(app): State<Arc<App>>, InQuery(most): InQuery<Most>) -> Answer<Json<Vec<ListedRun>>> {
    let most = bounded("most", most.most.unwrap_or(LISTED), MOST_LISTED)?;
    let mut told = app.work.all_told();
    let runs = app.store.runs(most).await?;
    Ok(Json(runs.into_iter().map(|run| listed(told.remove(&run.id), run)).collect()))
}

pub(super) async fn record(app: &App, id: i64) -> Answer<RunRecord> {
    app.store.run(id).await?.ok_or_else(|| Refused::absent("run"))
}

/// A run with its result. A finished run does not change: a request with its `ETag` gets 304.
#[utoipa::path(get, path = "/api/runs/{id}", operation_id = "run", params(("id" = i64, Path, description = "its number")),
    responses((status = 200, body = Run), (status = 304), (status = 404, body = Failure)))]
pub async fn one(
    State(app): State<Arc<App>>,
    InPath(id): InPath<i64>,
    headers: HeaderMap,
) -> Answer<Response> {
    let known = headers.get(IF_NONE_MATCH).and_then(|tag| tag.to_str().ok());
    if let Some(known) = known {
        let run = app.store.run_summary(id).await?.ok_or_else(|| Refused::absent("run"))?;
        if tag(&run).is_some_and(|tag| tag == known) {
            return Ok(StatusCode::NOT_MODIFIED.into_response());
        }
    }
    let run = whole(&app, id).await?;
    let tagged =
        tag(&run.summary.summary).map(|tag| [(ETAG, tag), (CACHE_CONTROL, "private, no-cache".into())]);
    Ok((tagged, Json(run)).into_response())
}

/// What a run that has ended is known by.
fn tag(run: &RunSummary) -> Option<String> {
    let RunSummary { id, state, ended, .. } = run;
    let ended = ended.as_ref().filter(|_| state.has_ended())?;
    Some(format!("\"{}-{id}-{}-{ended}\"", env!("CARGO_PKG_VERSION"), state.name()))
}

async fn whole(app: &App, id: i64) -> Answer<Run> {
    let told = app.work.live(id).map(|live| live.told());
    let record = record(app, id).await?;
    let measurements = app.store.run_input_names(id).await?;
    let request: Option<Request> = serde_json::from_str(&record.job).ok();
    let charts = super::charts::placed(app, id).await?.into_iter().map(|placed| placed.chart).collect();
    let failed = record.summary.state == RunState::Failed;
    let (failure, document) = match record.document {
        Some(document) if failed => (serde_json::from_value(document).ok(), None),
        document => (None, document),
    };
    Ok(Run {
        summary: listed(told, record.summary),
        job: request.and_then(|request| request.job),
        measurements,
        document,
        failure,
        scene: record.files.iter().any(|file| file.name == SCENE),
        files: record
            .files
            .into_iter()
            .filter(|file| is_listed(&file.name))
            .map(|file| RunFile { name: file.name, bytes: file.bytes })
            .collect(),
        charts,
    })
}

/// Ends a run at its next step.
#[utoipa::path(post, path = "/api/runs/{id}/cancel", params(("id" = i64, Path, description = "its number")),
    responses((status = 200, body = RunStateAnswer), (status = 404, body = Failure), (status = 409, body = Failure)))]
pub async fn cancel(State(app): State<Arc<App>>, InPath(id): InPath<i64>) -> Answer<Json<RunStateAnswer>> {
    let state = match app.work.cancel(id).await {
        Cancelled::Told(state) => state,
        Cancelled::NotHere => match state_of(&app, id).await? {
            state if state.has_ended() => state,
            state => {
                return Err(Refused::with(
                    StatusCode::CONFLICT,
                    "run-elsewhere",
                    format!("the run {id} is {state} on another server", state = state.name()),
                    "cancel it there; if that server is gone, the run is interrupted within two minutes",
                ));
            }
        },
    };
    Ok(Json(RunStateAnswer { state }))
}

/// The state of a run that is none of this server's that waits or is under way.
pub(super) async fn state_of(app: &App, id: i64) -> Answer<RunState> {
    app.store.run_summary(id).await?.map(|run| run.state).ok_or_else(|| Refused::absent("run"))
}

/// Begins a run of the same job.
#[utoipa::path(post, path = "/api/runs/{id}/again", params(("id" = i64, Path, description = "its number")),
    responses((status = 202, body = RunBegun), (status = 404, body = Failure), (status = 429, body = Failure)))]
pub async fn again(
    State(app): State<Arc<App>>,
    InPath(id): InPath<i64>,
) -> Answer<(StatusCode, Json<RunBegun>)> {
    let record = record(&app, id).await?;
    let request: Request = serde_json::from_str(&record.job)
        .map_err(|error| Refused::bad(Failure::internal(format!("the run {id} cannot be read: {error}"))))?;
    let inputs = app.store.run_inputs(id).await?;
    taken(&app, request, record.summary.name, inputs).await
}

/// Takes a run out that has ended.
#[utoipa::path(delete, path = "/api/runs/{id}", params(("id" = i64, Path, description = "its number")),
    responses((status = 204), (status = 404, body = Failure), (status = 409, body = Failure)))]
pub async fn remove(State(app): State<Arc<App>>, InPath(id): InPath<i64>) -> Answer<StatusCode> {
    if app.store.remove_run(id).await? {
        return Ok(StatusCode::NO_CONTENT);
    }
    let state = state_of(&app, id).await?.name();
    Err(Refused::with(
        StatusCode::CONFLICT,
        "run-under-way",
        format!("the run {id} is {state}"),
        "cancel it, and take it out when it has ended",
    ))
}
