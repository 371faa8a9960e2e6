//! Quick answers about a job: what is wrong with it, what follows from it, its plan without the referee.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Instant;

use axum::Json;
use axum::extract::State;
use axum::http::StatusCode;
use flankwright::exchange::{AnyJob, Document, Source};
use flankwright::workflow::{PreviewChart, derived_geometry, preview_job};

use super::error::{Answer, Refused};
use super::short::{shelved, short};
use super::take::Body;
use super::toml_edits::{Unedited, edited};
use crate::app::App;
use crate::shelf::{JOB, Shelf};
use crate::wire::{
    CheckAnswer, EditAnswer, EditRequest, Failure, Finding, Job, PreviewAnswer, PreviewRequest, refused_run,
};

/// What is wrong with a job, and what follows from it.
#[utoipa::path(post, path = "/api/check", request_body = Job, responses((status = 200, body = CheckAnswer),
    (status = 422, body = Failure)))]
pub async fn check(State(app): State<Arc<App>>, Body(job): Body<Job>) -> Answer<Json<CheckAnswer>> {
    let place = app.clone();
    short(&app, move |_| checked(&place, &job).map(Json)).await
}

fn checked(app: &App, job: &Job) -> Answer<CheckAnswer> {
    let shelf = shelved(app, job)?;
    let document = Source::from_bytes(JOB, job.text.as_bytes()).and_then(Document::parse).ok();
    let mut answer =
        CheckAnswer { tree: document.map(|document| document.to_value()), ..CheckAnswer::default() };
    match shelf.load(&job.text) {
        Ok(loaded) => follow(&loaded, job, &shelf, &mut answer),
        Err(error) => refuse(Failure::of_error(&error, &shelf), &mut answer),
    }
    Ok(answer)
}

fn refuse(failure: Failure, answer: &mut CheckAnswer) {
    answer.findings = failure.errors;
    answer.omitted = failure.omitted;
}

fn follow(loaded: &AnyJob, job: &Job, shelf: &Shelf, answer: &mut CheckAnswer) {
    answer.process = Some(loaded.info().process.name().to_owned());
    answer.name = Some(loaded.info().name.clone());
    match derived_geometry(loaded) {
        Ok((derived, warnings)) => {
            answer.valid = true;
            answer.warnings = warnings;
            answer.derived = derived.sections().to_vec();
        }
        Err(failure) => refuse(refused_run(&failure, &job.text, shelf), answer),
    }
}

/// A text with entries set or taken out; comments and order stay.
#[utoipa::path(post, path = "/api/edit", request_body = EditRequest, responses((status = 200, body = EditAnswer),
    (status = 422, body = Failure)))]
pub async fn edit(State(app): State<Arc<App>>, Body(request): Body<EditRequest>) -> Answer<Json<EditAnswer>> {
    short(&app, move |_| changed(&request).map(Json)).await
}

fn changed(request: &EditRequest) -> Answer<EditAnswer> {
    let refused = |error| Refused::bad(Failure::of_text(&error));
    Source::from_bytes(JOB, request.text.as_bytes()).map_err(refused)?;
    let text = edited(&request.text, &request.edits).map_err(|error| {
        let Unedited { path, why } = error;
        let finding = Finding::new("invalid-edit", why, "see the job schema for where the entry stands");
        Refused::bad(Failure::single(finding.field(&path)))
    })?;
    let document = Document::parse(Source::from_bytes(JOB, text.as_bytes()).map_err(refused)?);
    Ok(EditAnswer { tree: document.map_err(refused)?.to_value(), text })
}

/// The plan without the referee.
#[utoipa::path(post, path = "/api/preview", request_body = PreviewRequest, responses((status = 200, body = PreviewAnswer),
    (status = 422, body = Failure)))]
pub async fn preview(
    State(app): State<Arc<App>>,
    Body(request): Body<PreviewRequest>,
) -> Answer<Json<PreviewAnswer>> {
    let charts = request.charts.iter().map(|name| chart(name)).collect::<Answer<Vec<_>>>()?;
    let place = app.clone();
    short(&app, move |_| previewed(&place, &request.job, &charts).map(Json)).await
}

fn chart(name: &str) -> Answer<(&'static str, PreviewChart)> {
    PreviewChart::ALL.into_iter().find(|(known, _)| *known == name).ok_or_else(|| {
        let names: Vec<&str> = PreviewChart::ALL.iter().map(|(name, _)| *name).collect();
        let finding =
            Finding::new("unknown-chart", format!("there is no chart `{name}`"), "choose one of these");
        let finding = finding.field("charts").allowed(names.join(", "));
        Refused(StatusCode::UNPROCESSABLE_ENTITY, Failure::single(finding))
    })
}

fn previewed(app: &App, job: &Job, charts: &[(&'static str, PreviewChart)]) -> Answer<PreviewAnswer> {
    let begun = Instant::now();
    let shelf = shelved(app, job)?;
    let loaded = shelf.load(&job.text).map_err(|error| Refused::bad(Failure::of_error(&error, &shelf)))?;
    let preview =
        preview_job(&loaded).map_err(|failure| Refused::bad(refused_run(&failure, &job.text, &shelf)))?;
    let mut drawn = BTreeMap::new();
    for (name, chart) in charts {
        let svg =
            preview.chart(*chart).map_err(|error| Refused::bad(Failure::internal(error.to_string())))?;
        if let Some(svg) = svg {
            drawn.insert((*name).to_owned(), svg.as_str().to_owned());
        }
    }
    Ok(PreviewAnswer { preview, charts: drawn, milliseconds: begun.elapsed().as_secs_f64() * 1e3 })
}
