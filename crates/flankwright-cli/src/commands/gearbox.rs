//! `flankwright gearbox`: the electronic gearbox on a stimulus.

use std::fmt::Write;
use std::path::PathBuf;

use clap::Args;
use flankwright::exchange::job::{JobInfo, Process};
use flankwright::exchange::{AnyJob, Diagnostic, Loaded, Problem};
use flankwright::workflow::gearbox::{
    ExploreResult, GearboxResult, RangeUm, ServoResult, run_gearbox, write_gearbox,
};

use super::outcome::{Verdict, closing, conclude, fixed, tell, unwritten};
use crate::arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;
use crate::progress::Bars;

/// Arguments of `gearbox`.
#[derive(Args, Debug)]
#[command(
    after_help = "Example:\n  flankwright gearbox examples/gearbox/feed-to-and-fro.toml -o results\n\n\
    Takes jobs of the process \"electronic-gearbox\" (flankwright new electronic-gearbox). Writes result.json and report.html,\n\
    errors.csv for a motion, servo.csv with [servo], set-ups.csv with [explore], pulses.csv with output.pulse_trace.\n\
    Exit status 3: errors beyond target.tolerance_um, alarms or a motor at its limit where a tolerance is given, or [explore] found no\n\
    set-up that is accurate enough. Without target.tolerance_um errors are reported and not judged."
)]
pub struct GearboxArguments {
    /// The job file (TOML or JSON); `-` reads standard input
    #[arg(value_name = "JOB")]
    pub job: PathBuf,
    /// Arguments that every command has.
    #[command(flatten)]
    pub common: CommonArguments,
}

/// Runs the gearbox, writes its files and prints counters and errors.
///
/// # Errors
/// Everything that is wrong with job and reference pulses, files that cannot be written.
pub fn run(arguments: &GearboxArguments) -> Result<Exit, Failure> {
    let common = &arguments.common;
    let loaded = match output::load_any_job(&arguments.job)? {
        AnyJob::Gearbox(loaded) => loaded,
        AnyJob::Grinding(loaded) => return Err(other_process(&loaded, &loaded.job.job)),
        AnyJob::Tangential(loaded) => return Err(other_process(&loaded, &loaded.job.job)),
        AnyJob::Milling(loaded) => return Err(other_process(&loaded, &loaded.job.job)),
        AnyJob::Skiving(loaded) => return Err(other_process(&loaded, &loaded.job.job)),
    };
    let bars = Bars::new(common.quiet);
    let outcome = run_gearbox(&loaded, &bars);
    bars.finish();
    let outcome = outcome.map_err(|failure| Failure::of_job_or_file(&loaded, failure))?;
    let directory = output::own_directory(common, &loaded, &loaded.job.job)?;
    let written = write_gearbox(&loaded.job, &outcome, &directory).map_err(unwritten)?;
    output::note_owner(common, &loaded, &directory)?;
    let result = &outcome.result;
    let verdict = Verdict::of(&result.job, &result.verdict);
    conclude(common, result, verdict, || summary(result, &written))
}

fn other_process<J>(loaded: &Loaded<J>, job: &JobInfo) -> Failure {
    let name = job.process.name();
    let message = format!("`gearbox` does not take a job of the process \"{name}\"");
    let finding = Diagnostic::new(Problem::ProcessNotAvailable, message)
        .field("job.process")
        .value(format!("\"{name}\""))
        .allowed(format!("\"{}\"", Process::ElectronicGearbox.name()))
        .way_out("plan it with `flankwright plan`, or begin with `flankwright new electronic-gearbox`");
    loaded.error(finding).into()
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
    if let Some(servo) = &result.servo {
        of_servo(&mut text, servo);
    }
    if let Some(explored) = &result.explore {
        of_set_ups(&mut text, explored);
    }
    let tolerance = result.tolerance_um.map_or_else(String::new, |um| format!(" (tolerance {um} um)"));
    let _ = writeln!(text, "  target {}{tolerance}", result.verdict.status().words());
    if let Some(reason) = result.verdict.reason() {
        tell(&mut text, reason);
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
