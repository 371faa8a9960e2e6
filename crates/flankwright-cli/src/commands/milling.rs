//! `plan` of five-axis milling: runs the job, writes its files, prints a summary.

use std::fmt::Write;
use std::path::PathBuf;

use flankwright::exchange::{AnyJob, LoadedMillingJob};
use flankwright::workflow::milling::{MillingResult, run_milling, write_milling};

use super::outcome::{Verdict, closing, conclude, opening, refuse, unwritten};
use crate::arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;
use crate::progress::Bars;

/// Plans the job, writes its files and prints a summary.
///
/// # Errors
/// Everything that is wrong with the job, a flank that these cutters cannot make, files that cannot be written.
pub fn plan(loaded: &LoadedMillingJob, common: &CommonArguments) -> Result<Exit, Failure> {
    let job = &loaded.job;
    let bars = Bars::new(common.quiet);
    let planned = run_milling(loaded, &bars);
    bars.finish();
    let directory = output::own_directory(common, loaded, &job.job)?;
    let outcome = planned.map_err(|failure| refuse(&AnyJob::Milling(loaded.clone()), failure, &directory))?;
    let written = write_milling(job, &outcome, &directory).map_err(unwritten)?;
    output::note_owner(common, loaded, &directory)?;
    let result = &outcome.result;
    let verdict = Verdict::of(&result.job, &result.verdict);
    conclude(common, result, verdict, || summary(result, &written))
}

fn summary(result: &MillingResult, written: &[PathBuf]) -> String {
    let worst = result.flanks.values().map(|flank| flank.max_deviation_um).fold(0.0, f64::max);
    let verdict = Verdict::of(&result.job, &result.verdict);
    let mut text = opening(&verdict, worst, result.tolerance_um);
    for (name, flank) in &result.flanks {
        let [lowest, highest] = flank.stock_um;
        let _ = writeln!(
            text,
            "  {name}: {} rows, {lowest:.3} to {highest:.3} um, rms {:.3} um; prediction and rays on this flank differ by {:.4} um",
            flank.rows.len(),
            flank.rms_deviation_um,
            flank.model_difference_um
        );
    }
    for operation in &result.operations {
        let _ = writeln!(
            text,
            "  {}: {} paths, {} places, {:.0} mm",
            operation.name, operation.paths, operation.places, operation.way_mm
        );
    }
    for program in &result.programs {
        let _ = writeln!(
            text,
            "  {}: {} blocks, {:.0} s, read back within {:.3} um (explained: {:.3} um)",
            program.file,
            program.blocks,
            program.duration_s,
            program.proof_difference_um,
            program.proof_allowed_um
        );
    }
    closing(&mut text, &result.verdict, &result.warnings, &result.timing_s, written);
    text
}
