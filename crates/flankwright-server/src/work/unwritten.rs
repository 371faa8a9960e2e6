//! Results that cannot be put down.

use flankwright::workflow::WriteError;

use crate::wire::Failure;

/// Results that are not put down. The path on the server is not shown to the client.
pub(super) fn unwritten(error: &WriteError) -> Failure {
    match error {
        WriteError::Io { source, .. } => Failure::disk(source),
        WriteError::Busy { .. }
        | WriteError::Table(_)
        | WriteError::Chart(_)
        | WriteError::Mesh(_)
        | WriteError::Json(_) => Failure::internal(error.to_string()),
    }
}
