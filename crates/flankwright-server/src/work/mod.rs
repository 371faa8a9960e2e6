//! Long work: runs that wait in a bounded queue, are carried out by a few threads, tell how far they are, can be cancelled, and end in the
//! store whatever becomes of those who asked for them.

mod cancel;
pub mod carry;
mod keep;
mod live;

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::SystemTime;

use flankwright_store::{NewRun, RunEnd, RunFile, RunState, Store, StoreAddress, StoreError};
use tokio::sync::mpsc::error::TrySendError;
use tokio::sync::{Mutex as AsyncMutex, mpsc};

pub use live::{Live, Told};

use crate::wire::{Queue, Request};

/// Runs that may wait.
const MOST_WAITING: usize = 32;
/// Runs under way at once; each computes on all cores.
const AT_ONCE: usize = 2;

/// The file of a run that holds its bodies in space, packed; it is no result and is not listed.
pub const SCENE: &str = ".scene.json.gz";

/// Now, as the store keeps times.
pub fn now() -> String {
    humantime::format_rfc3339_seconds(SystemTime::now()).to_string()
}

/// A run on its way.
struct Task {
    id: i64,
    request: Request,
    inputs: Vec<RunFile>,
    live: Arc<Live>,
}

/// The queue, and who works it off.
pub struct Work {
    store: Store,
    place: StoreAddress,
    owner: String,
    queue: mpsc::Sender<Task>,
    live: Mutex<HashMap<i64, Arc<Live>>>,
}

/// Why a run was not taken in.
#[derive(Debug)]
pub enum NotTaken {
    /// The queue is full.
    Full,
    /// The store refuses.
    Store(StoreError),
}

impl Work {
    /// Begins to work.
    pub fn start(store: Store, place: StoreAddress, owner: String) -> Arc<Self> {
        let (queue, waiting) = mpsc::channel(MOST_WAITING);
        let work = Arc::new(Self { store, place, owner, queue, live: Mutex::default() });
        let waiting = Arc::new(AsyncMutex::new(waiting));
        let runtime = tokio::runtime::Handle::current();
        for k in 0..AT_ONCE {
            let (work, waiting, runtime) = (Arc::downgrade(&work), waiting.clone(), runtime.clone());
            let named = thread::Builder::new().name(format!("run-{k}"));
            let spawned = named.spawn(move || {
                loop {
                    let Some(task) = runtime.block_on(async { waiting.lock().await.recv().await }) else {
                        return;
                    };
                    let Some(work) = work.upgrade() else { return };
                    work.carry_out(&runtime, &task);
                }
            });
            if let Err(error) = spawned {
                eprintln!("a thread for runs cannot be had: {error}");
            }
        }
        work
    }

    /// Takes a run in; its number.
    ///
    /// # Errors
    /// [`NotTaken`].
    pub async fn take(&self, request: Request, name: String, inputs: Vec<RunFile>) -> Result<i64, NotTaken> {
        let place = match self.queue.try_reserve() {
            Ok(place) => place,
            Err(TrySendError::Full(()) | TrySendError::Closed(())) => return Err(NotTaken::Full),
        };
        let run = NewRun {
            owner: self.owner.clone(),
            kind: request.kind.task().name().to_owned(),
            name,
            job: serde_json::to_string(&request).unwrap_or_default(),
            created: now(),
            files: inputs.clone(),
        };
        let id = self.store.add_run(&run).await.map_err(NotTaken::Store)?;
        let live = Arc::new(Live::default());
        self.all().insert(id, live.clone());
        place.send(Task { id, request, inputs, live });
        Ok(id)
    }

    fn all(&self) -> std::sync::MutexGuard<'_, HashMap<i64, Arc<Live>>> {
        self.live.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// A run that waits or is under way.
    pub fn live(&self, id: i64) -> Option<Arc<Live>> {
        self.all().get(&id).cloned()
    }

    /// How busy it is.
    pub fn queue(&self) -> Queue {
        let waiting = MOST_WAITING - self.queue.capacity();
        Queue { running: self.all().len().saturating_sub(waiting), waiting, most: MOST_WAITING }
    }

    /// Cancels a run; the state that it has then, `None` if it had ended or there is none.
    ///
    /// # Errors
    /// Those of the store.
    pub async fn cancel(&self, id: i64) -> Result<Option<RunState>, StoreError> {
        let Some(live) = self.live(id) else { return Ok(None) };
        live.cancel();
        if live.told().state == RunState::Queued {
            // Whoever takes it out of the queue finds that it has ended.
            self.end_run(id, &live, &ended(RunState::Cancelled)).await?;
        }
        Ok(Some(live.told().state))
    }

    /// Has all runs end at their next step.
    pub fn end(&self) {
        self.all().values().for_each(|live| live.interrupt());
    }

    async fn end_run(&self, id: i64, live: &Live, end: &RunEnd) -> Result<(), StoreError> {
        self.store.end_run(id, end).await?;
        self.all().remove(&id);
        live.end(end.state);
        Ok(())
    }

    fn carry_out(&self, runtime: &tokio::runtime::Handle, task: &Task) {
        if let Err(error) = self.carried_out(runtime, task) {
            eprintln!("run {}: the store refuses: {error}", task.id);
            self.all().remove(&task.id);
            task.live.end(RunState::Interrupted);
        }
    }

    fn carried_out(&self, runtime: &tokio::runtime::Handle, task: &Task) -> Result<(), StoreError> {
        if !runtime.block_on(self.store.begin_run(task.id))? {
            return Ok(());
        }
        task.live.begin();
        // Not inside of the runtime: it computes for minutes, and may open a store that has one of its own.
        let end = carry::carry(task, &self.place);
        runtime.block_on(self.end_run(task.id, &task.live, &end))
    }
}

fn ended(state: RunState) -> RunEnd {
    RunEnd { state, ended: now(), document: None, files: Vec::new() }
}
