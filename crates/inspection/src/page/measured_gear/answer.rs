//! The answer of the page: one sentence and the figures beside it.

use crate::workflow::{GearInspectionResult, RoundResult, class_in_words};
use report::charts::format_fixed;
use run::sentence;

pub(super) fn headline(result: &GearInspectionResult) -> String {
    if let Some(reason) = result.verdict.reason() {
        return sentence(reason);
    }
    match (result.tolerance_um, result.tolerance_class) {
        (None, None) => format!(
            "{} traces were evaluated. Nothing is judged: neither a job nor a class of ISO 1328-1 was given.",
            result.traces.len()
        ),
        (None, Some(class)) => {
            format!("The gear reaches class {class} of ISO 1328-1:2013, which was asked for.")
        }
        (Some(tolerance), None) => format!("The measured flanks are within {tolerance} µm of the target."),
        (Some(tolerance), Some(class)) => format!(
            "The measured flanks are within {tolerance} µm of the target, and the gear reaches class {class} of ISO 1328-1:2013."
        ),
    }
}

pub(super) fn figures(result: &GearInspectionResult) -> Vec<(String, String)> {
    let um = |value: f64| format!("{} µm", format_fixed(value, 3));
    let mut figures = Vec::new();
    let worst = |round: &RoundResult| round.flanks.values().map(|f| f.measured.rms_um).reduce(f64::max);
    if let [first, .., last] = &result.rounds[..]
        && let (Some(before), Some(after)) = (worst(first), worst(last))
    {
        let text = format!("{} → {}", format_fixed(before, 3), um(after));
        figures.push(("deviation rms, first and last round".into(), text));
    } else if let Some(rms) = result.rounds.last().and_then(worst) {
        figures.push(("deviation rms".into(), um(rms)));
    }
    let last = result.rounds.last().and_then(|round| round.correction.as_ref());
    if let Some(after) = last.and_then(|c| c.proof.values().map(|p| p.after.rms_um).reduce(f64::max)) {
        figures.push(("after the correction, by the referee".into(), um(after)));
    }
    if let Some(class) = result.tolerance_class {
        figures.push(("class asked for".into(), class.to_string()));
    }
    if !result.classes.is_empty() {
        let class = class_in_words(result.class);
        let part = if result.class_is_partial { ", of what could be evaluated" } else { "" };
        figures.push(("class of ISO 1328-1".into(), class + part));
    }
    if !result.printed.is_empty() {
        figures.push(("largest difference from printed values".into(), um(result.printed_difference_um)));
    }
    figures
}
