//! Charts of a result.

use std::sync::Arc;

use axum::extract::State;
use axum::http::header::CONTENT_TYPE;
use axum::response::{IntoResponse, Response};

use super::error::{Answer, Refused};
use super::take::InPath;
use crate::app::App;
use crate::charts::Placed;
use crate::wire::Failure;
use crate::work::CHARTS;

/// The charts of a run and where they stand.
pub(super) async fn placed(app: &App, id: i64) -> Answer<Vec<Placed>> {
    let Some(file) = app.store.run_file(id, CHARTS).await? else { return Ok(Vec::new()) };
    serde_json::from_slice(&file.bytes).map_err(|error| {
        Refused::bad(Failure::internal(format!("the charts of run {id} cannot be read: {error}")))
    })
}

/// A chart of the result as SVG.
#[utoipa::path(get, path = "/api/runs/{id}/charts/{name}", params(("id" = i64, Path, description = "number of the run"),
    ("name" = String, Path, description = "as the run lists it")),
    responses((status = 200, content_type = "image/svg+xml"), (status = 404, body = Failure)))]
pub async fn chart(
    State(app): State<Arc<App>>,
    InPath((id, name)): InPath<(i64, String)>,
) -> Answer<Response> {
    let absent = || Refused::absent("chart");
    let found = placed(&app, id).await?.into_iter().find(|placed| placed.chart.name == name);
    let Placed { page, start, end, .. } = found.ok_or_else(absent)?;
    let page = app.store.run_file(id, &page).await?.ok_or_else(absent)?;
    let svg = page.bytes.get(start..end).ok_or_else(absent)?.to_vec();
    Ok(([(CONTENT_TYPE, "image/svg+xml")], svg).into_response())
}
