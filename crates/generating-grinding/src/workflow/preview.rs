//! The plan of a grinding job without its referee.

use super::execution::Execution;
use super::generating_finding;
use super::partition::Partition;
use super::prepare::prepare;
use super::run::settings_result;
use super::tables::ROWS;
use super::tip_land::TipLands;
use crate::job::Job;
use job::{Diagnostic, Loaded, Problem, ProcessJob};
use run::{GrindingMotion, Preview, PreviewFlank, RunFailure};

/// Plans a job as far as the planned flank.
///
/// # Errors
/// As for a plan; a job that takes its bodies from a catalogue.
pub fn preview_job(loaded: &Loaded<Job>) -> Result<Preview, RunFailure> {
    if loaded.job.catalogue.is_some() {
        let message = "a job that takes worm and dresser from a catalogue has no preview";
        let finding = Diagnostic::new(Problem::NotYetSupported, message)
            .field("catalogue")
            .way_out("plan it: the best pair is looked for");
        return Err(RunFailure::bad_input(finding));
    }
    let ready = prepare(loaded)?;
    let plan = ready.task().plan().map_err(|e| generating_finding::failure(&e))?;
    let execution = Execution::of_plan(&ready, &plan);
    let partition = Partition::of_cycle(&ready, execution.ratio, &execution.motion.shift)?;
    let tip_lands = TipLands::of_execution(&ready, &execution, true)?;
    let settings = settings_result(&ready, &execution, Some(&plan), partition, &tip_lands);
    let flanks = execution.flanks.iter().filter_map(|(flank, executed)| {
        let executed = executed.as_ref()?;
        let cos_b = ready.setup.lines[flank].cos_b2;
        Some((flank.name(), PreviewFlank::of(&executed.target, &executed.planned, cos_b)))
    });
    let mut warnings = ready.warnings.clone();
    warnings.extend(execution.warnings.iter().cloned());
    warnings.extend(tip_lands.warnings);
    Ok(Preview {
        process: Job::NAME,
        tolerance_um: ready.tolerance.tightest() * 1e3,
        settings: Preview::settings_of(&settings)?,
        warnings,
        flanks: flanks.collect(),
        motions: vec![GrindingMotion::over("both flanks", &execution.motion, execution.feed_range, ROWS)],
    })
}
