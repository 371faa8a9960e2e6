//! The whole application: what its handlers share, and which path leads to which of them.

use std::sync::Arc;
use std::time::Duration;

use axum::extract::DefaultBodyLimit;
use axum::routing::{get, post};
use axum::{Router, middleware};
use flankwright_store::{Store, StoreAddress};
use rayon::{ThreadPool, ThreadPoolBuilder};
use tokio::sync::{Semaphore, watch};
use tower_http::CompressionLevel;
use tower_http::compression::CompressionLayer;
use tower_http::compression::predicate::{DefaultPredicate, NotForContentType, Predicate};

use crate::gate::{Gate, guard};
use crate::rooms::{bounded, sized};
use crate::scratch::Scratch;
use crate::work::{Work, keep_beating};
use crate::{ServeError, api, assets, headers};

/// Largest body of a request that is no upload: a job and the files that it names.
pub const MOST_BODY_BYTES: usize = 8 << 20;
/// Largest upload of measurements.
pub const MOST_UPLOAD_BYTES: usize = 32 << 20;
/// Short computations at once: checks and previews. More of them wait.
const SHORT_WORK: usize = 3;
/// Requests with a body at once.
const MOST_BODIES: usize = 16;
/// Uploads of measurements at once.
const MOST_UPLOADS: usize = 3;
/// Listeners to runs at once: fewer than connections, so that others are answered beside them.
pub const MOST_LISTENERS: usize = 160;

/// Archives packed at once.
const MOST_ARCHIVES: usize = 2;
/// How long connections of the store are waited for at the end.
const FAREWELL: Duration = Duration::from_secs(5);

/// What handlers share.
pub struct App {
    /// Parts, plans, runs.
    pub store: Store,
    /// Long work.
    pub work: Arc<Work>,
    /// Where files are put down for a while.
    pub scratch: Arc<Scratch>,
    /// Room for short work.
    pub short: Arc<Semaphore>,
    /// Threads of short work: those of runs would keep it waiting until a run has ended.
    pub threads: Arc<ThreadPool>,
    /// Room for archives.
    pub archives: Semaphore,
    /// Room for requests with a body.
    pub bodies: Arc<Semaphore>,
    /// Room for uploads.
    pub uploads: Semaphore,
    /// Room for listeners.
    pub listeners: Arc<Semaphore>,
    /// Whether the server ends.
    pub ending: watch::Receiver<bool>,
}

impl App {
    /// An application over a store; runs that dead servers left in it are reported as interrupted.
    ///
    /// # Errors
    /// The store, the temporary files or the threads of the system refuse.
    pub async fn new(
        store: Store,
        place: StoreAddress,
        ending: watch::Receiver<bool>,
    ) -> Result<Arc<Self>, ServeError> {
        let system = |error: std::io::Error| ServeError::System(error.to_string());
        let scratch = Arc::new(Scratch::new(place.identity()).map_err(system)?);
        let threads = ThreadPoolBuilder::new().thread_name(|k| format!("short-{k}")).build();
        let threads = threads.map_err(|error| ServeError::System(error.to_string()))?;
        let work = Work::start(store.clone(), place, scratch.clone()).map_err(system)?;
        work.beat(&scratch.tidy()).await?;
        tokio::spawn(keep_beating(work.clone(), ending.clone()));
        Ok(Arc::new(Self {
            store,
            work,
            scratch,
            short: Arc::new(Semaphore::new(SHORT_WORK)),
            threads: Arc::new(threads),
            archives: Semaphore::new(MOST_ARCHIVES),
            bodies: Arc::new(Semaphore::new(MOST_BODIES)),
            uploads: Semaphore::new(MOST_UPLOADS),
            listeners: Arc::new(Semaphore::new(MOST_LISTENERS)),
            ending,
        }))
    }

    /// Puts everything down.
    pub async fn close(&self) {
        self.work.close().await;
        // A connection that is waited for elsewhere does not hold the end up.
        drop(tokio::time::timeout(FAREWELL, self.store.close()).await);
    }
}

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
