//! What a run comes to for callers that treat all processes alike, and what a terminal shows of it.

use super::result::{MeasurementResult, SkivingResult};
use super::run::SkivingOutcome;
use super::scene::scene_of_skiving;
use super::write::write_skiving;
use erased_serde::Serialize;
use run::summary::{closing, fixed, opening};
use run::{RunFailure, TaskOutcome, WriteError};
use scene::Scene;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use verdict::Verdict;

impl TaskOutcome for SkivingOutcome {
    fn job(&self) -> &str {
        &self.result.job
    }

    fn verdict(&self) -> Option<&Verdict> {
        Some(&self.result.verdict)
    }

    fn result(&self) -> &dyn Serialize {
        &self.result
    }

    fn scene(&self) -> Option<Result<Scene, RunFailure>> {
        Some(scene_of_skiving(self))
    }

    fn write(&self, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
        write_skiving(self, directory)
    }

    fn summary(&self, written: &[PathBuf], _: usize) -> String {
        summary(&self.result, written)
    }
}

fn summary(result: &SkivingResult, written: &[PathBuf]) -> String {
    let worst = result.flanks.values().map(|flank| flank.max_deviation_um).fold(0.0, f64::max);
    let mut text = opening(&result.job, &result.verdict, worst, result.tolerance_um);
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
    if let Some(found) = &result.runout {
        let [before, after] = found.simulated_spread_um;
        let _ = writeln!(
            text,
            "  run-out answered over the turn of the tool: the teeth differ by {after:.2} um in place of {before:.2} um under the referee, prediction within {:.4} um",
            found.model_difference_um
        );
    }
    if let Some(found) = &result.probe {
        let largest = found.flanks.values().map(|of| of.largest_um).fold(0.0, f64::max);
        let left =
            found.flanks.values().map(|of| of.corrected_simulated_um.unwrap_or(of.corrected_largest_um));
        let _ = writeln!(
            text,
            "  workpiece under the probe: {largest:.2} um off, {:.2} um after a further correction: centre distance {:.2} um, tool angle {:.5} deg",
            left.fold(0.0, f64::max),
            found.correction.centre_distance_um,
            found.correction.tool_angle_deg
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
