//! Writes what is known of a measured gear. Every file appears whole or not at all.

use super::run::GearInspection;
use super::tables;
use crate::exchange::write_atomically;
use crate::workflow::write::{WriteError, json};
use std::path::{Path, PathBuf};

/// Writes result and tables into `directory` (made if missing); returns their paths.
///
/// # Errors
/// [`WriteError`]; files written before the error stay.
pub fn write_gear_inspection(found: &GearInspection, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
    let result = &found.result;
    let files = [
        ("result.json", json(result)?),
        ("traces.csv", tables::traces(result)?.text().into()),
        ("pitch.csv", tables::pitch(result)?.text().into()),
    ];
    let mut written = Vec::with_capacity(files.len());
    for (name, bytes) in files {
        let path = directory.join(name);
        write_atomically(&path, &bytes).map_err(|source| WriteError::Io { path: path.clone(), source })?;
        written.push(path);
    }
    Ok(written)
}
