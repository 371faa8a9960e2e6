//! What the handlers of the application share.

use std::sync::Arc;
use std::time::Duration;

use flankwright_store::{Store, StoreAddress};
use rayon::{ThreadPool, ThreadPoolBuilder};
use tokio::sync::{Semaphore, watch};

use crate::ServeError;
use crate::scratch::Scratch;
use crate::work::{Work, keep_beating};
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
    /// The document that describes the interface, as JSON.
    pub interface: String,
    /// Whether the server ends.
    pub ending: watch::Receiver<bool>,
}

impl App {
    /// An application over a store, which hands `interface` out as its description; runs that dead servers left in the store are reported
    /// as interrupted.
    ///
    /// # Errors
    /// The store, the temporary files or the threads of the system refuse.
    pub async fn new(
        store: Store,
        place: StoreAddress,
        interface: String,
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
            interface,
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
