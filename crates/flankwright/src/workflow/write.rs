//! Writes what a run produced: result, tables, settings, report, as one set ([`super::output_set`]).

use super::elsewhere::standing_elsewhere;
use super::output_set::{SetFile, write_set};
use super::programs::RunPrograms;
use super::release::Release;
use super::run::Outcome;
use super::{page, tables};
use crate::exchange::job::{Job, OneOrSides};
use crate::exchange::mesh::MeshError;
use crate::exchange::{CsvError, LoadedJob};
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
    /// Another run writes into the folder and does not come to an end.
    #[error("another run is writing into {path}")]
    Busy {
        /// The folder.
        path: PathBuf,
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
    let document = json(document)?;
    let files: [SetFile<'_>; 3] =
        [("explore.json", &document), ("explore.csv", table.as_bytes()), ("explore.html", page.as_bytes())];
    write_set(directory, &files, &[])
}

/// Writes all files of a run into `directory` (made if missing); returns the paths in the order written, the report last.
///
/// # Errors
/// [`WriteError`]; the files of an earlier run stay.
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
    let files: Vec<SetFile<'_>> = files.iter().map(|(name, _, bytes)| (name.as_str(), &bytes[..])).collect();
    let programs = programs_there(directory);
    let known: Vec<&str> = NAMES.into_iter().chain(programs.iter().map(String::as_str)).collect();
    write_set(directory, &files, &known)
}

/// Programs that an earlier run may have written: of any operation and area, for a control that we write for.
fn programs_there(directory: &Path) -> Vec<String> {
    const OPERATIONS: [&str; 4] = ["dressing-", "grinding-", "milling-", "measuring-"];
    const CONTROLS: [&str; 4] = ["-linuxcnc.ngc", "-linuxcnc.hal", "-siemens.mpf", "-fanuc.nc"];
    // A folder that cannot be read holds nothing that could be removed.
    let Ok(entries) = std::fs::read_dir(directory.join("programs")) else { return Vec::new() };
    let names = entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok());
    let ours = |name: &String| {
        OPERATIONS.iter().any(|start| name.starts_with(start))
            && CONTROLS.iter().any(|end| name.ends_with(end))
    };
    names.filter(ours).map(|name| format!("programs/{name}")).collect()
}

/// Names that a run may write; what an earlier run left of them and this one does not write would contradict it.
const NAMES: [&str; 24] = [
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
    "report.html",
];

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
