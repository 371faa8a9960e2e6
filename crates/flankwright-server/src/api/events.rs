//! How far a run is, as server-sent events. Only the last word is kept for who listens slowly.

use std::convert::Infallible;
use std::sync::Arc;
use std::time::Duration;

use axum::extract::State;
use axum::http::StatusCode;
use axum::response::Sse;
use axum::response::sse::{Event, KeepAlive};
use flankwright_store::RunState;
use tokio::sync::OwnedSemaphorePermit;
use tokio::sync::mpsc;
use tokio_stream::Stream;
use tokio_stream::wrappers::ReceiverStream;

use super::error::{Answer, Refused};
use super::runs::state_of;
use super::take::InPath;
use crate::app::App;
use crate::wire::{Failure, RunStateAnswer};
use crate::work::Told;

/// After that time of silence a sign of life is sent.
const SILENCE: Duration = Duration::from_secs(15);

/// How often the store is asked about a run of another server.
const LOOK: Duration = Duration::from_secs(2);

type Line = Result<Event, Infallible>;

fn state_line(state: RunState) -> Line {
    Ok(Event::default().event("state").json_data(RunStateAnswer { state }).unwrap_or_default())
}

/// Server-sent events: `progress`, `state`; the stream ends with the run.
#[utoipa::path(get, path = "/api/runs/{id}/events", params(("id" = i64, Path, description = "number of the run")),
    responses((status = 200, content_type = "text/event-stream"), (status = 404, body = Failure)))]
pub async fn events(
    State(app): State<Arc<App>>,
    InPath(id): InPath<i64>,
) -> Answer<Sse<impl Stream<Item = Line>>> {
    let room = app.listeners.clone().try_acquire_owned().map_err(|_| {
        let way_out = "close some of the windows that show runs";
        Refused::with(
            StatusCode::SERVICE_UNAVAILABLE,
            "too-many-listeners",
            "too many listen to runs",
            way_out,
        )
    })?;
    // One place: the next line is made when the last one has been read.
    let (lines, stream) = mpsc::channel(1);
    match app.work.live(id) {
        Some(live) => {
            tokio::spawn(follow(app.clone(), live.listen(), lines, room));
        }
        None => {
            let state = state_of(&app, id).await?;
            tokio::spawn(look(app.clone(), id, state, lines, room));
        }
    }
    Ok(Sse::new(ReceiverStream::new(stream)).keep_alive(KeepAlive::new().interval(SILENCE)))
}

/// Follows a run of another server, which is in the store alone.
async fn look(
    app: Arc<App>,
    id: i64,
    state: RunState,
    lines: mpsc::Sender<Line>,
    _room: OwnedSemaphorePermit,
) {
    let mut ending = app.ending.clone();
    let (mut state, mut last) = (state, None);
    loop {
        if last != Some(state) && lines.send(state_line(state)).await.is_err() || state.has_ended() {
            return;
        }
        last = Some(state);
        tokio::select! {
            () = tokio::time::sleep(LOOK) => {}
            () = lines.closed() => return,
            _ = ending.wait_for(|ending| *ending) => return,
        }
        // Where the store does not answer, the next look may.
        state = match app.store.run_summary(id).await {
            Ok(Some(run)) => run.state,
            Ok(None) => return,
            Err(_) => state,
        };
    }
}

async fn follow(
    app: Arc<App>,
    mut told: tokio::sync::watch::Receiver<Told>,
    lines: mpsc::Sender<Line>,
    _room: OwnedSemaphorePermit,
) {
    let mut last: Option<RunState> = None;
    let mut ending = app.ending.clone();
    loop {
        let Told { state, advance } = told.borrow_and_update().clone();
        if last != Some(state) {
            last = Some(state);
            if lines.send(state_line(state)).await.is_err() {
                return;
            }
        }
        if state.has_ended() {
            return;
        }
        if state == RunState::Running {
            let line = Event::default().event("progress").json_data(&advance).unwrap_or_default();
            if lines.send(Ok(line)).await.is_err() {
                return;
            }
        }
        tokio::select! {
            changed = told.changed() => if changed.is_err() { return },
            () = lines.closed() => return,
            _ = ending.wait_for(|ending| *ending) => return,
        }
    }
}
