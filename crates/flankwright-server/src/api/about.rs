//! The program, its interface, its schema.

use std::sync::{Arc, LazyLock};

use axum::Json;
use axum::extract::State;
use axum::http::header::{CACHE_CONTROL, CONTENT_TYPE};
use axum::response::{IntoResponse, Response};
use flankwright::exchange::job_schema;
use flankwright::processes;
use flankwright::workflow::AnyProcess;

use crate::app::App;
use crate::wire::{About, ProcessSummary};

/// Version, processes, how busy the server is.
#[utoipa::path(get, path = "/api/about", responses((status = 200, body = About)))]
pub async fn about(State(app): State<Arc<App>>) -> Json<About> {
    let summary = |process: &dyn AnyProcess| ProcessSummary { name: process.name(), title: process.title() };
    let processes = processes().all().map(summary).collect();
    Json(About { version: env!("CARGO_PKG_VERSION"), processes, queue: app.work.queue() })
}

/// This interface.
#[utoipa::path(get, path = "/api/openapi.json", responses((status = 200, body = Object)))]
pub async fn document(State(app): State<Arc<App>>) -> Response {
    kept_json(app.interface.clone())
}

static SCHEMA: LazyLock<String> = LazyLock::new(|| job_schema().to_string());

/// The JSON schema of job files.
#[utoipa::path(get, path = "/api/schema", responses((status = 200, body = Object)))]
pub async fn schema() -> Response {
    kept_json(SCHEMA.as_str())
}

fn kept_json(text: impl IntoResponse) -> Response {
    let headers = [(CONTENT_TYPE, "application/json"), (CACHE_CONTROL, "no-cache")];
    (headers, text).into_response()
}
