//! Writes what a milling run produced. Every file appears whole or not at all.

use super::run::MillingOutcome;
use super::{meshes, tables, tool_result};
use crate::page::html_page;
use run::{NamedFile, Release, WriteError, json, write_with_report};
use std::path::{Path, PathBuf};

/// Writes all files of a run into `directory` (made if missing); returns the paths in the order written, the report last.
///
/// # Errors
/// [`WriteError`]; files written before the error stay.
pub fn write_milling(outcome: &MillingOutcome, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
    let output = &outcome.prepared.output;
    let mut files: Vec<NamedFile> = vec![
        ("result.json".into(), "result with rows and flanks", json(&outcome.result)?),
        (
            "topography.csv".into(),
            "prediction and deviation at every ray",
            tables::topography(&outcome.result)?.text().into(),
        ),
        (
            "motions/places.csv".into(),
            "places of the cutter in one space",
            tables::places(&outcome.plan)?.text().into(),
        ),
        (
            "tools.csv".into(),
            "tools with lengths, radii, speeds, feeds and coolant",
            tool_result::tool_table(&outcome.result.tools)?.text().into(),
        ),
    ];
    let points = &outcome.prepared.measuring_points;
    if !points.is_empty() {
        let what = "points and normals at which the flanks are measured";
        files.push(("measuring-grid.csv".into(), what, tables::measuring_grid(points)?.text().into()));
    }
    let release = Release::of(&outcome.result.verdict, output.programs_of_missed);
    for program in outcome.texts.programs.iter().flat_map(|programs| &programs.programs) {
        let text = release.program(&program.written.text, program.dialect);
        files.extend(text.map(|text| (program.file.clone(), "NC program: milling all spaces", text)));
    }
    for cycle in &outcome.texts.cycles {
        let text = release.program(&cycle.text, cycle.dialect);
        files.extend(text.map(|text| (cycle.file.clone(), "NC program: finds the clocking angle", text)));
    }
    if let Some(locations) = &outcome.texts.locations {
        let text = release.cutter_locations(&locations.text);
        files.extend(text.map(|text| (locations.file.clone(), "cutter locations of all spaces", text)));
    }
    files.extend(meshes::files(outcome, &output.meshes)?);
    write_with_report(files, directory, |named| html_page(outcome, named))
}
