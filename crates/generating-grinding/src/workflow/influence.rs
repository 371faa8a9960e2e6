//! First-order effects of the settings of a planned job, where they are known.

use super::execution::Execution;
use super::prepare::Prepared;
use foundation::kinematics::MotionLaw;
use generating::correction::SettingInfluence;
use job::{Diagnostic, Problem};
use run::RunFailure;

/// Whether the worm shifts at a constant ratio, for which the effects of settings are known.
pub fn shifts_at_constant_ratio(execution: &Execution) -> bool {
    matches!(execution.motion.shift, MotionLaw::Polynomial { .. })
}

/// First-order effects of the settings of a planned job.
///
/// # Errors
/// [`RunFailure::BadInput`] for a job on which they are not known: the ratio follows a law of the feed.
pub fn influence<'a>(
    prepared: &'a Prepared,
    execution: &Execution,
) -> Result<SettingInfluence<'a>, RunFailure> {
    let setup = &prepared.setup;
    if !shifts_at_constant_ratio(execution) {
        let message = "what settings do to the flank is known for a constant diagonal ratio";
        let finding = Diagnostic::new(Problem::InvalidJob, message)
            .field("grinding.diagonal_ratio")
            .value("a law of the feed")
            .allowed("a constant ratio")
            .way_out("give a constant ratio");
        return Err(RunFailure::bad_input(finding));
    }
    SettingInfluence::new(&setup.lines, execution.ratio, setup.input.blank.face_width)
        .map_err(|e| RunFailure::bad_input(Diagnostic::of(&e).field("grinding.diagonal_ratio")))
}
