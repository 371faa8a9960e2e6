//! The banner: the answer in one sentence and its figures.

use crate::workflow::{FlankResult, MillingResult};
use report::FirstPage;
use report::charts::format_significant;
use run::Answer;

/// What a run came to.
pub(super) fn answer(result: &MillingResult, first_page: FirstPage) -> Answer<'_> {
    Answer {
        process: "Five-axis milling",
        status: result.verdict.status(),
        reason: result.verdict.reason(),
        warnings: &result.warnings,
        headline: headline(result),
        figures: figures(result),
        first_page,
    }
}

fn headline(result: &MillingResult) -> String {
    if let Some(reason) = result.verdict.reason() {
        return format!("{}.", reason.text);
    }
    let [spaces, milled] = result.spaces;
    let flanks: Vec<&str> = result.flanks.keys().copied().collect();
    let of = if milled == spaces {
        format!("all {spaces} tooth spaces")
    } else {
        format!("{milled} of {spaces} tooth spaces")
    };
    let left = largest(result, |flank| flank.out_of_reach.map_or(0.0, |left| left.length_mm));
    let left = if left > 0.0 {
        format!(" Up to {} mm in the middle of the gear stay unmilled.", format_significant(left, 4))
    } else {
        String::new()
    };
    format!(
        "Largest deviation {} µm (tolerance {} µm), {}, {of}.{left}",
        format_significant(largest(result, |flank| flank.max_deviation_um), 4),
        format_significant(result.tolerance_um, 4),
        match flanks[..] {
            [one] => format!("{one} flank"),
            [_, _] => "both flanks".to_owned(),
            _ => "all flanks".to_owned(),
        },
    )
}

/// Largest of a figure over the flanks.
fn largest(result: &MillingResult, value: impl Fn(&FlankResult) -> f64) -> f64 {
    result.flanks.values().map(value).fold(0.0, f64::max)
}

fn figures(result: &MillingResult) -> Vec<(String, String)> {
    let um = |x: f64| format!("{} µm", format_significant(x, 4));
    vec![
        ("largest deviation".into(), um(largest(result, |flank| flank.max_deviation_um))),
        ("tolerance".into(), um(result.tolerance_um)),
        ("rms".into(), um(largest(result, |flank| flank.rms_deviation_um))),
        (
            "flanks: prediction and rays differ by".into(),
            um(largest(result, |flank| flank.model_difference_um)),
        ),
        ("warnings".into(), result.warnings.len().to_string()),
    ]
}
