//! What a terminal shows of a series: a few lines of plain text.

use super::InspectionSeries;
use super::result::{SeriesCharacteristic, SeriesGroupResult};
use std::fmt::Write;

/// Most characteristics of a group that are listed.
const MOST: usize = 12;

/// Groups with their parts, characteristics with the least capability or a drift, refused files. Ends with a line break.
pub fn series_summary(series: &InspectionSeries) -> String {
    let result = &series.result;
    let mut text = String::new();
    for group in &result.groups {
        let beyond = group.parts.iter().filter(|part| !part.exceeded.is_empty()).count();
        let _ = match group.parts.len() {
            1 => write!(text, "{}: 1 part", group.series),
            n => write!(text, "{}: {n} parts by {}", group.series, group.ordered_by),
        };
        match result.tolerance_class {
            Some(class) => {
                let _ = writeln!(text, ", {beyond} beyond class {class}");
            }
            None if beyond > 0 => {
                let _ = writeln!(text, ", {beyond} beyond the limits that they were imported with");
            }
            None => text.push('\n'),
        }
        characteristics(&mut text, group);
    }
    if let Some(reason) = result.verdict.reason() {
        let _ = writeln!(text, "{}: {}: {}", result.verdict.status().words(), reason.code, reason.text);
    } else {
        let _ = writeln!(text, "{}", result.verdict.status().words());
    }
    for file in &result.refused {
        let _ = writeln!(text, "refused: {}: {} [{}]", file.file, file.message, file.code);
    }
    for file in &result.left_out {
        let _ = writeln!(text, "left out: {}: {}", file.file, file.reason);
    }
    text
}

fn characteristics(text: &mut String, group: &SeriesGroupResult) {
    let capability = |of: &SeriesCharacteristic| {
        of.figures.as_ref().and_then(|figures| figures.capability.as_ref()).map(|capability| capability.cpk)
    };
    // The least capable first; what has no capability is not told here.
    let mut rows: Vec<(f64, &SeriesCharacteristic)> =
        group.characteristics.iter().filter_map(|of| Some((capability(of)?, of))).collect();
    rows.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (cpk, of) in rows.iter().take(MOST) {
        let Some(figures) = &of.figures else { continue };
        let _ = write!(
            text,
            "  {:<18} mean {:>8.2} {}, s {:>7.3}, Cpk {cpk:>6.2}",
            of.key, figures.mean, of.unit, figures.s
        );
        if let Some(trend) = figures.trend.filter(|trend| trend.p.is_some_and(|p| p < 0.01)) {
            let _ = write!(text, ", drifts {:+.3} a part", trend.per_part);
        }
        match figures.special_causes.len() {
            0 => {}
            1 => text.push_str(", 1 special cause"),
            n => {
                let _ = write!(text, ", {n} special causes");
            }
        }
        text.push('\n');
    }
    if rows.len() > MOST {
        let _ = writeln!(text, "  and {} more in series.json", rows.len() - MOST);
    }
}
