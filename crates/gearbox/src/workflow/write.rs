//! Writes what a run of the electronic gearbox produced. Every file appears whole or not at all.

use super::run::GearboxOutcome;
use super::tables;
use crate::page;
use run::{NamedFile, WriteError, json, write_with_report};
use std::path::{Path, PathBuf};

/// Writes all files of a run into `directory` (made if missing); returns the paths in the order written, the report last.
///
/// # Errors
/// [`WriteError`]; files written before the error stay.
pub fn write_gearbox(outcome: &GearboxOutcome, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
    let result = &outcome.result;
    let mut files: Vec<NamedFile> =
        vec![("result.json".into(), "counters, errors and their budget", json(result)?)];
    if !outcome.run.bins.is_empty() {
        files.push((
            "errors.csv".into(),
            "errors along the feed and at the flank over time",
            tables::errors(outcome)?.text().into(),
        ));
    }
    if let Some(record) = &outcome.servo {
        let table = tables::servo(record, result.coupling.flank_um_per_rad)?;
        files.push(("servo.csv".into(), "errors and torque of the servo over time", table.text().into()));
    }
    if let Some(explored) = &result.explore {
        let table = tables::set_ups(explored)?;
        files.push(("set-ups.csv".into(), "all set-ups with their budgets", table.text().into()));
    }
    if let Some(trace) = &outcome.trace {
        let table = tables::pulses(trace, result.settings.clock_hz)?;
        files.push(("pulses.csv".into(), "every pulse and what it turned", table.text().into()));
    }
    if let Some(trace) = &outcome.split_trace {
        let table = tables::split(trace, result.settings.clock_hz)?;
        files.push(("split.csv".into(), "every change of whole pulses and voltage", table.text().into()));
    }
    if let Some(record) = &outcome.engaging {
        let table = tables::engagement(record)?;
        files.push(("engagement.csv".into(), "the way into the gap over time", table.text().into()));
    }
    write_with_report(files, directory, |named| page::html_page(outcome, named))
}
