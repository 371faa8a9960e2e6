//! The summary of a run for a terminal: its first lines and its last, whatever the process.

use super::finding::Remark;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::PathBuf;
use verdict::{Status, Verdict};

/// The beginning of a summary: whether the target is met, and why not.
pub fn opening(job: &str, verdict: &Verdict, worst_um: f64, tolerance_um: f64) -> String {
    let met = match verdict.status() {
        Status::Met => "target met".to_owned(),
        Status::NotJudged => "target NOT JUDGED".to_owned(),
        // Something else is missed: the reason says what.
        Status::Missed if worst_um <= tolerance_um => "target MISSED".to_owned(),
        Status::Missed => format!("target MISSED, largest deviation {worst_um:.3} um"),
    };
    let mut text = format!("{job}: {met} (tolerance {tolerance_um} um)\n");
    if let Some(reason) = verdict.reason() {
        give(&mut text, reason);
    }
    text
}

/// Why a target is missed or nothing was judged, and the way out.
pub fn give(text: &mut String, reason: &Remark) {
    // Writing to a text cannot fail.
    let _ = writeln!(text, "  {}: {}", reason.code, reason.text);
    let _ = writeln!(text, "  remedy: {}", reason.way_out);
}

/// The end of a summary: what the verdict covers, warnings, time, where the report is.
pub fn closing(
    text: &mut String,
    verdict: &Verdict,
    warnings: &[Remark],
    timing: &BTreeMap<&'static str, f64>,
    written: &[PathBuf],
) {
    let _ = writeln!(text, "  {}", verdict.scope_in_words());
    for warning in warnings {
        let _ = writeln!(text, "  warning: {} ({})", warning.text, warning.way_out);
    }
    let total: f64 = timing.values().sum();
    let stages: Vec<String> = timing.iter().map(|(stage, s)| format!("{stage} {s:.2} s")).collect();
    let _ = writeln!(text, "  time {total:.2} s ({})", stages.join(", "));
    if let Some(report) = written.last() {
        let _ = writeln!(text, "  report: {}", report.display());
    }
}

/// A number with fixed decimals; what rounds to zero has no sign.
pub fn fixed(x: f64, decimals: usize) -> String {
    let text = format!("{x:.decimals$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| c == '0' || c == '.') => rest.to_owned(),
        _ => text,
    }
}
