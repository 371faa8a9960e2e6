//! A measurement for a job of generating grinding: target, planned, simulated and measured flank on one grid, which part is systematic, which
//! correction of grinding and dressing removes it, what stays, the corrected job, and the referee's proof. The measurement is a file, or
//! that of a simulated machine with deviations of its own, in rounds.

mod characteristics;
mod correction;
mod ground;
mod lines;
mod probe;
mod result;
mod round;
mod surface;

pub use result::{
    CharacteristicResult, CorrectedSettingResult, CorrectionResult, DifferenceResult, MachineChange,
    MeasuredFlankResult, ProofResult, RoundResult,
};
pub use round::Round;

use super::drawn::DrawnGear;
use super::files::{MeasuredFiles, read_measurement};
use crate::exchange::{Diagnostic, LoadedJob, Problem};
use crate::numerics::Progress;
use crate::workflow::finding::{JobFailure, RunFailure};
use ground::ground;
pub(super) use round::Wanted;
use round::judge;
use std::path::Path;

/// Judges a measured file against a job.
///
/// # Errors
/// [`JobFailure`]: what is wrong with file and job, a measurement of another gear, jobs for which no correction is known.
pub(super) fn of_file(
    loaded: &LoadedJob,
    path: &Path,
    progress: &dyn Progress,
) -> Result<(Round, MeasuredFiles), JobFailure> {
    let made = ground(loaded, progress)?;
    let drawn = DrawnGear::of_job(loaded, &made.prepared.setup)?;
    let mut files = read_measurement(path, Some(&drawn))?;
    fill(&mut files, &drawn);
    let wanted = Wanted::of_job(loaded)?;
    let round = judge(loaded, &made, &wanted, files.inspection.clone(), 1, progress)?;
    Ok((round, files))
}

/// What a file leaves open of ranges and reference lengths is that of the job.
fn fill(files: &mut MeasuredFiles, drawn: &DrawnGear) {
    let (own, job) = (&mut files.inspection.conditions, &drawn.conditions);
    for (flank, of) in job.flanks.iter() {
        let open = &mut own.flanks[flank];
        open.w_1_mm = open.w_1_mm.or(of.w_1_mm);
        open.w_2_mm = open.w_2_mm.or(of.w_2_mm);
        open.z_1_mm = open.z_1_mm.or(of.z_1_mm);
        open.z_2_mm = open.z_2_mm.or(of.z_2_mm);
    }
    own.helix_slope_reference = own.helix_slope_reference.or(job.helix_slope_reference);
    own.profile_slope_reference = own.profile_slope_reference.or(job.profile_slope_reference);
}

/// Measures and corrects a simulated machine until nothing is worth a correction, or its rounds are over. The last round only measures.
///
/// # Errors
/// [`RunFailure`]: a job without `[inspection.simulated]`, and those of planning, referee and evaluation.
pub(super) fn simulated(loaded: &LoadedJob, progress: &dyn Progress) -> Result<Vec<Round>, RunFailure> {
    let Some(of) = loaded.job.inspection.as_ref().and_then(|table| table.simulated.clone()) else {
        let finding = Diagnostic::new(
            Problem::MissingKey,
            "there is no measurement: neither a file nor a simulated one",
        )
        .field("inspection.simulated")
        .way_out("name a file (`flankwright inspect FILE --job JOB`), or give the table");
        return Err(RunFailure::bad_input(finding));
    };
    let wanted = Wanted::of_job(loaded)?;
    let mut job = loaded.clone();
    let mut made = ground(&job, progress)?;
    let mut rounds = Vec::new();
    for number in 1..=of.rounds + 1 {
        let drawn = DrawnGear::of_job(&job, &made.prepared.setup)?;
        let real = made.with_deviations(&job, &of, progress)?;
        let found = probe::measured(&drawn, &made.prepared.setup.pair.work, &real, &of, number);
        let mut round = judge(&job, &made, &wanted, found, number, progress)?;
        let next = round.next.take().zip(round.corrected.clone());
        rounds.push(round);
        let Some((planned, corrected)) = next else { break };
        (made, job) = (planned, corrected);
    }
    Ok(rounds)
}
