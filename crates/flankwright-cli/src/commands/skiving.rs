//! `plan`, `simulate` and `inspect` of measuring a skiving tool: runs the job, writes its files, prints a summary.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use flankwright::exchange::{AnyJob, LoadedSkivingJob};
use flankwright::workflow::JobFailure;
use flankwright::workflow::skiving::{
    MeasurementResult, SkivingOutcome, SkivingResult, inspect_skiving, run_skiving, simulate_skiving,
    write_skiving,
};

use super::outcome::{Verdict, closing, conclude, fixed, opening, refuse, unwritten};
use crate::arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;
use crate::progress::Bars;

/// Lays tracks and poses, and measures the tool of the job or evaluates its readings.
///
/// # Errors
/// Everything that is wrong with the job and its readings, a tool that cannot be measured, files that cannot be written.
pub fn plan(loaded: &LoadedSkivingJob, common: &CommonArguments) -> Result<Exit, Failure> {
    let bars = Bars::new(common.quiet);
    let run = run_skiving(loaded, &bars);
    bars.finish();
    deliver(loaded, common, run)
}

/// Measures the tool of `[tool_errors]`.
///
/// # Errors
/// As [`plan`]; a job without such a tool.
pub fn simulate(loaded: &LoadedSkivingJob, common: &CommonArguments) -> Result<Exit, Failure> {
    let bars = Bars::new(common.quiet);
    let run = simulate_skiving(loaded, &bars);
    bars.finish();
    deliver(loaded, common, run)
}

/// Evaluates a file of switching angles.
///
/// # Errors
/// As [`plan`].
pub fn inspect(loaded: &LoadedSkivingJob, file: &Path, common: &CommonArguments) -> Result<Exit, Failure> {
    let bars = Bars::new(common.quiet);
    let run = inspect_skiving(loaded, file, &bars);
    bars.finish();
    deliver(loaded, common, run)
}

fn deliver(
    loaded: &LoadedSkivingJob,
    common: &CommonArguments,
    run: Result<SkivingOutcome, JobFailure>,
) -> Result<Exit, Failure> {
    let job = &loaded.job;
    let directory = output::own_directory(common, loaded, &job.job)?;
    let outcome = match run {
        Ok(outcome) => outcome,
        Err(JobFailure::Job(failure)) => {
            return Err(refuse(&AnyJob::Skiving(loaded.clone()), failure, &directory));
        }
        Err(failure) => return Err(Failure::of_job_or_file(loaded, failure)),
    };
    let written = write_skiving(job, &outcome, &directory).map_err(unwritten)?;
    output::note_owner(common, loaded, &directory)?;
    let result = &outcome.result;
    let verdict = Verdict::of(&result.job, &result.verdict);
    conclude(common, result, verdict, || summary(result, &written))
}

fn summary(result: &SkivingResult, written: &[PathBuf]) -> String {
    let worst = result.flanks.values().map(|flank| flank.max_deviation_um).fold(0.0, f64::max);
    let verdict = Verdict::of(&result.job, &result.verdict);
    let mut text = opening(&verdict, worst, result.tolerance_um);
    for (name, tracks) in &result.tracks {
        let lean = tracks.iter().map(|track| track.off_flank_deg).fold(0.0, f64::max);
        let gap = tracks.iter().map(|track| track.other_flank_gap_mm).fold(f64::INFINITY, f64::min);
        // Writing to a text cannot fail.
        let _ = writeln!(
            text,
            "  {name}: {} tracks, beam up to {lean:.2} deg off the helix, other flanks {gap:.2} mm away",
            tracks.len()
        );
    }
    if let Some(measured) = &result.measurement {
        of_measurement(&mut text, measured);
    }
    for (name, flank) in &result.flanks {
        let [mean, each] = flank.model_difference_um;
        let _ = writeln!(
            text,
            "  {name} flank of the workpiece: prediction within {mean:.4} um of the referee, tooth by tooth within {each:.4} um"
        );
    }
    let _ = writeln!(text, "  measuring takes {:.0} s", result.measuring_time_s);
    closing(&mut text, &result.verdict, &result.warnings, &result.timing_s, written);
    text
}

fn of_measurement(text: &mut String, measured: &MeasurementResult) {
    let pitch = &measured.pitch;
    let _ = writeln!(
        text,
        "  pitch: F_p {:.2} um, f_p,max {:.2} um; {} readings, {} to each deviation",
        pitch.total_um, pitch.largest_single_um, measured.readings, measured.readings_each
    );
    let [x, y] = measured.mounting.eccentricity_um;
    let spread = measured
        .mounting
        .eccentricity_sigma_um
        .map_or_else(String::new, |[x, y]| format!(" (standard deviations {x:.3} and {y:.3} um)"));
    let _ = writeln!(text, "  eccentricity {x:.2} and {y:.2} um{spread}");
    for (name, means) in &measured.profile.track_mean_um {
        let means: Vec<String> = means.iter().map(|um| fixed(*um, 2)).collect();
        let worn = if measured.profile.worn[name] { ", worn" } else { "" };
        let _ = writeln!(text, "  {name} edge, mean of each track: {} um{worn}", means.join(", "));
    }
    let correction = &measured.correction;
    let [before, after] = correction.rms_um;
    let changes = [
        ("centre distance", correction.centre_distance_um, 2, "um"),
        ("crossed-axes angle", correction.crossed_axes_angle_deg, 5, "deg"),
        ("tool shift", correction.tool_shift_um, 2, "um"),
        ("tool angle", correction.tool_angle_deg, 5, "deg"),
    ];
    let told: Vec<String> = changes
        .into_iter()
        .filter(|(name, ..)| correction.settings.contains(name))
        .map(|(name, change, decimals, unit)| format!("{name} {} {unit}", fixed(change, decimals)))
        .collect();
    let _ = writeln!(text, "  correction: {}: rms {before:.2} -> {after:.2} um", told.join(", "));
}
