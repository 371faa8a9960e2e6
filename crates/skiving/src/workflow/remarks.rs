//! Warnings about the poses, readings and results of a measured tool.

use super::measurement::Measurement;
use super::prepare::{CalibrationOutcome, PreparedSkiving};
use super::resharpening::Resharpening;
use super::result::{CorrectionResult, SkivedFlankResult};
use crate::job::LightBarrier;
use crate::measuring::Sense;
use std::collections::BTreeMap;
use verdict::Remark;

/// Referee and prediction that differ by more are no matter of second order, um.
const UNPROVEN_UM: f64 = 0.5;
/// Standard deviation of a wobble, rad, above which it is not known: a tool that wobbles more is seen without a light barrier.
const UNKNOWN_WOBBLE: f64 = 1e-3;
/// A calibrated beam this far from the given one, mm and deg, is another beam (`docs/mathematics/skiving.md#light-barrier`).
const FAR: [f64; 2] = [1.0, 0.3];
/// Residuals of a calibration, in standard deviations of a switch, that do not come from noise.
const RESIDUAL: f64 = 4.0;

/// What a run has found.
pub(super) struct Findings<'a> {
    pub prepared: &'a PreparedSkiving,
    pub measurement: Option<&'a Measurement>,
    pub flanks: &'a BTreeMap<&'static str, SkivedFlankResult>,
    pub correction: Option<&'a CorrectionResult>,
}

/// All warnings.
pub(super) fn warnings(found: &Findings<'_>) -> Vec<Remark> {
    let mut warnings = found.prepared.warnings.clone();
    let mut warn = |code: &'static str, text: String, way_out: &str| {
        warnings.push(Remark { code, text, way_out: way_out.into() });
    };
    let bodies = &found.prepared.bodies;
    if let Some(calibration) = bodies.calibration.as_ref().filter(|c| c.result.measured) {
        of_calibration(&found.prepared.drawn.barrier, calibration, &mut warn);
    }
    let tracks = bodies.flanks.left.tracks.len();
    if tracks < 5 {
        let tracks = if tracks == 1 { "one track tells".into() } else { format!("{tracks} tracks tell") };
        let text = format!("{tracks} pitch and eccentricity, but little of the profile");
        warn("few-tracks", text, "measure five tracks or more");
    }
    let off = found.flanks.values().map(|flank| flank.model_difference_um[0]).fold(0.0, f64::max);
    if off > UNPROVEN_UM {
        let text = format!("the referee finds {off:.2} um of the workpiece's profile that are not predicted");
        warn(
            "prediction-unproven",
            text,
            "check the tool against the workpiece: another part of its edge may cut the flank",
        );
    }
    let Some(measurement) = found.measurement else { return warnings };
    of_readings(found.prepared, measurement, &mut warn);
    let mounting = &measurement.evaluation.mounting;
    if mounting.deviation[2].max(mounting.deviation[3]) > UNKNOWN_WOBBLE {
        let text = "the tracks do not tell the wobble of this tool from its eccentricity";
        warn("wobble-not-observed", text.into(), "take the wobble as unknown, or measure it at the shank");
    }
    if !mounting.left_out.is_empty() {
        let teeth: Vec<String> = mounting.left_out.iter().map(ToString::to_string).collect();
        let (which, verb) = if teeth.len() == 1 { ("tooth", "stands") } else { ("teeth", "stand") };
        let text = format!(
            "{which} {} {verb} out and does not count for clocking, means, mounting and correction",
            teeth.join(", ")
        );
        let text = if teeth.len() == 1 { text } else { text.replace("does not", "do not") };
        warn("teeth-left-out", text, "look there for chips and built-up edges");
    }
    of_resharpening(&measurement.resharpening, &mut warn);
    if let Some(correction) = found.correction.filter(|correction| !correction.at_limit.is_empty()) {
        let text = format!("the correction ends at the limit of {}", correction.at_limit.join(", "));
        let way_out =
            "leave out of `evaluation.settings` what gains little there, or widen `evaluation.limits`";
        warn("correction-at-limit", text, way_out);
    }
    warnings
}

