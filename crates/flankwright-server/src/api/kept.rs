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
use super::take::{InPath, InQuery, bounded};
use crate::app::App;
use crate::openapi::library;
use crate::wire::{CatalogueAnswer, Failure, Finding};

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
    /// Of these, so many of the newest, 1 to 10000; 1000 by default.
    #[param(minimum = 1, maximum = 10000)]
    pub newest: Option<u32>,
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
    /// Of so many of the newest parts, 1 to 10000; 1000 by default.
    #[param(minimum = 1, maximum = 10000)]
    pub newest: Option<u32>,
}

/// Default number of parts in a list.
const NEWEST: u32 = 1000;
/// Most of them.
const MOST_PARTS: u32 = 10_000;

fn newest(given: Option<u32>) -> Answer<Option<u32>> {
    bounded("newest", given.unwrap_or(NEWEST), MOST_PARTS).map(Some)
}

/// Series of parts.
#[utoipa::path(get, path = "/api/series", responses((status = 200, body = [library::SeriesSummary])))]
pub async fn series(State(app): State<Arc<App>>) -> Answer<Json<Vec<SeriesSummary>>> {
    Ok(Json(app.store.series().await?))
}

/// Measured parts.
#[utoipa::path(get, path = "/api/parts", params(Parts),
    responses((status = 200, body = [library::PartSummary]), (status = 422, body = Failure)))]
pub async fn parts(
    State(app): State<Arc<App>>,
    InQuery(of): InQuery<Parts>,
) -> Answer<Json<Vec<PartSummary>>> {
    let newest = newest(of.newest)?;
    let filter = PartFilter { series: of.series, from: of.from, to: of.to, newest, ..PartFilter::default() };
    Ok(Json(app.store.parts(&filter).await?))
}

/// A part with its document.
#[utoipa::path(get, path = "/api/parts/{digest}", params(("digest" = String, Path, description = "SHA-256 of its files")),
    responses((status = 200, body = library::PartRecord), (status = 404, body = Failure)))]
pub async fn part(State(app): State<Arc<App>>, InPath(digest): InPath<String>) -> Answer<Json<PartRecord>> {
    app.store.part(&digest).await?.map(Json).ok_or_else(|| Refused::absent("part"))
}

/// Values of characteristics over the parts.
#[utoipa::path(get, path = "/api/trends", params(Values),
    responses((status = 200, body = [library::MeasuredCharacteristic]), (status = 422, body = Failure)))]
pub async fn trends(
    State(app): State<Arc<App>>,
    InQuery(of): InQuery<Values>,
) -> Answer<Json<Vec<MeasuredCharacteristic>>> {
    let flank = of.flank.as_deref().map(flank).transpose()?;
    let parts = PartFilter { series: of.series, newest: newest(of.newest)?, ..PartFilter::default() };
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
#[utoipa::path(get, path = "/api/catalogue", responses((status = 200, body = CatalogueAnswer)))]
pub async fn catalogue(State(app): State<Arc<App>>) -> Answer<Json<CatalogueAnswer>> {
    let Catalogue { worm, dresser } = app.store.catalogue().await?;
    Ok(Json(CatalogueAnswer { worm, dresser }))
}

/// Skiving tools with a history.
#[utoipa::path(get, path = "/api/tools", responses((status = 200, body = [library::ToolSummary])))]
pub async fn tools(State(app): State<Arc<App>>) -> Answer<Json<Vec<ToolSummary>>> {
    Ok(Json(app.store.tools().await?))
}

/// The measurements of a skiving tool.
#[utoipa::path(get, path = "/api/tools/{tool}", params(("tool" = String, Path, description = "its name")),
    responses((status = 200, body = [library::HistoryRecord]), (status = 404, body = Failure)))]
pub async fn history(
    State(app): State<Arc<App>>,
    InPath(tool): InPath<String>,
) -> Answer<Json<Vec<HistoryRecord>>> {
    let records = app.store.history(Some(&tool)).await?;
    if records.is_empty() {
        return Err(Refused::absent("tool"));
    }
    Ok(Json(records))
}
