//! Writes what is known of a measured bevel gear. Every file appears whole or not at all.

use super::run::BevelInspection;
use super::tables;
use crate::page::bevel::html_page;
use run::{NamedFile, WriteError, json, standing_elsewhere, write_with_report};
use std::path::{Path, PathBuf};

/// Writes result, tables, the corrected job and the report into `directory` (made if missing); returns their paths, the report last.
///
/// # Errors
/// [`WriteError`]; files written before the error stay.
pub fn write_bevel_inspection(found: &BevelInspection, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
    let result = &found.result;
    let mut files: Vec<NamedFile> = vec![
        ("result.json".into(), "everything that is known of the gear", json(result)?),
        (
            "flanks.csv".into(),
            "target, simulated and measured flank at every point",
            tables::flanks(result)?.text().into(),
        ),
    ];
    if !result.pitch.is_empty() {
        let what = "cumulative pitch of every tooth";
        files.push(("pitch.csv".into(), what, tables::pitch(result)?.text().into()));
    }
    if let Some(job) = &found.corrected {
        let what = "the job with the compensation that answers the measurement: input of `flankwright plan`";
        files.push(("corrected-job.json".into(), what, json(&standing_elsewhere(job, &job.job)?)?));
    }
    write_with_report(files, directory, |named| html_page(found, named))
}
