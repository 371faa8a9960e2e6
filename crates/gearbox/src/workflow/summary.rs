//! What a run comes to for callers that treat all processes alike, and what a terminal shows of it.

use super::result::{ExploreResult, GearboxResult, RangeUm, ServoResult};
use super::run::GearboxOutcome;
use super::write::write_gearbox;
use erased_serde::Serialize;
use run::summary::{closing, fixed, give};
use run::{TaskOutcome, WriteError};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use verdict::Verdict;

impl TaskOutcome for GearboxOutcome {
    fn job(&self) -> &str {
        &self.result.job
    }

    fn verdict(&self) -> Option<&Verdict> {
        Some(&self.result.verdict)
    }

    fn result(&self) -> &dyn Serialize {
        &self.result
    }

    fn write(&self, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
        write_gearbox(self, directory)
    }

    fn summary(&self, written: &[PathBuf], _: usize) -> String {
        summary(&self.result, written)
    }
}

fn summary(result: &GearboxResult, written: &[PathBuf]) -> String {
    let mut text = String::new();
    let p = &result.pulses;
    // Writing to a text cannot fail.
    let _ = writeln!(
        text,
        "{}: {} reference pulses, {} intermediate, {} corrections: {} pulses, net {}",
        result.job, p.references, p.intermediates, p.corrections, p.pulses, p.net_pulses
    );
    let _ = writeln!(
        text,
        "  rotation {} workpiece pulses and {}/{} ({:.6} deg); b = {:.9}",
        p.rotation_workpiece_pulses,
        p.rotation_rest_parts,
        result.settings.pulses_per_interval,
        p.rotation_deg,
        result.coupling.coefficient
    );
    let _ = writeln!(
        text,
        "  alarms: {} too fast, {} overruns (v_max {:.1} mm/min)",
        p.too_fast, p.overruns, result.settings.greatest_speed_mm_per_min
    );
    errors(&mut text, result);
    additions(&mut text, result);
    if let Some(servo) = &result.servo {
        of_servo(&mut text, servo);
    }
    if let Some(explored) = &result.explore {
        of_set_ups(&mut text, explored);
    }
    let tolerance = result.tolerance_um.map_or_else(String::new, |um| format!(" (tolerance {um} um)"));
    let _ = writeln!(text, "  target {}{tolerance}", result.verdict.status().words());
    if let Some(reason) = result.verdict.reason() {
        give(&mut text, reason);
    }
    closing(&mut text, &result.verdict, &result.warnings, &result.timing_s, written);
    text
}

fn errors(text: &mut String, result: &GearboxResult) {
    let um = result.coupling.flank_um_per_feed_um;
    let (Some(along), Some(angle)) = (&result.along_feed, &result.angle) else { return };
    let ends = |range: RangeUm, scale: f64| {
        format!("{} to {} um", fixed(range.least_um * scale, 4), fixed(range.greatest_um * scale, 4))
    };
    let limits =
        angle.bound.map_or_else(|| "no limits".into(), |bound| format!("limits {}", ends(bound, 1.0)));
    let _ = writeln!(text, "  rotation at the flank {} ({limits})", ends(angle.flank, 1.0));
    if let Some(steady) = along.steady {
        let limits = along
            .steady_bound
            .map_or_else(|| "no limits".into(), |bound| format!("limits {}", ends(bound, um)));
        let _ = writeln!(text, "  feed at the flank, constant speed {} ({limits})", ends(steady, um));
    }
    if let Some((axial, flank)) = along.direction_offset_um.zip(along.direction_offset_flank_um) {
        let _ = writeln!(
            text,
            "  down less up {} um along the feed, {} um at the flank",
            fixed(axial, 4),
            fixed(flank, 4)
        );
    }
}

/// What the job adds: what is measured wrongly, added rotation, voltage, engagement, other multipliers.
fn additions(text: &mut String, result: &GearboxResult) {
    let ends = |range: RangeUm| format!("{} to {} um", fixed(range.least_um, 4), fixed(range.greatest_um, 4));
    if let Some(errors) = &result.errors {
        let _ = writeln!(text, "  measured wrongly, at the flank up to {:.4} um", errors.sum_flank_um);
        if let Some(encoder) = &errors.encoder {
            let _ = writeln!(
                text,
                "  encoder on the teeth: single pitch {:.4} um, cumulative pitch {:.4} um, normal to the flank",
                encoder.single_pitch_um, encoder.cumulative_pitch_um
            );
        }
    }
    for correction in &result.corrections {
        let _ = writeln!(
            text,
            "  added over the {}: {} at the flank, up to {:.4} deg/s",
            correction.axis,
            ends(correction.flank),
            correction.greatest_speed_deg_per_s
        );
    }
    if let Some(split) = &result.split {
        let _ = writeln!(
            text,
            "  {} whole pulses forward, {} backward, and {:.4} V; voltage off by {} at the flank",
            split.forward_pulses,
            split.backward_pulses,
            split.voltage_v,
            ends(split.error)
        );
    }
    if let Some(e) = &result.engagement {
        let _ = writeln!(
            text,
            "  in the gap after {:.4} s: ramp {:.4} s, move {:.4} deg; counter wrapped {} times, {} counts a cycle",
            e.coupled_after_s, e.ramp_s, e.phase_move_deg, e.counter_wraps, e.counts_a_cycle
        );
    }
    for compared in &result.compare {
        let steady = compared.steady_flank_um.map_or_else(|| "none".to_owned(), |um| format!("{um:.4} um"));
        let _ = writeln!(
            text,
            "  {}: {:.4} um at the flank, at constant speed {steady} about its mean",
            compared.multiplier, compared.flank_um
        );
    }
}

fn of_servo(text: &mut String, servo: &ServoResult) {
    let _ = writeln!(
        text,
        "  servo: workpiece rms {:.4} um, peak {:.4} um at the flank; torque up to {:.2} N m, {:.2} % of the samples at its limit",
        servo.workpiece.rms_um,
        servo.workpiece.peak_um,
        servo.greatest_torque_n_m,
        1e2 * servo.torque_limited_share
    );
}

fn of_set_ups(text: &mut String, explored: &ExploreResult) {
    let _ = writeln!(
        text,
        "  {} of {} set-ups keep to {} um at the flank",
        explored.feasible,
        explored.set_ups.len(),
        explored.wanted_um
    );
    let Some(best) = explored.best else { return };
    let s = best.set_up;
    let _ = writeln!(
        text,
        "  cheapest, cost {}: {} pulses per metre, {} Hz, P = {}, {} pulses per revolution; budget {:.4} um",
        s.cost,
        s.pulses_per_metre,
        s.clock_hz,
        s.pulses_per_interval,
        s.pulses_per_revolution,
        s.flank_um.unwrap_or_default()
    );
    if let Some(measured) = best.measured_steady_um {
        let _ = writeln!(text, "  simulated, feed at the flank, constant speed: {measured:.4} um");
    }
}
