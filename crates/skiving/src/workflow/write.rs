//! Writes what a run produced. Every file appears whole or not at all.

use super::run::SkivingOutcome;
use super::tables;
use crate::page::html_page;
use crate::probe_readings::probe_table;
use crate::readings::readings_table;
use run::{NamedFile, WriteError, json, write_with_report};
use std::path::{Path, PathBuf};

/// Writes all files of a run into `directory` (made if missing); returns the paths in the order written, the report last.
///
/// # Errors
/// [`WriteError`]; files written before the error stay.
pub fn write_skiving(outcome: &SkivingOutcome, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
    let result = &outcome.result;
    let mut files: Vec<NamedFile> = vec![
        ("result.json".into(), "result with tracks, deviations, verdict", json(result)?),
        (
            "topography.csv".into(),
            "profile of the workpiece: target, planned, simulated, corrected",
            tables::profile(result)?.text().into(),
        ),
        ("motions/poses.csv".into(), "tracks and poses", tables::poses(result)?.text().into()),
    ];
    if let Some(measured) = &result.measurement {
        files.push((
            "deviations.csv".into(),
            "deviation of every tooth on every track",
            tables::deviations(measured)?.text().into(),
        ));
        if let Some(measurement) = &outcome.measurement {
            let data = &measurement.resharpening;
            files.push((
                "resharpening.json".into(),
                "what grinding the tool again has to take off, tooth by tooth",
                json(data)?,
            ));
            files.push(("resharpening.csv".into(), "the same as a table", data.table()?.text().into()));
            if measurement.tool.is_some() {
                let readings = readings_table(&measurement.readings)?;
                files.push(("readings.csv".into(), "switching angles", readings.text().into()));
            }
        }
        files.push(("pitch.csv".into(), "pitch and thickness", tables::pitch(measured)?.text().into()));
    }
    if let Some(scan) = &result.scan {
        files.push(("motions/scan.csv".into(), "scan of a stylus", tables::scan(scan)?.text().into()));
    }
    if let Some(probed) = outcome.probed.as_ref().filter(|probed| probed.simulated) {
        let table = probe_table(&probed.values)?;
        files.push(("workpiece.csv".into(), "profiles of the workpiece by the probe", table.text().into()));
    }
    let release = outcome.prepared.release(&result.verdict, outcome.sound);
    for program in &outcome.programs {
        if let Some(text) = release.program(&program.written.text, program.dialect) {
            files.push((program.file.clone(), "NC program: measuring the tool", text));
        }
    }
    if let Some(found) = &result.monte_carlo {
        files.push((
            "monte-carlo.csv".into(),
            "scatter of every result over repeated measurements",
            tables::monte_carlo(found)?.text().into(),
        ));
    }
    write_with_report(files, directory, |named| html_page(outcome, named))
}
