//! From a checked job to the measured tool, the workpiece under the referee, and the verdict.

use super::measurement::{Measurement, evaluated, simulated};
use super::outcome::{flank_results, measurement_result, settings, track_results};
use super::prepare::{PreparedSkiving, needs_measurement, prepare_skiving};
use super::program_work::programs;
use super::programs::ToolProgram;
use super::readings_file::ReadingsFile;
use super::real_tool::real_tool;
use super::remarks::{Findings, warnings};
use super::result::SkivingResult;
use super::scan::{Scan, scan};
use super::verdict::{Judged, is_sound, verdict};
use super::{conventional, history, monte_carlo, probe, referee, runout};
use crate::job::LoadedSkivingJob;
use crate::readings::read_skiving_readings;
use foundation::numerics::Progress;
use job::{Diagnostic, Problem};
use run::{JobFailure, RunFailure};
use std::collections::BTreeMap;
use std::path::Path;
use std::time::Instant;

/// Everything that a run produces.
#[derive(Clone, Debug)]
pub struct SkivingOutcome {
    /// The document of `result.json`.
    pub result: SkivingResult,
    /// Edges, tracks and poses, and what was done with them.
    pub prepared: PreparedSkiving,
    /// The measured tool.
    pub measurement: Option<Measurement>,
    /// The scan of a stylus.
    pub scan: Option<Scan>,
    /// The measured workpiece.
    pub probed: Option<probe::Probed>,
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
    run(loaded, Source::Job, progress)
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
    run(loaded, Source::Tool, progress)
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
    run(loaded, Source::File(file), progress)
}

/// A file of readings with the key that names it.
type NamedReadings<'a> = (&'a Path, Option<&'static str>);

/// The file of readings that the job names.
fn own_readings(prepared: &PreparedSkiving) -> Option<NamedReadings<'_>> {
    prepared.readings.as_deref().map(|path| (path, Some("readings.file")))
}

/// What a job measures: its readings if it names some, else the tool with its errors, else nothing.
///
/// # Errors
/// As [`run_skiving`].
pub(super) fn measured_of_job(prepared: &PreparedSkiving) -> Result<Option<Measurement>, JobFailure> {
    measured(prepared, own_readings(prepared))
}

fn measured(
    prepared: &PreparedSkiving,
    readings: Option<NamedReadings<'_>>,
) -> Result<Option<Measurement>, JobFailure> {
    let bodies = &prepared.bodies;
    Ok(match (readings, &prepared.tool_errors) {
        (Some((path, key)), _) => {
            let seen = read_skiving_readings(path, bodies.flanks.left.tracks.len())?;
            let name = path.display().to_string();
            Some(evaluated(bodies, seen, &ReadingsFile { name: &name, key })?)
        }
        (None, Some(errors)) => Some(simulated(bodies, &prepared.recording, real_tool(bodies, errors)?)?),
        (None, None) => None,
    })
}

/// Where the readings of a run come from.
#[derive(Clone, Copy)]
enum Source<'a> {
    /// What the job names: its readings, else the tool with its errors.
    Job,
    /// The tool with its errors.
    Tool,
    /// A file.
    File(&'a Path),
}

fn run(
    loaded: &LoadedSkivingJob,
    source: Source<'_>,
    progress: &dyn Progress,
) -> Result<SkivingOutcome, JobFailure> {
    let read = match source {
        Source::Job => loaded.job.readings.is_some(),
        Source::Tool => false,
        Source::File(_) => true,
    };
    needs_measurement(&loaded.job, read || loaded.job.tool_errors.is_some())?;
    let begun = Instant::now();
    let prepared = prepare_skiving(loaded)?.on_machine(loaded)?;
    let timing = BTreeMap::from([("edges and poses", begun.elapsed().as_secs_f64())]);
    carried_out(prepared, source, timing, progress)
}

