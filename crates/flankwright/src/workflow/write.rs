//! Writes what a run produced: result, tables, settings, report. Every file appears whole or not at all.

use super::elsewhere::standing_elsewhere;
use super::programs::RunPrograms;
use super::release::Release;
use super::run::Outcome;
use super::{page, tables};
use crate::exchange::job::{Job, JobInfo, OneOrSides};
use crate::exchange::mesh::MeshError;
use crate::exchange::{CsvError, Diagnostic, LoadedJob, write_atomically};
use crate::geometry::{Flank, Sides};
use crate::machine::Station;
use crate::report::charts::ChartError;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Why the files of a run could not be written.
#[derive(Debug, Error)]
pub enum WriteError {
    /// The directory or a file cannot be written.
    #[error("cannot write {path}: {source}")]
    Io {
        /// Where.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// A table holds a value that is no number.
    #[error(transparent)]
    Table(#[from] CsvError),
    /// A chart cannot be drawn.
    #[error("the report cannot be drawn: {0}")]
    Chart(#[from] ChartError),
    /// A body cannot be written as a mesh.
    #[error("the mesh cannot be written: {0}")]
    Mesh(#[from] MeshError),
    /// The result cannot be written as JSON.
    #[error("the result cannot be written as JSON: {0}")]
    Json(#[from] serde_json::Error),
}

/// Writes document, table and page of a study into `directory` (made if missing); returns their paths, the page last.
pub(super) fn write_study(
    document: &impl serde::Serialize,
    table: &str,
    page: &str,
    directory: &Path,
) -> Result<Vec<PathBuf>, WriteError> {
    let files = [
        ("explore.json", json(document)?),
        ("explore.csv", table.as_bytes().to_vec()),
        ("explore.html", page.as_bytes().to_vec()),
    ];
    let mut written = Vec::with_capacity(files.len());
    for (name, bytes) in files {
        let path = directory.join(name);
        let failed = |source| WriteError::Io { path: path.clone(), source };
        std::fs::create_dir_all(directory).map_err(failed)?;
        write_atomically(&path, &bytes).map_err(failed)?;
        written.push(path);
    }
    Ok(written)
}

/// Writes all files of a run into `directory` (made if missing); returns the paths in the order written, the report last.
///
/// # Errors
/// [`WriteError`]; files written before the error stay.
pub fn write_outcome(
    loaded: &LoadedJob,
    outcome: &Outcome,
    directory: &Path,
) -> Result<Vec<PathBuf>, WriteError> {
    let job = &loaded.job;
    let mut files: Vec<NamedFile> = vec![
        ("result.json".into(), "result with settings and flanks", json(&outcome.result)?),
        (
            "settings.json".into(),
            "the job with its settings: input of `flankwright simulate`",
            json(&standing_elsewhere(loaded, &with_settings(job, outcome))?)?,
        ),
        (
            "topography.csv".into(),
            "target, planned, simulated and deviation of both flanks",
            tables::topography(outcome.result.flanks.iter().map(|(name, f)| (*name, f)))?.text().into(),
        ),
        (
            "motions/grinding.csv".into(),
            "grinding motion over the feed",
            tables::grinding_motion(&outcome.execution.motion, outcome.execution.feed_range)?.text().into(),
        ),
    ];
    if let Some(table) = tables::gear_root(outcome)? {
        files.push(("gear-root.csv".into(), "sections of the ground root", table.text().into()));
    }
    for flank in Flank::BOTH {
        if let Some(table) = tables::dressing_motion(outcome, flank)? {
            let path = format!("motions/dressing-{flank}.csv");
            files.push((path, "dressing motion over the worm position", table.text().into()));
        }
        if let Some(table) = tables::dressing_lines(outcome, flank)? {
            let path = format!("motions/dressing-lines-{flank}.csv");
            let what = "motion of the disc along the lines of one thread; the others follow by their share of a turn";
            files.push((path, what, table.text().into()));
        }
        if let Some(table) = tables::tool_flank(outcome, flank)? {
            let path = format!("tool-{flank}.csv");
            files.push((path, "modification of the tool's flank, normal", table.text().into()));
        }
    }
    let release = Release::of(&outcome.result.verdict, job.output.programs_of_missed);
    files.extend(outcome.programs.iter().flat_map(|programs| program_files(programs, &release)));
    write_with_report(files, directory, |named| page::html_page(job, outcome, named))
}

/// The texts of the programs, as far as they are written.
pub(super) fn program_files(programs: &RunPrograms, release: &Release) -> Vec<NamedFile> {
    let mut files: Vec<NamedFile> = Vec::new();
    for program in &programs.built.programs {
        let what = match program.station {
            Station::Dresser => "NC program: dressing the worm",
            Station::Work => "NC program: grinding the gear",
        };
        if let Some(text) = release.program(&program.written.text, program.dialect) {
            files.push((program.file.clone(), what, text));
        }
        if let Some(netlist) = program.written.hal.as_ref().and_then(|netlist| release.netlist(netlist)) {
            let path = program.file.replace(".ngc", ".hal");
            files.push((path, "HAL netlist of the electronic gearbox", netlist));
        }
    }
    files
}

/// A file below the directory of a run: its path, what is in it, its bytes.
pub(super) type NamedFile = (String, &'static str, Vec<u8>);

/// Makes the report that lists all files, removes what an earlier run left, and writes everything, the report last.
pub(super) fn write_with_report(
    mut files: Vec<NamedFile>,
    directory: &Path,
    report: impl FnOnce(&[(String, &'static str)]) -> Result<String, ChartError>,
) -> Result<Vec<PathBuf>, WriteError> {
    let mut named: Vec<(String, &'static str)> =
        files.iter().map(|(path, what, _)| (path.clone(), *what)).collect();
    named.push(("report.html".into(), "this report"));
    files.push(("report.html".into(), "report", report(&named)?.into_bytes()));
    let names: Vec<&str> = files.iter().map(|file| file.0.as_str()).collect();
    remove_stale(directory, &names)?;
    let mut written = Vec::with_capacity(files.len());
    for (name, _, bytes) in files {
        let path = directory.join(&name);
        let failed = |source| WriteError::Io { path: path.clone(), source };
        if let Some(parent) = path.parent() {
            std::fs::create_dir_all(parent).map_err(failed)?;
        }
        write_atomically(&path, &bytes).map_err(failed)?;
        written.push(path);
    }
    Ok(written)
}

/// Names that a run may write; what an earlier run left of them and this one does not write would contradict it.
const NAMES: [&str; 31] = [
    "result.json",
    "corrected-job.json",
    "traces.csv",
    "pitch.csv",
    "sheet.html",
    "settings.json",
    "topography.csv",
    "sensitivities.csv",
    "fit.csv",
    "motions/grinding.csv",
    "motions/grinding-left.csv",
    "motions/grinding-right.csv",
    "motions/dressing-left.csv",
    "motions/dressing-right.csv",
    "motions/dressing-lines-left.csv",
    "motions/dressing-lines-right.csv",
    "tool-left.csv",
    "tool-right.csv",
    "gear-root.csv",
    "errors.csv",
    "servo.csv",
    "set-ups.csv",
    "pulses.csv",
    "programs/dressing-linuxcnc.ngc",
    "programs/dressing-siemens.mpf",
    "programs/dressing-fanuc.nc",
    "programs/grinding-linuxcnc.ngc",
    "programs/grinding-linuxcnc.hal",
    "programs/grinding-siemens.mpf",
    "programs/grinding-fanuc.nc",
    "report.html",
];

/// Removes files of an earlier run that are not among those of this one.
fn remove_stale(directory: &Path, written: &[&str]) -> Result<(), WriteError> {
    for name in NAMES.iter().filter(|name| !written.contains(name)) {
        let path = directory.join(name);
        match std::fs::remove_file(&path) {
            Err(source) if source.kind() != std::io::ErrorKind::NotFound => {
                return Err(WriteError::Io { path, source });
            }
            _ => {}
        }
    }
    Ok(())
}

/// Writes `result.json` of a job that these bodies cannot make: status, limit and way out.
///
/// # Errors
/// [`WriteError`].
pub fn write_refusal(
    job: &JobInfo,
    tolerance_um: f64,
    finding: &Diagnostic,
    directory: &Path,
) -> Result<PathBuf, WriteError> {
    let document = serde_json::json!({
        "job": job.name,
        "process": job.process.name(),
        "version": env!("CARGO_PKG_VERSION"),
        "status": "not_producible",
        "tolerance_um": tolerance_um,
        "reason": { "code": finding.code, "text": finding.message, "way_out": finding.way_out, "field": finding.field },
        "warnings": [],
        "settings": {},
        "flanks": {},
        "timing_s": {},
    });
    let path = directory.join("result.json");
    let failed = |source| WriteError::Io { path: path.clone(), source };
    std::fs::create_dir_all(directory).map_err(failed)?;
    write_atomically(&path, &json(&document)?).map_err(failed)?;
    remove_stale(directory, &["result.json"])?;
    Ok(path)
}

fn with_settings(job: &Job, outcome: &Outcome) -> Job {
    let mut job = Job { settings: Some(outcome.execution.settings()), ..job.clone() };
    if job.point_dresser().is_some() {
        // Laid by the plan from its target; the settings hold whatever the target becomes.
        let Sides { left, right } = outcome.prepared.setup.tool_direction.map(|_, t| t.atan().to_degrees());
        job.dressing.line_direction_deg = Some(OneOrSides::Each { left, right });
    }
    job
}

pub(super) fn json(value: &impl serde::Serialize) -> Result<Vec<u8>, serde_json::Error> {
    let mut bytes = serde_json::to_vec_pretty(value)?;
    bytes.push(b'\n');
    Ok(bytes)
}
