//! Long work: runs that wait in a bounded queue, are carried out by a few threads, tell how far they are, can be cancelled, and end in the
//! store whatever becomes of those who asked for them.

mod beat;
mod carry;
mod end;
mod keep;
mod live;
mod measured;
mod queue;
mod unwritten;

use std::collections::HashMap;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, SystemTime};

use flankwright_store::{NewRun, RunEnd, RunFile, RunState, Store, StoreAddress, StoreError};
use tokio::runtime::Handle;

pub use beat::keep_beating;
pub use live::{Live, Told};

use crate::log::say;
use crate::scratch::Scratch;
use crate::wire::{self, Failure, Request};
use queue::{MOST_WAITING, Queue};

/// Runs under way at once; each computes on all cores.
const AT_ONCE: usize = 2;

/// The file of a run that holds its bodies in space, packed. Files that begin with a dot are no results and are not listed.
pub const SCENE: &str = ".scene.json.gz";
/// The file of a run that tells which charts its report holds, and where.
pub const CHARTS: &str = ".charts.json";

/// How long the store may take to hear that the server ends.
const FAREWELL: Duration = Duration::from_secs(5);

/// Now, as the store keeps times.
pub fn now() -> String {
    humantime::format_rfc3339_millis(SystemTime::now()).to_string()
}

/// The queue, and who works it off.
pub struct Work {
    store: Store,
    place: StoreAddress,
    scratch: Arc<Scratch>,
    queue: Arc<Queue>,
    live: Mutex<HashMap<i64, Arc<Live>>>,
    /// Ends that the store has not taken yet.
    owed: Mutex<Vec<(i64, RunEnd)>>,
}

/// Why a run was not taken in.
#[derive(Debug)]
pub enum NotTaken {
    /// The queue is full.
    Full,
    /// The server ends.
    Ending,
    /// The request cannot be kept.
    Unkept(String),
    /// The store refuses.
    Store(StoreError),
}

/// What became of the wish to cancel a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cancelled {
    /// It ends; the state that it has now.
    Told(RunState),
    /// It is none of this server's that waits or is under way.
    NotHere,
}

impl Work {
    /// Begins to work.
    ///
    /// # Errors
    /// The system has no threads.
    pub fn start(store: Store, place: StoreAddress, scratch: Arc<Scratch>) -> io::Result<Arc<Self>> {
        let (queue, live, owed) = Default::default();
        let work = Arc::new(Self { store, place, scratch, queue, live, owed });
        let runtime = Handle::current();
        for k in 0..AT_ONCE {
            let (work, runtime) = (work.clone(), runtime.clone());
            thread::Builder::new().name(format!("run-{k}")).spawn(move || {
                while let Some(id) = work.queue.next() {
                    let carried = catch_unwind(AssertUnwindSafe(|| work.carry_out(&runtime, id)));
                    if carried.is_err()
                        && let Some(live) = work.live(id)
                    {
                        let fault = Failure::internal("the server failed between two steps of the run");
                        runtime.block_on(work.end_run(id, &live, end::failed(&fault)));
                    }
                }
            })?;
        }
        Ok(work)
    }

    /// Takes a run in; its number. It is taken in whole, also where the client has disconnected meanwhile.
    ///
    /// # Errors
    /// [`NotTaken`].
    pub async fn take(
        self: &Arc<Self>,
        request: &Request,
        name: String,
        inputs: Vec<RunFile>,
    ) -> Result<i64, NotTaken> {
        let full = || if self.queue.is_ending() { NotTaken::Ending } else { NotTaken::Full };
        let place = self.queue.reserve().ok_or_else(full)?;
        let run = NewRun {
            owner: self.scratch.owner().to_owned(),
            kind: request.kind,
            name,
            job: serde_json::to_string(request).map_err(|error| NotTaken::Unkept(error.to_string()))?,
            created: now(),
            files: inputs,
        };
        let work = self.clone();
        let taken = tokio::spawn(async move {
            let id = work.store.add_run(&run).await.map_err(NotTaken::Store)?;
            work.all().insert(id, Arc::default());
            place.fill(id);
            Ok(id)
        });
        taken.await.unwrap_or_else(|fault| Err(NotTaken::Unkept(fault.to_string())))
    }

    fn all(&self) -> MutexGuard<'_, HashMap<i64, Arc<Live>>> {
        self.live.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// A run that waits or is under way.
    pub fn live(&self, id: i64) -> Option<Arc<Live>> {
        self.all().get(&id).cloned()
    }

    /// What is known of all that wait or are under way.
    pub fn all_told(&self) -> HashMap<i64, Told> {
        self.all().iter().map(|(&id, live)| (id, live.told())).collect()
    }

    /// How busy it is.
    pub fn queue(&self) -> wire::Queue {
        let running = self.all().values().filter(|live| live.told().state == RunState::Running).count();
        wire::Queue { running, waiting: self.queue.waiting(), most: MOST_WAITING }
    }

    /// Cancels a run: one that waits at once, one that is under way at its next step.
    pub async fn cancel(self: &Arc<Self>, id: i64) -> Cancelled {
        let Some(live) = self.live(id) else { return Cancelled::NotHere };
        live.cancel();
        if self.queue.take_back(id) {
            let (work, live) = (self.clone(), live.clone());
            let end = tokio::spawn(async move { work.end_run(id, &live, ended(RunState::Cancelled)).await });
            if let Err(fault) = end.await {
                say(format!("run {id}: {fault}"));
            }
        }
        Cancelled::Told(live.told().state)
    }

    /// Nothing is begun any more, and all runs end at their next step.
    pub fn end(&self) {
        self.queue.end();
        self.all().values().for_each(|live| live.interrupt());
    }

    /// Whether it ends.
    pub fn is_ending(&self) -> bool {
        self.queue.is_ending()
    }

    /// Tells the store that this server ends, and tidies up behind it.
    pub async fn close(&self) {
        let now = now();
        match tokio::time::timeout(FAREWELL, self.store.leave(self.scratch.owner(), &now)).await {
            Ok(Ok(_)) => self.scratch.close(),
            // The folder stays, from which the next server learns that this one is gone.
            Ok(Err(error)) => say(format!("the store refuses the farewell: {error}")),
            Err(_) => say("the store has no time for the farewell"),
        }
    }

    fn carry_out(&self, runtime: &Handle, id: i64) {
        let Some(live) = self.live(id) else { return };
        let end = match runtime.block_on(self.begun(id, &live)) {
            // Not inside of the runtime: it computes for minutes, and may open a store that has one of its own.
            Ok(Some(task)) => carry::carry(&task, &live, &self.place, &self.scratch),
            Ok(None) => ended(live.ended_as()),
            Err(error) => end::refused(&error),
        };
        runtime.block_on(self.end_run(id, &live, end));
    }

    /// What is to be done, from the store; `None` if it is not to be done any more.
    async fn begun(&self, id: i64, live: &Live) -> Result<Option<carry::Task>, StoreError> {
        if live.is_cancelled() || !self.store.begin_run(id).await? {
            return Ok(None);
        }
        live.begin();
        let Some(record) = self.store.run(id).await? else { return Ok(None) };
        Ok(Some(carry::Task { request: record.job, inputs: self.store.run_inputs(id).await? }))
    }
}

fn ended(state: RunState) -> RunEnd {
    RunEnd { state, ended: now(), document: None, files: Vec::new() }
}
