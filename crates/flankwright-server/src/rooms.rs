//! Bounds of requests: so many bodies at once, and so much time for an answer. Knows no path.

use std::sync::Arc;
use std::time::Duration;

use axum::body::HttpBody;
use axum::extract::{Request, State};
use axum::http::StatusCode;
use axum::http::header::CONTENT_LENGTH;
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use tokio_stream::StreamExt;

use crate::api::error::Refused;
use crate::app::App;
use crate::wire::{Failure, Finding};

/// Longest time for an answer; long work is a run, and runs are not waited for.
const MOST_TIME: Duration = Duration::from_secs(60);

/// Of a body that is too large, so much is read: a browser listens only when everything is sent.
const MOST_READ: usize = 256 << 20;

/// Refuses a body that says that it is larger than `most` bytes.
pub async fn sized(State(most): State<usize>, request: Request, next: Next) -> Response {
    let length =
        request.headers().get(CONTENT_LENGTH).and_then(|length| length.to_str().ok()?.parse::<usize>().ok());
    let Some(length) = length.filter(|&length| length > most) else { return next.run(request).await };
    let mut body = request.into_body().into_data_stream();
    let mut read = 0;
    while read < MOST_READ
        && let Some(Ok(part)) = body.next().await
    {
        read += part.len();
    }
    let finding = Finding::new(
        "body-too-large",
        format!("the request has {length} bytes"),
        "send less at once: fewer files, or use the command `flankwright`",
    );
    let failure = Failure::single(finding.allowed(format!("at most {most} bytes")));
    Refused(StatusCode::PAYLOAD_TOO_LARGE, failure).into_response()
}

/// Answers where there is room, and in time.
pub async fn bounded(State(app): State<Arc<App>>, request: Request, next: Next) -> Response {
    // PostgreSQL has no such letter, and no name has one.
    if request.uri().to_string().contains("%00") {
        let way_out = "leave it out";
        let refused = Refused::with(
            StatusCode::UNPROCESSABLE_ENTITY,
            "invalid-request",
            "the address holds a NUL",
            way_out,
        );
        return refused.into_response();
    }
    let room = match request.body().is_end_stream() {
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
