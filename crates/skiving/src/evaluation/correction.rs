//! From what a measured tool will leave on the workpiece to the change of the machine's setting that makes it least
//! (`docs/mathematics/skiving.md#correction-of-the-setting`).

use super::Evaluation;
use crate::measuring::FlankTracks;
use crate::{Setting, SettingFit, SettingLimits, SkivingError, fit_setting, setting_sensitivity};
use foundation::geometry::Sides;

/// The correction of the setting that a measured tool asks for.
///
/// # Errors
/// Those of [`fit_setting`].
pub fn correction(
    flanks: &Sides<FlankTracks>,
    evaluation: &Evaluation,
    (free, limits): (&[Setting], &SettingLimits),
) -> Result<SettingFit, SkivingError> {
    let (mut rows, mut deviations) = (Vec::new(), Vec::new());
    for (flank, of) in flanks.iter() {
        let motion = of.edge.pair().motion();
        rows.extend(of.tracks.iter().map(|(track, _)| setting_sensitivity(motion, &track.contact)));
        deviations.extend(&evaluation.profile.workpiece[flank]);
    }
    fit_setting(&rows, &deviations, free, limits)
}
