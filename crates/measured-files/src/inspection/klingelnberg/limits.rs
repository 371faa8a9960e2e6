//! How large a file and its parts may be, and what is shown of a line.

use crate::inspection::InspectionError;

/// Largest file that is read: 16 MiB.
pub const MAXIMUM_FILE_BYTES: usize = 16 << 20;

/// Most curves of a file.
pub const MAXIMUM_TRACES: usize = 2000;

/// Most samples of a curve.
pub const MAXIMUM_SAMPLES: usize = 20_000;

/// Most lines that are passed over; with more of them the file is refused.
pub const MAXIMUM_UNKNOWN_LINES: usize = 200;

/// What is kept of a line that was not understood, characters.
const SHOWN: usize = 80;

/// The limit of a file, as an error.
pub(super) fn too_large(what: &str, found: usize, most: usize) -> Result<(), InspectionError> {
    if found > most { Err(InspectionError::FileTooLarge { what: what.into(), found, most }) } else { Ok(()) }
}

/// The beginning of a line, for messages.
pub(super) fn shown(line: &str) -> String {
    line.trim().chars().take(SHOWN).collect()
}
