//! From a checked job to the measured tool, the workpiece under the referee, and the verdict.

use super::measurement::{Measurement, evaluated, simulated};
use super::outcome::{flank_results, measurement_result, settings, track_results};
use super::prepare::{SkivingBodies, prepare_skiving};
use super::program_work::programs;
use super::programs::ToolProgram;
use super::readings_file::ReadingsFile;
use super::real_tool::real_tool;
use super::remarks::{Findings, warnings};
use super::result::SkivingResult;
use super::scan::{Scan, scan};
use super::verdict::{Judged, is_sound, verdict};
use super::{conventional, history, monte_carlo, referee};
use crate::job::{LoadedSkivingJob, SkivingJob};
use crate::readings::read_skiving_readings;
use foundation::numerics::Progress;
use job::{Diagnostic, Problem};
use run::{JobFailure, Release, RunFailure};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::Instant;
use verdict::Verdict;

/// Everything that a run produces.
pub struct SkivingOutcome {
    /// The document of `result.json`.
    pub result: SkivingResult,
    /// Edges, tracks, poses.
    pub bodies: SkivingBodies,
    /// The measured tool.
    pub measurement: Option<Measurement>,
    /// The scan of a stylus.
    pub scan: Option<Scan>,
    /// Measuring programs.
    pub programs: Vec<ToolProgram>,
    /// Whether tracks and poses are those of an edge that makes the flank: programs of others are written on request only.
    pub sound: bool,
    /// The measurement as a line of the tool's history, and what is known since.
    pub history: Option<history::Noted>,
}

/// Runs a job: its readings if it names some, else the tool with its errors, else the poses alone.
///
/// # Errors
/// [`JobFailure`]: bad input, or a tool that cannot be measured.
pub fn run_skiving(loaded: &LoadedSkivingJob, progress: &dyn Progress) -> Result<SkivingOutcome, JobFailure> {
    let readings = readings_of_job(loaded);
    run(loaded, readings.as_deref().map(named_by_job), progress)
}

/// Measures the tool of `[tool_errors]`.
///
/// # Errors
/// As [`run_skiving`]; a job without such a tool.
pub fn simulate_skiving(
    loaded: &LoadedSkivingJob,
    progress: &dyn Progress,
) -> Result<SkivingOutcome, JobFailure> {
    if loaded.job.tool_errors.is_none() {
        let finding =
            Diagnostic::new(Problem::MissingKey, "the job has no tool whose measurement could be simulated")
                .field("tool_errors")
                .way_out("add `[tool_errors]`; an empty table is a tool without errors");
        return Err(RunFailure::bad_input(finding).into());
    }
    run(loaded, None, progress)
}

/// Evaluates a file of switching angles as measured on the tool of a job.
///
/// # Errors
/// As [`run_skiving`].
pub fn inspect_skiving(
    loaded: &LoadedSkivingJob,
    file: &Path,
    progress: &dyn Progress,
) -> Result<SkivingOutcome, JobFailure> {
    run(loaded, Some((file, None)), progress)
}

/// Tables that need something measured: a job may leave that to the file that `inspect` is given.
fn needs_measurement(job: &SkivingJob, measured: bool) -> Result<(), RunFailure> {
    let tables = [("history", job.history.is_some()), ("monte_carlo", job.monte_carlo.is_some())];
    match tables.into_iter().find(|(_, given)| *given && !measured) {
        None => Ok(()),
        Some((table, _)) => {
            let message = format!("[{table}] needs a measured tool, and nothing is measured");
            let finding = Diagnostic::new(Problem::MissingKey, message)
                .field(table)
                .allowed("a table [readings] or [tool_errors], or a file given to `flankwright inspect`")
                .way_out(format!("add `[readings]`, or leave `[{table}]` out"));
            Err(RunFailure::bad_input(finding))
        }
    }
}

/// The file of readings that a job names.
fn readings_of_job(loaded: &LoadedSkivingJob) -> Option<PathBuf> {
    loaded.job.readings.as_ref().map(|given| loaded.beside(&given.file))
}

/// A file of readings with the key that names it.
type NamedReadings<'a> = (&'a Path, Option<&'static str>);

fn named_by_job(path: &Path) -> NamedReadings<'_> {
    (path, Some("readings.file"))
}

/// What a job measures: its readings if it names some, else the tool with its errors, else nothing.
///
/// # Errors
/// As [`run_skiving`].
pub(super) fn measured_of_job(
    loaded: &LoadedSkivingJob,
    bodies: &SkivingBodies,
) -> Result<Option<Measurement>, JobFailure> {
    let readings = readings_of_job(loaded);
    measured(&loaded.job, bodies, readings.as_deref().map(named_by_job))
}

