//! The history in which a job notes its measurement.

use crate::job::{LoadedSkivingJob, ToolHistory};
use std::path::PathBuf;

/// A file with what is noted in it.
#[derive(Clone, Debug, PartialEq)]
pub struct HistoryFile {
    /// The file.
    pub path: PathBuf,
    /// Tool, time and workpieces of the measurement.
    pub entry: ToolHistory,
}

impl HistoryFile {
    pub(super) fn of_job(loaded: &LoadedSkivingJob, given: &ToolHistory) -> Self {
        Self { path: loaded.beside(&given.file), entry: given.clone() }
    }
}
