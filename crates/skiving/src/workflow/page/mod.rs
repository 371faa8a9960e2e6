//! Fills the page of a skiving tool's measurement. Timing stays out of it, so that the same job gives the same bytes.

mod angles;
mod comparison;
mod measured;
mod sheets;
mod strip;
mod tooth;

use super::result::SkivingResult;
use super::run::SkivingOutcome;
use crate::job::SkivingJob;
use crate::page::SkivingReport;
use report::charts::{ChartError, format_fixed};
use report::html;
use run::{Answer, report_head, sentence};

/// The report of a run as a self-contained HTML page.
///
/// # Errors
/// A number that is not finite.
pub fn html_page(
    job: &SkivingJob,
    outcome: &SkivingOutcome,
    files: &[(String, &'static str)],
) -> Result<String, ChartError> {
    let result = &outcome.result;
    let answer = Answer {
        process: "Measuring a skiving tool in the machine",
        status: result.verdict.status(),
        reason: result.verdict.reason(),
        warnings: &result.warnings,
        headline: headline(result),
        figures: figures(result),
    };
    let report = SkivingReport {
        head: report_head(&job.job, answer, files),
        verdict: result.verdict.clone(),
        measured: outcome.measurement.as_ref().map(|m| measured::deviations(&outcome.bodies, m, result)),
        angles: angles::angles(outcome),
        strip: strip::strip(outcome),
        pitch: measured::pitch(outcome),
        tooth: Some(tooth::tooth(&outcome.bodies)),
        edge_sections: tooth::sections(&outcome.bodies),
        poses: tooth::poses(result),
        profile: Some(comparison::profile(result)),
        corrections: comparison::corrections(job, outcome),
        conventional: comparison::conventional(&outcome.bodies, result),
        history: comparison::history(outcome),
        monte_carlo: comparison::monte_carlo(result),
        sheets: sheets::sheets(job, result),
        programs: comparison::programs(outcome),
    };
    Ok(html::render(&report.to_page()?))
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
