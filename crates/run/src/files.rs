//! The files of a run: made in memory first, then written as one set ([`super::output_set`]), the page last.

use super::output_set::{SetFile, write_set};
use super::write_error::WriteError;
use report::charts::ChartError;
use std::path::{Path, PathBuf};

/// Writes document, table and page of a study into `directory` (made if missing); returns their paths, the page last.
pub fn write_study(
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

/// A file below the directory of a run: its path, what is in it, its bytes.
pub type NamedFile = (String, &'static str, Vec<u8>);

/// Makes the report that lists all files, removes what an earlier run left, and writes everything, the report last.
pub fn write_with_report(
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

/// A document as its file holds it: indented, with a line end.
pub fn json(value: &impl serde::Serialize) -> Result<Vec<u8>, serde_json::Error> {
    let mut bytes = serde_json::to_vec_pretty(value)?;
    bytes.push(b'\n');
    Ok(bytes)
}
