//! A measurement for a job of generating grinding: target, planned, simulated and measured flank on one grid, which part is systematic, which
//! correction of grinding and dressing removes it, what stays, the corrected job, and the referee's proof. The measurement is a file, or
//! that of a simulated machine with deviations of its own, in rounds.

mod axes;
mod bevel;
mod characteristics;
mod correction;
mod flank_correction;
mod ground;
mod lines;
mod milled;
mod probe;
mod result;
mod round;

use super::files_content::MeasuredFiles;
pub use result::{
    AxesTogether, AxisResult, CharacteristicResult, CorrectedSettingResult, CorrectionResult,
    DifferenceResult, JointAxis, MachineChange, MeasuredFlankResult, ProofResult, RoundResult,
};
pub use round::Round;

use super::asked::Asked;
use super::drawn::DrawnGear;
use super::files::read_measurement;
use super::statements::Statements;
pub(super) use bevel::{BevelRound, GridTeeth, MilledBevel};
use foundation::numerics::Progress;
use generating_grinding::job::LoadedJob;
use ground::ground;
use job::{Diagnostic, Problem};
pub(super) use milled::of_milled_file;
use round::judge;
pub(super) use round::of_header;
use run::{JobFailure, RunFailure};
use std::path::Path;
use verdict::Remark;

/// Judges a measured file against a job with what it asks.
///
/// # Errors
/// [`JobFailure`]: what is wrong with file and job, a measurement of another gear, jobs for which no correction is known.
pub(super) fn of_file(
    loaded: &LoadedJob,
    asked: &Asked,
    (path, statements): (&Path, &Statements),
    progress: &dyn Progress,
) -> Result<(Round, MeasuredFiles), JobFailure> {
    let made = ground(loaded.clone(), progress)?;
    let drawn = DrawnGear::of_setup(&made.prepared.setup)?;
    let mut files = read_measurement(path, Some(&drawn), statements)?;
    check_teeth(&files)?;
    fill(&mut files, &drawn);
    let round = judge(&made, asked, files.inspection.clone(), 1, progress)?;
    Ok((round, files))
}

/// Teeth count from 1 up to those of the gear.
pub(super) fn check_teeth(files: &MeasuredFiles) -> Result<(), RunFailure> {
    let inspection = &files.inspection;
    let last = inspection.gear.teeth.unsigned_abs();
    let traces = inspection.traces.iter().map(|trace| trace.tooth);
    let mut all = traces.chain(inspection.topographies.iter().map(|field| field.tooth));
    let Some(tooth) = all.find(|tooth| !(1..=last).contains(tooth)) else { return Ok(()) };
    let finding = Diagnostic::new(Problem::InvalidNumber, format!("the gear has no tooth {tooth}"))
        .field("tooth")
        .value(tooth)
        .allowed(format!("1 to {last}"))
        .way_out("count the teeth from 1; give the job of the gear that was measured");
    Err(RunFailure::bad_input(finding))
}

/// Ranges closer than this are the same, mm.
const SAME_RANGE: f64 = 0.01;

/// Against a job its ranges count: those of the file may leave out what the job asks for. Reference lengths of slopes are the file's, else
/// the job's.
fn fill(files: &mut MeasuredFiles, drawn: &DrawnGear) {
    let (own, job) = (&mut files.inspection.conditions, &drawn.conditions);
    let mut changed = Vec::new();
    for (flank, of) in job.flanks.iter() {
        let open = &mut own.flanks[flank];
        // Zones of reliefs end the file's range; the target has its own.
        (open.tip_relief_mm, open.root_relief_mm) = (None, None);
        for (name, own, job) in [
            ("w_1", &mut open.w_1_mm, of.w_1_mm),
            ("w_2", &mut open.w_2_mm, of.w_2_mm),
            ("z_1", &mut open.z_1_mm, of.z_1_mm),
            ("z_2", &mut open.z_2_mm, of.z_2_mm),
        ] {
            if let (Some(stated), Some(wanted)) = (*own, job)
                && (stated - wanted).abs() > SAME_RANGE
            {
                changed.push(format!("{name} of the {flank} flank {wanted:.3} instead of {stated:.3} mm"));
            }
            *own = job.or(*own);
        }
    }
    if !changed.is_empty() {
        files.remarks.push(Remark {
            code: "range-of-the-job",
            text: format!("evaluated in the range of the job: {}", changed.join(", ")),
            way_out: "set `gear.evaluation` of the job to what is to be judged".into(),
        });
    }
    own.helix_slope_reference = own.helix_slope_reference.or(job.helix_slope_reference);
    own.profile_slope_reference = own.profile_slope_reference.or(job.profile_slope_reference);
}

/// Measures and corrects a simulated machine until nothing is worth a correction, or its rounds are over. The last round only measures.
///
/// # Errors
/// [`RunFailure`]: a job without `[inspection.simulated]`, and those of planning, referee and evaluation.
pub(super) fn simulated(
    loaded: &LoadedJob,
    asked: &Asked,
    progress: &dyn Progress,
) -> Result<Vec<Round>, RunFailure> {
    let Some(of) = &asked.table.simulated else {
        let finding = Diagnostic::new(
            Problem::MissingKey,
            "there is no measurement: neither a file nor a simulated one",
        )
        .field("inspection.simulated")
        .way_out("name a file (`flankwright inspect FILE --job JOB`), or give the table");
        return Err(RunFailure::bad_input(finding));
    };
    let mut made = ground(loaded.clone(), progress)?;
    let mut rounds = Vec::new();
    for number in 1..=of.rounds + 1 {
        let drawn = DrawnGear::of_setup(&made.prepared.setup)?;
        let real = made.with_deviations(of, progress)?;
        let mut found = probe::measured(&drawn, &made.prepared.setup.pair.work, &real, of, number);
        found.name = Some(format!("{}, simulated, round {number}", asked.info.name));
        let mut round = judge(&made, asked, found, number, progress)?;
        let next = round.next.take();
        rounds.push(round);
        let Some(next) = next else { break };
        made = next;
    }
    Ok(rounds)
}
