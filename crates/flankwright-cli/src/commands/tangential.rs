//! `plan` and `simulate` of tangential dressing: runs the job, writes its files, prints a summary.

use std::fmt::Write;
use std::path::PathBuf;

use flankwright::exchange::{AnyJob, LoadedTangentialJob};
use flankwright::workflow::RunFailure;
use flankwright::workflow::tangential::{
    TangentialOutcome, TangentialResult, plan_tangential, simulate_tangential, write_tangential,
};

use super::outcome::{Verdict, closing, conclude, controlled, fixed, opening, proven, refuse, unwritten};
use crate::arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;
use crate::progress::Bars;

/// Plans the job, writes its files and prints a summary.
///
/// # Errors
/// Everything that is wrong with the job, a target that these bodies cannot make, files that cannot be written.
pub fn plan(loaded: &LoadedTangentialJob, common: &CommonArguments) -> Result<Exit, Failure> {
    let bars = Bars::new(common.quiet);
    let planned = plan_tangential(loaded, &bars);
    bars.finish();
    deliver(loaded, common, planned)
}

/// Runs the settings of the job, writes its files and prints a summary.
///
/// # Errors
/// As [`plan`]; a job without settings.
pub fn simulate(loaded: &LoadedTangentialJob, common: &CommonArguments) -> Result<Exit, Failure> {
    let bars = Bars::new(common.quiet);
    let simulated = simulate_tangential(loaded, &bars);
    bars.finish();
    deliver(loaded, common, simulated)
}

fn deliver(
    loaded: &LoadedTangentialJob,
    common: &CommonArguments,
    run: Result<TangentialOutcome, RunFailure>,
) -> Result<Exit, Failure> {
    let job = &loaded.job;
    let directory = output::own_directory(common, loaded, &job.job)?;
    let outcome = run.map_err(|failure| refuse(&AnyJob::Tangential(loaded.clone()), failure, &directory))?;
    let written = write_tangential(loaded, &outcome, &directory).map_err(unwritten)?;
    output::note_owner(common, loaded, &directory)?;
    let result = &outcome.result;
    let verdict = Verdict::of(&result.job, &result.verdict);
    conclude(common, result, verdict, || summary(result, &written))
}

fn summary(result: &TangentialResult, written: &[PathBuf]) -> String {
    let worst = result.flanks.values().map(|f| f.flank.max_deviation_um).fold(0.0, f64::max);
    let verdict = Verdict::of(&result.job, &result.verdict);
    let mut text = opening(&verdict, worst, result.tolerance_um);
    for pass in &result.passes {
        let names: Vec<String> =
            pass.variables.iter().map(|v| format!("{} {}", v.name, fixed(v.value, 5))).collect();
        let _ = writeln!(
            text,
            "  {}: {} variables by {} in {} rounds: {}",
            pass.flanks.join(" and "),
            names.len(),
            pass.method,
            pass.rounds,
            names.join(", ")
        );
    }
    for (flank, f) in &result.flanks {
        let [from, to] = f.dresser_position_mm;
        let _ = writeln!(
            text,
            "  {flank:<5} deviation max {:.4} um, rms {:.4} um; analytic against referee {:.2e} um, without a surface between the stages {:.1e} um",
            f.flank.max_deviation_um,
            f.flank.rms_deviation_um,
            f.flank.model_difference_um,
            f.sample_difference_um
        );
        let _ = writeln!(text, "        dresser from {from:.2} to {to:.2} mm on the worm");
        if let Some(radial) = &f.radial_feed {
            let left = radial
                .max_deviation_um
                .map_or_else(|| "no flank".to_owned(), |um| format!("up to {um:.3} um off"));
            let twist = radial.twist_normal_um.unwrap_or(radial.closed_twist_normal_um);
            let _ = writeln!(text, "        radial feed would leave {} um of twist, {left}", fixed(twist, 3));
        }
    }
    text += &controlled(result.control.as_ref());
    text += &proven(result.programs.as_ref());
    closing(&mut text, &result.verdict, &result.warnings, &result.timing_s, written);
    text
}
