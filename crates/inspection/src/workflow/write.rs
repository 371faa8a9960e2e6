//! Writes what is known of a measured gear. Every file appears whole or not at all.

use super::run::GearInspection;
use super::sheet::{SheetOptions, inspection_sheet};
use super::tables;
use crate::page::measured_gear::html_page;
use measured_files::inspection::{Inspection, trace_table};
use run::{NamedFile, WriteError, json, standing_elsewhere, write_with_report};
use std::path::{Path, PathBuf};

/// Writes result, tables, the corrected job, the sheet and the report into `directory` (made if missing); returns their paths, the report last.
///
/// # Errors
/// [`WriteError`]; files written before the error stay.
pub fn write_gear_inspection(
    found: &GearInspection,
    options: &SheetOptions,
    directory: &Path,
) -> Result<Vec<PathBuf>, WriteError> {
    let result = &found.result;
    let mut files: Vec<NamedFile> = vec![
        ("result.json".into(), "everything that is known of the gear", json(result)?),
        ("traces.csv".into(), "characteristic values of every trace", tables::traces(result)?.text().into()),
    ];
    if !result.pitch.is_empty() {
        let what = "cumulative pitch of every tooth";
        files.push(("pitch.csv".into(), what, tables::pitch(result)?.text().into()));
    }
    if let Some(job) = found.rounds.iter().rev().find_map(|round| round.corrected.as_ref()) {
        let what = "the job with the compensation that answers the measurement: input of `flankwright plan`";
        files.push(("corrected-job.json".into(), what, json(&standing_elsewhere(job, &job.job)?)?));
    }
    if let Some(job) = found.rounds.iter().rev().find_map(|round| round.corrected_milling.as_ref()) {
        let what = "the job with the compensation that answers the measurement: input of `flankwright plan`";
        files.push(("corrected-job.json".into(), what, json(&standing_elsewhere(job, &job.job)?)?));
    }
    for round in found.rounds.iter().filter(|round| is_simulated(&round.inspection)) {
        let path = format!("measured-{}.csv", round.result.round);
        let table = trace_table(&round.inspection.traces)?;
        files.push((path, "simulated measurement: input of `flankwright inspect`", table.text().into()));
    }
    let sheet = inspection_sheet(found, options)?;
    files.push(("sheet.html".into(), "the inspection sheet, to be printed", sheet.into_bytes()));
    write_with_report(files, directory, |named| html_page(found, named))
}

/// Whether no file holds the measurement.
fn is_simulated(inspection: &Inspection) -> bool {
    inspection.sources.is_empty()
}
