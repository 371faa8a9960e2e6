//! What a refused request gets: a status and the same findings as the command would tell.

use axum::Json;
use axum::extract::multipart::{MultipartError, MultipartRejection};
use axum::extract::rejection::{JsonRejection, PathRejection, QueryRejection};
use axum::http::StatusCode;
use axum::response::{IntoResponse, Response};
use flankwright_store::StoreError;

use crate::wire::{Failure, Finding};

/// A refused request.
#[derive(Debug)]
pub struct Refused(pub StatusCode, pub Failure);

/// What a handler answers.
pub type Answer<T> = Result<T, Refused>;

impl IntoResponse for Refused {
    fn into_response(self) -> Response {
        (self.0, Json(self.1)).into_response()
    }
}

impl Refused {
    /// A request that is wrong.
    pub fn bad(failure: Failure) -> Self {
        let disk = || failure.errors.iter().any(|finding| finding.code == "server-disk");
        let status = match failure.exit {
            1 if disk() => StatusCode::INSUFFICIENT_STORAGE,
            1 => StatusCode::INTERNAL_SERVER_ERROR,
            _ => StatusCode::UNPROCESSABLE_ENTITY,
        };
        Self(status, failure)
    }

    /// Something that is not there.
    pub fn absent(what: &str) -> Self {
        let finding = Finding::new(
            "not-found",
            format!("there is no such {what}"),
            "ask for the list of what there is",
        );
        Self(StatusCode::NOT_FOUND, Failure::single(finding))
    }

    /// A server that has no room now.
    pub fn busy(message: &str) -> Self {
        Self::with(StatusCode::SERVICE_UNAVAILABLE, "server-busy", message, "try again in a moment")
    }

    /// A finding with a status of its own.
    pub fn with(status: StatusCode, code: &str, message: impl Into<String>, way_out: &str) -> Self {
        Self(status, Failure::single(Finding::new(code, message, way_out)))
    }
}

impl From<StoreError> for Refused {
    fn from(error: StoreError) -> Self {
        if let StoreError::InvalidRecord(finding) = &error {
            return Self::bad(Failure::of_finding(finding));
        }
        // A filter that is wrong is the client's fault, everything else that of the place where the store is.
        let status = match &error {
            StoreError::Contradiction(_) => StatusCode::UNPROCESSABLE_ENTITY,
            _ => StatusCode::SERVICE_UNAVAILABLE,
        };
        Self::with(status, error.code(), error.to_string(), &error.way_out())
    }
}

/// A body or a path that cannot be read.
fn unread(status: StatusCode, text: String) -> Refused {
    Refused::with(status, "invalid-request", text, "see /api/openapi.json for what the request takes")
}

impl From<JsonRejection> for Refused {
    fn from(rejection: JsonRejection) -> Self {
        unread(rejection.status(), rejection.body_text())
    }
}

impl From<PathRejection> for Refused {
    fn from(rejection: PathRejection) -> Self {
        unread(rejection.status(), rejection.body_text())
    }
}

impl From<QueryRejection> for Refused {
    fn from(rejection: QueryRejection) -> Self {
        unread(rejection.status(), rejection.body_text())
    }
}

impl From<MultipartRejection> for Refused {
    fn from(rejection: MultipartRejection) -> Self {
        unread(rejection.status(), rejection.body_text())
    }
}

impl From<MultipartError> for Refused {
    fn from(error: MultipartError) -> Self {
        unread(error.status(), error.body_text())
    }
}

/// A path that leads nowhere.
pub async fn no_such_path() -> Refused {
    Refused::absent("path")
}

/// A method that a path does not take.
pub async fn no_such_method() -> Refused {
    let way_out = "see /api/openapi.json for the methods of each path";
    Refused::with(
        StatusCode::METHOD_NOT_ALLOWED,
        "method-not-allowed",
        "the path does not take this method",
        way_out,
    )
}
