//! Which path leads to which handler, behind which bounds.

use std::sync::Arc;

use axum::extract::DefaultBodyLimit;
use axum::routing::{get, post};
use axum::{Router, middleware};
use tower_http::CompressionLevel;
use tower_http::compression::CompressionLayer;
use tower_http::compression::predicate::{DefaultPredicate, NotForContentType, Predicate};

use crate::app::App;
use crate::gate::{Gate, guard};
use crate::rooms::{bounded, sized};
use crate::{api, assets, headers};

/// Largest body of a request that is no upload: a job and the files that it names.
const MOST_BODY_BYTES: usize = 8 << 20;
/// Largest upload of measurements.
const MOST_UPLOAD_BYTES: usize = 32 << 20;

/// All paths.
pub fn router(app: Arc<App>, gate: Arc<Gate>) -> Router {
    let uploads = Router::new()
        .route("/measurements", post(api::measurements::begin))
        .layer(middleware::from_fn_with_state(MOST_UPLOAD_BYTES, sized))
        .layer(DefaultBodyLimit::max(MOST_UPLOAD_BYTES));
    let api = Router::new()
        .route("/about", get(api::about::about))
        .route("/openapi.json", get(api::about::document))
        .route("/schema", get(api::about::schema))
        .route("/examples", get(api::examples::list))
        .route("/examples/{*id}", get(api::examples::one))
        .route("/templates/{process}", get(api::examples::template))
        .route("/machines", get(api::examples::machines))
        .route("/check", post(api::jobs::check))
        .route("/edit", post(api::jobs::edit))
        .route("/preview", post(api::jobs::preview))
        .route("/runs", get(api::runs::list).post(api::runs::begin))
        .route("/runs/{id}", get(api::runs::one).delete(api::runs::remove))
        .route("/runs/{id}/cancel", post(api::runs::cancel))
        .route("/runs/{id}/again", post(api::runs::again))
        .route("/runs/{id}/events", get(api::events::events))
        .route("/runs/{id}/charts/{name}", get(api::charts::chart))
        .route("/runs/{id}/scene", get(api::files::scene))
        .route("/runs/{id}/archive", get(api::files::archive))
        .route("/runs/{id}/files/{*name}", get(api::files::file))
        .route("/programs/check", post(api::programs::check))
        .route("/series", get(api::kept::series))
        .route("/parts", get(api::kept::parts))
        .route("/parts/{digest}", get(api::kept::part))
        .route("/trends", get(api::kept::trends))
        .route("/catalogue", get(api::kept::catalogue))
        .route("/tools", get(api::kept::tools))
        .route("/tools/{tool}", get(api::kept::history))
        .fallback(api::error::no_such_path)
        .method_not_allowed_fallback(api::error::no_such_method)
        .layer(middleware::from_fn_with_state(MOST_BODY_BYTES, sized))
        .layer(DefaultBodyLimit::max(MOST_BODY_BYTES))
        .merge(uploads)
        .layer(middleware::from_fn_with_state(app.clone(), bounded))
        .with_state(app);
    let packable = DefaultPredicate::new().and(NotForContentType::const_new("application/zip"));
    Router::new()
        .nest("/api", api)
        .fallback(assets::page)
        // Answers are made anew for each client: what the best packing saves, it takes from the computations beside it.
        .layer(CompressionLayer::new().quality(CompressionLevel::Fastest).compress_when(packable))
        .layer(middleware::from_fn_with_state(gate, guard))
        .layer(middleware::from_fn(headers::harden))
}