/// What broken teeth do to the depth of the next grinding.
fn of_resharpening(found: &Resharpening, warn: &mut impl FnMut(&'static str, String, &str)) {
    let deepest = found.broken.iter().max_by(|a, b| a.depth_mm.total_cmp(&b.depth_mm));
    if let Some(edge) = deepest.filter(|edge| edge.depth_mm > 0.0) {
        let text = format!(
            "the chip of tooth {} ({} edge, {:.0} um missing) asks for at least {:.0} um off the rake faces; the edges that are not broken ask for {:.0} um",
            edge.tooth,
            edge.flank,
            edge.missing_um,
            1e3 * edge.depth_mm,
            1e3 * found.without_broken.depth_mm
        );
        let way_out = "look how far the chips reach down the clearance faces before grinding; or grind for the whole edges and leave the chips";
        warn("chips-to-grind-off", text, way_out);
    }
    if !found.not_covered.is_empty() {
        let teeth: Vec<String> = found.not_covered.iter().map(ToString::to_string).collect();
        let which = if teeth.len() == 1 { "tooth" } else { "teeth" };
        let text = format!(
            "the depth of resharpening does not count {which} {}: without all switches it is not known how deep they are broken",
            teeth.join(", ")
        );
        warn(
            "resharpening-not-covered",
            text,
            "measure these breaks another way, or leave these teeth broken",
        );
    }
}

fn of_calibration(
    given: &LightBarrier,
    calibration: &CalibrationOutcome,
    warn: &mut impl FnMut(&'static str, String, &str),
) {
    let found = &calibration.result;
    let away = (found.point_mm[0] - given.point[0]).hypot(found.point_mm[1] - given.point[1]);
    // A beam that does not rise is not calibrated.
    let [tilt_x, tilt_y] = given.tilts_deg().unwrap_or([0.0; 2]);
    let turned = (found.tilt_x_deg - tilt_x).abs().max((found.tilt_y_deg - tilt_y).abs());
    if away > FAR[0] || turned > FAR[1] {
        let text = format!(
            "the calibrated beam lies {away:.3} mm and {turned:.3} deg from the one of [light_barrier]"
        );
        warn("calibration-far", text, "check the switches of the mandrel, or correct [light_barrier]");
    }
    let noise = calibration.noise_um;
    if noise > 0.0 && found.residual_um > RESIDUAL * noise {
        let text =
            format!("a switch of the mandrel lies {:.2} um off the calibrated beam", found.residual_um);
        warn("calibration-residual", text, "check the switches, or measure the mandrel again");
    }
}

fn of_readings(
    prepared: &PreparedSkiving,
    measurement: &Measurement,
    warn: &mut impl FnMut(&'static str, String, &str),
) {
    let taken = &measurement.taken;
    let barrier = &prepared.bodies.barrier;
    let delay = barrier.speed * barrier.latency;
    if taken.senses.len() == 1 && delay > 0.0 {
        let text = format!(
            "in one sense the delay of the barrier shifts the clocking of the tool by {:.5} deg",
            delay.to_degrees()
        );
        warn("latency-not-removed", text, "measure in both senses, or do not use the clocking");
    }
    if let Some(first) = measurement.measured.missing.first() {
        let text = format!(
            "{} switches are missing, the first that of tooth {} on track {} of the {} flank; these teeth count for nothing",
            measurement.measured.missing.len(),
            first.tooth,
            first.track + 1,
            first.flank
        );
        warn("switches-missing", text, "look whether these teeth are broken off, else measure again");
    }
    let wanted = (prepared.recording.senses, prepared.recording.revolutions);
    if (taken.senses.as_slice(), taken.revolutions) != wanted {
        let words = |senses: &[Sense], revolutions: usize| {
            let senses = if senses.len() == 2 { "both senses" } else { "one sense" };
            format!("{senses}, {revolutions} revolutions in each")
        };
        let text = format!(
            "the readings were taken in {}; [measuring] says {}",
            words(&taken.senses, taken.revolutions),
            words(wanted.0, wanted.1)
        );
        warn(
            "readings-differ",
            text,
            "correct [measuring]: time and scatter in the result are those of the readings",
        );
    }
}
