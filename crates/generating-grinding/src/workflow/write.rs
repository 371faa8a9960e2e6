//! Writes what a run produced: result, tables, settings, report, as one set ([`run::output_set`]).

use super::run::Outcome;
use super::tables;
use crate::job::{Job, LoadedJob};
use crate::page;
use crate::workflow::programs::run_programs::RunPrograms;
use foundation::geometry::{Flank, Sides};
use job::tables::OneOrSides;
use machine::Station;
use run::{NamedFile, Release, WriteError, json, standing_elsewhere, write_with_report};
use std::path::{Path, PathBuf};

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
    write_with_report(files, directory, |named| page::html_page(outcome, named))
}

/// The texts of the programs, as far as they are written.
pub fn program_files(programs: &RunPrograms, release: &Release) -> Vec<NamedFile> {
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

fn with_settings(job: &Job, outcome: &Outcome) -> Job {
    let mut job = Job { settings: Some(outcome.execution.settings()), ..job.clone() };
    if job.point_dresser().is_some() {
        // Laid by the plan from its target; the settings hold whatever the target becomes.
        let Sides { left, right } = outcome.prepared.setup.tool_direction.map(|_, t| t.atan().to_degrees());
        job.dressing.line_direction_deg = Some(OneOrSides::Each { left, right });
    }
    job
}
