//! A file that an import refuses, and why.

use std::path::Path;

use flankwright::exchange::Diagnostic;
use schemars::JsonSchema;
use serde::Serialize;

/// A file that was not imported.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RefusedFile {
    /// The file.
    pub file: String,
    /// Why.
    #[serde(flatten)]
    pub finding: Diagnostic,
}

impl RefusedFile {
    pub(super) fn new(path: &Path, finding: Diagnostic) -> Self {
        Self { file: path.display().to_string(), finding }
    }
}
