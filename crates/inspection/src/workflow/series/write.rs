//! Writes a series: document, table, sheets, page. All files of one series stand together.

use super::{InspectionSeries, tables};
use crate::page::series::series_page;
use report::html;
use run::{SetFile, WriteError, json, write_set};
use std::path::{Path, PathBuf};

/// Writes `series.json`, `series.csv`, the sheets and `series.html` into `directory` (made if missing); returns their paths, the page last.
///
/// # Errors
/// [`WriteError`]; the files of an earlier run stay.
pub fn write_inspection_series(
    series: &InspectionSeries,
    directory: &Path,
) -> Result<Vec<PathBuf>, WriteError> {
    let page = html::render(&series_page(series)?);
    let first = [
        ("series.json", json(&series.result)?),
        ("series.csv", tables::values(&series.result)?.text().into()),
    ];
    let first = first.iter().map(|(name, bytes)| (*name, bytes.as_slice()));
    let sheets = series.sheets.iter().map(|(name, text)| (name.as_str(), text.as_bytes()));
    let files: Vec<SetFile<'_>> = first.chain(sheets).chain([("series.html", page.as_bytes())]).collect();
    write_set(directory, &files, &[])
}
