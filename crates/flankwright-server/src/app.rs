//! The whole application: what its handlers share, and which path leads to which of them.

use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;

use axum::extract::DefaultBodyLimit;
use axum::http::StatusCode;
use axum::routing::{get, post};
use axum::{Router, middleware};
use flankwright_store::{Store, StoreAddress, StoreError};
use tokio::sync::{Notify, Semaphore};
use tower_http::compression::CompressionLayer;
use tower_http::timeout::TimeoutLayer;

use crate::gate::{Gate, guard};
use crate::work::Work;
use crate::{api, assets, headers};

/// Largest body of a request that is no upload: a job and the files that it names.
pub const MOST_BODY_BYTES: usize = 8 << 20;
/// Largest upload of measurements.
pub const MOST_UPLOAD_BYTES: usize = 32 << 20;
/// Longest time for an answer; long work is a run, and runs are not waited for.
const MOST_TIME: Duration = Duration::from_secs(60);
/// Short computations at once: checks and previews. More of them wait.
const SHORT_WORK: usize = 3;
/// Listeners to runs at once.
pub const MOST_LISTENERS: usize = 256;

/// What handlers share.
pub struct App {
    /// Parts, plans, runs.
    pub store: Store,
    /// Long work.
    pub work: Arc<Work>,
    /// Room for short work.
    pub short: Arc<Semaphore>,
    /// Room for listeners.
    pub listeners: Arc<Semaphore>,
    ending: Notify,
}

impl App {
    /// An application whose runs belong to the server at `address`; what it left under way when it last ended is told as interrupted.
    pub async fn new(
        store: Store,
        place: StoreAddress,
        address: SocketAddr,
    ) -> Result<Arc<Self>, StoreError> {
        let owner = format!("{}:{}", gethostname::gethostname().to_string_lossy(), address.port());
        store.interrupt_runs(&owner, &crate::work::now()).await?;
        Ok(Arc::new(Self {
            work: Work::start(store.clone(), place, owner),
            store,
            short: Arc::new(Semaphore::new(SHORT_WORK)),
            listeners: Arc::new(Semaphore::new(MOST_LISTENERS)),
            ending: Notify::new(),
        }))
    }

    /// Resolves when the process is told to end.
    pub fn told_to_end(self: &Arc<Self>) -> impl Future<Output = ()> + Send + 'static {
        let app = self.clone();
        async move {
            tokio::select! {
                _ = tokio::signal::ctrl_c() => {}
                () = terminated() => {}
            }
            app.work.end();
            app.ending.notify_waiters();
        }
    }

    /// Resolves when the server ends: streams must not hold it up.
    pub async fn ended(&self) {
        self.ending.notified().await;
    }

    /// Puts everything down.
    pub async fn close(&self) {
        self.store.close().await;
    }
}

#[cfg(unix)]
async fn terminated() {
    match tokio::signal::unix::signal(tokio::signal::unix::SignalKind::terminate()) {
        Ok(mut signal) => {
            signal.recv().await;
        }
        Err(_) => std::future::pending().await,
    }
}

#[cfg(not(unix))]
async fn terminated() {
    std::future::pending().await
}

/// All paths.
pub fn router(app: Arc<App>, gate: Arc<Gate>) -> Router {
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
        .route(
            "/measurements",
            post(api::measurements::begin).layer(DefaultBodyLimit::max(MOST_UPLOAD_BYTES)),
        )
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
        .layer(DefaultBodyLimit::max(MOST_BODY_BYTES))
        .layer(TimeoutLayer::with_status_code(StatusCode::SERVICE_UNAVAILABLE, MOST_TIME))
        .with_state(app);
    Router::new()
        .nest("/api", api)
        .fallback(assets::page)
        .layer(CompressionLayer::new())
        .layer(middleware::from_fn_with_state(gate, guard))
        .layer(middleware::from_fn(headers::harden))
}