fn measured(
    job: &SkivingJob,
    bodies: &SkivingBodies,
    readings: Option<NamedReadings<'_>>,
) -> Result<Option<Measurement>, JobFailure> {
    Ok(match (readings, &job.tool_errors) {
        (Some((path, key)), _) => {
            let seen = read_skiving_readings(path, job.measuring.tracks.len())?;
            let name = path.display().to_string();
            Some(evaluated(bodies, seen, &ReadingsFile { name: &name, key })?)
        }
        (None, Some(errors)) => Some(simulated(job, bodies, real_tool(bodies, errors)?)?),
        (None, None) => None,
    })
}

fn run(
    loaded: &LoadedSkivingJob,
    readings: Option<NamedReadings<'_>>,
    progress: &dyn Progress,
) -> Result<SkivingOutcome, JobFailure> {
    let job = &loaded.job;
    needs_measurement(job, readings.is_some() || job.tool_errors.is_some())?;
    let mut timing = BTreeMap::new();
    let begun = Instant::now();
    let bodies = prepare_skiving(loaded)?;
    timing.insert("edges and poses", begun.elapsed().as_secs_f64());

    let begun = Instant::now();
    let measurement = measured(job, &bodies, readings)?;
    timing.insert("measurement", begun.elapsed().as_secs_f64());

    let begun = Instant::now();
    let left = referee::of_measurement(&bodies, measurement.as_ref(), progress)?;
    timing.insert("referee", begun.elapsed().as_secs_f64());

    let begun = Instant::now();
    let conventional = conventional::conventional(&bodies, measurement.as_ref());
    let scan = job.stylus.as_ref().map(|given| scan(&bodies, given, measurement.as_ref())).transpose()?;
    timing.insert("comparison", begun.elapsed().as_secs_f64());

    let begun = Instant::now();
    let monte_carlo = match (&job.monte_carlo, &measurement) {
        (Some(given), Some(measurement)) => {
            Some(monte_carlo::monte_carlo(given, &bodies, measurement, progress)?)
        }
        _ => None,
    };
    if monte_carlo.is_some() {
        timing.insert("Monte Carlo", begun.elapsed().as_secs_f64());
    }

    let begun = Instant::now();
    let programs = programs(loaded, &bodies, scan.as_ref(), progress)?;
    if !programs.is_empty() {
        timing.insert("programs", begun.elapsed().as_secs_f64());
    }

    let flanks = flank_results(&bodies, measurement.as_ref(), &left);
    let measured = measurement.as_ref().map(|m| measurement_result(&bodies, m));
    let tolerance_um = job.target.tolerance_um;
    let judged = Judged {
        job,
        bodies: &bodies,
        measured: measurement.as_ref().zip(measured.as_ref()),
        flanks: &flanks,
        programs: programs.iter().map(|program| program.file.clone()).collect(),
    };
    let (verdict, sound) = (verdict(&judged), is_sound(&judged));
    let history = history::noted(loaded, &bodies, measured.as_ref(), measurement.as_ref())?;
    let correction = measured.as_ref().map(|m| &m.correction);
    let found =
        Findings { job, bodies: &bodies, measurement: measurement.as_ref(), flanks: &flanks, correction };
    let mut warnings = warnings(&found);
    warnings.extend(history.iter().flat_map(|noted| noted.remarks.clone()));
    if !programs.is_empty() {
        warnings.extend(release(&verdict, sound, job).remark(&verdict));
    }
    let result = SkivingResult {
        job: job.job.name.clone(),
        process: "skiving-tool-measuring",
        version: env!("CARGO_PKG_VERSION"),
        verdict,
        tolerance_um,
        warnings,
        settings: settings(&bodies),
        flanks,
        tracks: track_results(&bodies),
        measuring_time_s: measuring_time(job, measurement.as_ref()),
        measurement: measured,
        conventional,
        scan: scan.as_ref().map(|scan| scan.result.clone()),
        calibration: bodies.calibration.as_ref().map(|calibration| calibration.result.clone()),
        history: history.as_ref().map(|noted| noted.result.clone()),
        monte_carlo,
        programs: programs.iter().map(ToolProgram::result).collect(),
        timing_s: timing,
    };
    Ok(SkivingOutcome { result, bodies, measurement, scan, programs, sound, history })
}

/// Measuring programs are there to find out about a tool, however it turns out: they are written with the verdict in their first lines.
/// Only where the ideal edge does not make the flank their poses are in doubt, and they are written on request.
pub(super) fn release(verdict: &Verdict, sound: bool, job: &SkivingJob) -> Release {
    Release::of(verdict, sound || job.output.programs_of_missed)
}

/// flanks x tracks x (revolutions x 60/rpm x senses + time of a move), `docs/mathematics/skiving.md#light-barrier`.
fn measuring_time(job: &SkivingJob, measurement: Option<&Measurement>) -> f64 {
    let measuring = &job.measuring;
    let poses = 2.0 * measuring.tracks.len() as f64;
    let turns = match measurement {
        Some(m) => (m.taken.revolutions * m.taken.senses.len()) as f64,
        None => (measuring.revolutions * measuring.senses.list().len()) as f64,
    };
    poses * (turns * 60.0 / measuring.speed_rpm + measuring.move_time_s)
}
