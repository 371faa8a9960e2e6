//! What the store holds beside runs: measured parts and their trends, catalogue, histories of tools.

use std::sync::Arc;

use axum::Json;
use axum::extract::State;
use flankwright::exchange::catalogue::Catalogue;
use flankwright::exchange::skiving_history::HistoryRecord;
use flankwright::geometry::Flank;
use flankwright_store::{
    CharacteristicFilter, MeasuredCharacteristic, PartFilter, PartRecord, PartSummary, SeriesSummary,
    ToolSummary,
};
use serde::Deserialize;

use super::error::{Answer, Refused};
use super::take::{InPath, InQuery};
use crate::app::App;
use crate::wire::{Failure, Finding};

/// Which parts.
#[derive(Debug, Default, Deserialize, utoipa::IntoParams)]
#[into_params(parameter_in = Query)]
#[serde(deny_unknown_fields, default)]
pub struct Parts {
    /// Of this series.
    pub series: Option<String>,
    /// Measured at this date or later.
    pub from: Option<String>,
    /// Measured at this date or earlier.
    pub to: Option<String>,
}

/// Which values.
#[derive(Debug, Default, Deserialize, utoipa::IntoParams)]
#[into_params(parameter_in = Query)]
#[serde(deny_unknown_fields, default)]
pub struct Values {
    /// Of this series.
    pub series: Option<String>,
    /// Symbol, e.g. `fHa`.
    pub name: Option<String>,
    /// `left` or `right`.
    pub flank: Option<String>,
    /// E.g. `mean`.
    pub statistic: Option<String>,
}

/// Series of parts.
#[utoipa::path(get, path = "/api/series", responses((status = 200, body = [Object])))]
pub async fn series(State(app): State<Arc<App>>) -> Answer<Json<Vec<SeriesSummary>>> {
    Ok(Json(app.store.series().await?))
}

/// Measured parts.
#[utoipa::path(get, path = "/api/parts", params(Parts), responses((status = 200, body = [Object]), (status = 422, body = Failure)))]
pub async fn parts(
    State(app): State<Arc<App>>,
    InQuery(of): InQuery<Parts>,
) -> Answer<Json<Vec<PartSummary>>> {
    let filter = PartFilter { series: of.series, from: of.from, to: of.to, ..PartFilter::default() };
    Ok(Json(app.store.parts(&filter).await?))
}

/// A part with its document.
#[utoipa::path(get, path = "/api/parts/{digest}", params(("digest" = String, Path, description = "SHA-256 of its files")),
    responses((status = 200, body = Object), (status = 404, body = Failure)))]
pub async fn part(State(app): State<Arc<App>>, InPath(digest): InPath<String>) -> Answer<Json<PartRecord>> {
    app.store.part(&digest).await?.map(Json).ok_or_else(|| Refused::absent("part"))
}

/// Values of characteristics over the parts.
#[utoipa::path(get, path = "/api/trends", params(Values), responses((status = 200, body = [Object]), (status = 422, body = Failure)))]
pub async fn trends(
    State(app): State<Arc<App>>,
    InQuery(of): InQuery<Values>,
) -> Answer<Json<Vec<MeasuredCharacteristic>>> {
    let flank = of.flank.as_deref().map(flank).transpose()?;
    let parts = PartFilter { series: of.series, ..PartFilter::default() };
    let filter = CharacteristicFilter { parts, name: of.name, flank, statistic: of.statistic };
    Ok(Json(app.store.characteristics(&filter).await?))
}

fn flank(name: &str) -> Answer<Flank> {
    Flank::BOTH.into_iter().find(|flank| flank.name() == name).ok_or_else(|| {
        let finding =
            Finding::new("unknown-value", format!("there is no flank `{name}`"), "choose one of these");
        Refused::bad(Failure::single(finding.field("flank").allowed("left, right")))
    })
}

/// Worms and dressers.
#[utoipa::path(get, path = "/api/catalogue", responses((status = 200, body = Object)))]
pub async fn catalogue(State(app): State<Arc<App>>) -> Answer<Json<Catalogue>> {
    Ok(Json(app.store.catalogue().await?))
}

/// Skiving tools with a history.
#[utoipa::path(get, path = "/api/tools", responses((status = 200, body = [Object])))]
pub async fn tools(State(app): State<Arc<App>>) -> Answer<Json<Vec<ToolSummary>>> {
    Ok(Json(app.store.tools().await?))
}

/// The measurements of a skiving tool.
#[utoipa::path(get, path = "/api/tools/{tool}", params(("tool" = String, Path, description = "its name")),
    responses((status = 200, body = [Object])))]
pub async fn history(
    State(app): State<Arc<App>>,
    InPath(tool): InPath<String>,
) -> Answer<Json<Vec<HistoryRecord>>> {
    Ok(Json(app.store.history(Some(&tool)).await?))
}
