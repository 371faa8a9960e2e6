//! Bounds of requests: so many bodies at once, and so much time for an answer. Knows no path.

use std::sync::Arc;
use std::time::Duration;

use axum::extract::{Request, State};
use axum::http::StatusCode;
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};

use crate::api::error::Refused;
use crate::app::App;

/// Longest time for an answer; long work is a run, and runs are not waited for.
const MOST_TIME: Duration = Duration::from_secs(60);

/// Answers where there is room, and in time.
pub async fn bounded(State(app): State<Arc<App>>, request: Request, next: Next) -> Response {
    let room = match request.method().is_safe() {
        true => None,
        false => match app.bodies.clone().try_acquire_owned() {
            Ok(room) => Some(room),
            Err(_) => return Refused::busy("too many requests are under way").into_response(),
        },
    };
    let answer = tokio::time::timeout(MOST_TIME, next.run(request)).await;
    drop(room);
    answer.unwrap_or_else(|_| {
        let message = format!("the answer takes longer than {} s", MOST_TIME.as_secs());
        let way_out = "ask for less at once, or use the command `flankwright`, which takes its time";
        Refused::with(StatusCode::SERVICE_UNAVAILABLE, "timed-out", message, way_out).into_response()
    })
}
