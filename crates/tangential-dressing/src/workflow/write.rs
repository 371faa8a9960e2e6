//! Writes what a run of tangential dressing produced. Every file appears whole or not at all.

use super::run::TangentialOutcome;
use super::tables;
use crate::TangentialFlank;
use crate::job::{LoadedTangentialJob, TangentialJob};
use crate::page;
use contact::Measure;
use foundation::geometry::Flank;
use generating_grinding::workflow::tables::{grinding_motion, topography};
use generating_grinding::workflow::write::program_files;
use run::{NamedFile, Release, WriteError, json, standing_elsewhere, write_with_report};
use std::path::{Path, PathBuf};

/// Writes all files of a run into `directory` (made if missing); returns the paths in the order written, the report last.
///
/// # Errors
/// [`WriteError`]; files written before the error stay.
pub fn write_tangential(
    loaded: &LoadedTangentialJob,
    outcome: &TangentialOutcome,
    directory: &Path,
) -> Result<Vec<PathBuf>, WriteError> {
    let result = &outcome.result;
    let with_settings =
        TangentialJob { settings: Some(result.settings.settings.clone()), ..loaded.job.clone() };
    let flanks = result.flanks.iter().map(|(name, f)| (*name, &f.flank));
    let mut files: Vec<NamedFile> = vec![
        ("result.json".into(), "result with settings and flanks", json(result)?),
        (
            "settings.json".into(),
            "the job with its settings: input of `flankwright simulate`",
            json(&standing_elsewhere(loaded, &with_settings)?)?,
        ),
        (
            "topography.csv".into(),
            "target, planned, simulated and deviation of both flanks",
            topography(flanks)?.text().into(),
        ),
        (
            "sensitivities.csv".into(),
            "what a unit of each variable does to the unmodified flank",
            tables::sensitivities(outcome)?.text().into(),
        ),
    ];
    if !result.passes.is_empty() {
        files.push(("fit.csv".into(), "convergence of the fits", tables::fit(outcome)?.text().into()));
    }
    for flank in Flank::BOTH {
        if let Some(table) = tables::dressing_motion(outcome, flank)? {
            let path = format!("motions/dressing-{flank}.csv");
            files.push((path, "dressing motion over the position of the dresser", table.text().into()));
        }
        if let Some(run) = &outcome.flanks[flank] {
            let ground =
                TangentialFlank::new(&outcome.prepared.model, flank, &run.pass, &run.settings, Measure::Ray);
            let table = grinding_motion(ground.motion(), run.strokes.feed)?;
            let path = format!("motions/grinding-{flank}.csv");
            files.push((path, "grinding motion over the feed", table.text().into()));
        }
    }
    let release = Release::of(&result.verdict, outcome.prepared.output.programs_of_missed);
    files.extend(outcome.programs.iter().flat_map(|programs| program_files(programs, &release)));
    write_with_report(files, directory, |named| page::html_page(outcome, named))
}