fn carried_out(
    prepared: PreparedSkiving,
    source: Source<'_>,
    mut timing: BTreeMap<&'static str, f64>,
    progress: &dyn Progress,
) -> Result<SkivingOutcome, JobFailure> {
    let bodies = &prepared.bodies;
    let begun = Instant::now();
    let measurement = match source {
        Source::Job => measured_of_job(&prepared)?,
        Source::Tool => measured(&prepared, None)?,
        Source::File(file) => measured(&prepared, Some((file, None)))?,
    };
    timing.insert("measurement", begun.elapsed().as_secs_f64());

    let begun = Instant::now();
    let runout = runout::fitted(&prepared, measurement.as_ref())?;
    let law = runout.as_ref().map(|fit| &fit.law);
    let left = referee::of_measurement(bodies, measurement.as_ref(), law, progress)?;
    timing.insert("referee", begun.elapsed().as_secs_f64());

    let begun = Instant::now();
    let conventional = conventional::conventional(bodies, measurement.as_ref());
    let scan = prepared.stylus.as_ref().map(|given| scan(bodies, given, measurement.as_ref())).transpose()?;
    timing.insert("comparison", begun.elapsed().as_secs_f64());

    let begun = Instant::now();
    let monte_carlo = match (&prepared.monte_carlo, &measurement) {
        (Some(given), Some(measurement)) => {
            Some(monte_carlo::monte_carlo(given, bodies, measurement, progress)?)
        }
        _ => None,
    };
    if monte_carlo.is_some() {
        timing.insert("Monte Carlo", begun.elapsed().as_secs_f64());
    }

    let begun = Instant::now();
    let probed = probe::probed(&prepared, measurement.as_ref(), law, progress)?;
    if probed.is_some() {
        timing.insert("probe", begun.elapsed().as_secs_f64());
    }
    let begun = Instant::now();
    let stroke = runout::stroke(&prepared, measurement.as_ref(), runout.as_ref(), left.corrected.as_ref());
    let programs = programs(&prepared, (scan.as_ref(), stroke.as_ref()), progress)?;
    if !programs.is_empty() {
        timing.insert("programs", begun.elapsed().as_secs_f64());
    }

    let flanks = flank_results(bodies, measurement.as_ref(), &left);
    let measured = measurement.as_ref().map(|m| measurement_result(bodies, m));
    let answered = measurement
        .as_ref()
        .zip(runout.as_ref())
        .map(|(measurement, fit)| runout::result(&prepared, measurement, fit, &left));
    let of_runout = answered.as_ref().map(|found| ("run-out correction", found.model_difference_um));
    let of_probe = probed
        .as_ref()
        .and_then(|probed| Some(("setting by the measured workpiece", probed.result.model_difference_um?)));
    let judged = Judged {
        prepared: &prepared,
        promised: of_runout.into_iter().chain(of_probe).collect(),
        measured: measurement.as_ref().zip(measured.as_ref()),
        flanks: &flanks,
        programs: programs.iter().map(|program| program.file.clone()).collect(),
    };
    let (verdict, sound) = (verdict(&judged), is_sound(&judged));
    let history = history::noted(&prepared, measured.as_ref(), measurement.as_ref())?;
    let correction = measured.as_ref().map(|m| &m.correction);
    let found =
        Findings { prepared: &prepared, measurement: measurement.as_ref(), flanks: &flanks, correction };
    let mut warnings = warnings(&found);
    warnings.extend(history.iter().flat_map(|noted| noted.remarks.clone()));
    if !programs.is_empty() {
        warnings.extend(prepared.release(&verdict, sound).remark(&verdict));
    }
    let result = SkivingResult {
        job: prepared.info.name.clone(),
        process: "skiving-tool-measuring",
        version: env!("CARGO_PKG_VERSION"),
        verdict,
        tolerance_um: prepared.tolerance_um,
        warnings,
        drawing: bodies.drawing.clone(),
        settings: settings(bodies),
        flanks,
        tracks: track_results(bodies),
        measuring_time_s: measuring_time(&prepared, measurement.as_ref()),
        measurement: measured,
        runout: answered,
        probe: probed.as_ref().map(|probed| probed.result.clone()),
        conventional,
        scan: scan.as_ref().map(|scan| scan.result.clone()),
        calibration: bodies.calibration.as_ref().map(|calibration| calibration.result.clone()),
        history: history.as_ref().map(|noted| noted.result.clone()),
        monte_carlo,
        programs: programs.iter().map(ToolProgram::result).collect(),
        timing_s: timing,
    };
    Ok(SkivingOutcome { result, prepared, measurement, scan, probed, programs, sound, history })
}

/// Time of all tracks of both flanks.
fn measuring_time(prepared: &PreparedSkiving, measurement: Option<&Measurement>) -> f64 {
    let recording = &prepared.recording;
    let turns = match measurement {
        Some(m) => m.taken.revolutions * m.taken.senses.len(),
        None => recording.revolutions * recording.senses.len(),
    };
    recording.time_s(2 * prepared.bodies.flanks.left.tracks.len(), turns)
}
