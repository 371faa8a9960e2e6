//! The banner: the answer in one sentence and its figures.

use crate::workflow::SkivingResult;
use report::FirstPage;
use report::charts::format_fixed;
use run::{Answer, sentence};

/// What a run came to.
pub(super) fn answer(result: &SkivingResult, first_page: FirstPage) -> Answer<'_> {
    Answer {
        process: "Measuring a skiving tool in the machine",
        status: result.verdict.status(),
        reason: result.verdict.reason(),
        warnings: &result.warnings,
        headline: headline(result),
        figures: figures(result),
        first_page,
    }
}

fn headline(result: &SkivingResult) -> String {
    if let Some(reason) = result.verdict.reason() {
        return sentence(reason);
    }
    let worst = result.flanks.values().map(|flank| flank.max_deviation_um).fold(0.0, f64::max);
    match &result.measurement {
        Some(_) => format!(
            "The tool is fit: the profile will deviate by {} µm, the tolerance is {} µm.",
            format_fixed(worst, 2),
            result.tolerance_um
        ),
        None => {
            let tracks: usize = result.tracks.values().map(Vec::len).sum();
            format!("{tracks} tracks and their poses are laid; nothing has been measured yet.")
        }
    }
}

fn figures(result: &SkivingResult) -> Vec<(String, String)> {
    let mut figures = Vec::new();
    if let Some(measured) = &result.measurement {
        figures.push((
            "total pitch deviation".into(),
            format!("{} µm", format_fixed(measured.pitch.total_um, 2)),
        ));
        let [x, y] = measured.mounting.eccentricity_um;
        figures.push(("eccentricity".into(), format!("{} µm", format_fixed(x.hypot(y), 2))));
        let deepest = measured.profile.track_mean_um.values().flatten().copied().fold(0.0, f64::min);
        figures.push(("deepest track mean".into(), format!("{} µm", format_fixed(deepest, 2))));
        let [before, after] = measured.correction.rms_um;
        let rms = format!("{} → {} µm", format_fixed(before, 2), format_fixed(after, 2));
        figures.push(("profile rms, after correction".into(), rms));
    }
    figures.push(("measuring time".into(), format!("{} s", format_fixed(result.measuring_time_s, 0))));
    figures
}
