//! Writes a series: document, table, sheets, page. Every file appears whole or not at all.

use super::{InspectionSeries, page, tables};
use crate::exchange::write_atomically;
use crate::report::html;
use crate::workflow::write::{WriteError, json};
use std::path::{Path, PathBuf};

/// Writes `series.json`, `series.csv`, the sheets and `series.html` into `directory` (made if missing); returns their paths, the page last.
///
/// # Errors
/// [`WriteError`]; files written before the error stay.
pub fn write_inspection_series(
    series: &InspectionSeries,
    directory: &Path,
) -> Result<Vec<PathBuf>, WriteError> {
    let page = html::render(&page::series_page(series)?);
    let first = [
        ("series.json", json(&series.result)?),
        ("series.csv", tables::values(&series.result)?.text().into()),
    ];
    let first = first.iter().map(|(name, bytes)| (*name, bytes.as_slice()));
    let sheets = series.sheets.iter().map(|(name, text)| (name.as_str(), text.as_bytes()));
    let files = first.chain(sheets).chain([("series.html", page.as_bytes())]);
    let mut written = Vec::with_capacity(series.sheets.len() + 3);
    for (name, bytes) in files {
        let path = directory.join(name);
        write_atomically(&path, bytes).map_err(|source| WriteError::Io { path: path.clone(), source })?;
        written.push(path);
    }
    Ok(written)
}
