//! Fills the page of five-axis milling. Timing stays out of it, so that the same job gives the same bytes.

mod flanks;
mod mate;
mod orientation;
mod outline;
mod programs;
mod root;
mod views;

use super::result::{CutterResult, MillingResult};
use super::run::MillingOutcome;
use crate::OperationKind;
use crate::job::MillingJob;
use crate::page::{MillingReport, OperationRow};
use report::charts::{ChartError, format_significant};
use report::{Quantity, html};
use run::{Answer, report_head};

/// The report of a run as a self-contained HTML page.
///
/// # Errors
/// A number that is not finite.
pub fn html_page(
    job: &MillingJob,
    outcome: &MillingOutcome,
    files: &[(String, &'static str)],
) -> Result<String, ChartError> {
    let result = &outcome.result;
    let answer = Answer {
        process: "Five-axis milling",
        status: result.verdict.status(),
        reason: result.verdict.reason(),
        warnings: &result.warnings,
        headline: headline(result),
        figures: figures(result),
    };
    let report = MillingReport {
        head: report_head(&job.job, answer, files),
        verdict: result.verdict.clone(),
        tolerance_um: result.tolerance_um,
        bodies: bodies(result),
        views: views::views(&outcome.bodies, &outcome.plan),
        flanks: flanks::flanks(outcome),
        root: root::root(outcome),
        mate: outcome.mate.as_ref().map(mate::mate),
        operations: operations(outcome),
        orientations: orientation::views(outcome),
        programs: programs::view(outcome),
    };
    Ok(html::render(&report.to_page()?))
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
    let out_of_reach =
        |flank: &super::result::FlankResult| flank.out_of_reach.map_or(0.0, |left| left.length_mm);
    let left = largest(result, out_of_reach);
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

fn largest(result: &MillingResult, value: impl Fn(&super::result::FlankResult) -> f64) -> f64 {
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

fn cutter_words(cutter: &CutterResult) -> String {
    let mm = |x: f64| format_significant(x, 4);
    let diameter = mm(cutter.diameter);
    match cutter.profile {
        "barrel" => format!("barrel {diameter} mm, profile radius {} mm", mm(cutter.profile_radius)),
        _ if cutter.half_angle_deg > 0.0 => format!(
            "cone {diameter} mm, {} deg, corner radius {} mm",
            mm(cutter.half_angle_deg),
            mm(cutter.profile_radius)
        ),
        _ if 2.0 * cutter.profile_radius >= cutter.diameter => format!("ball {diameter} mm"),
        _ => format!("end mill {diameter} mm, corner radius {} mm", mm(cutter.profile_radius)),
    }
}

fn bodies(result: &MillingResult) -> Vec<Quantity> {
    let [spaces, milled] = result.spaces.map(|count| count as i64);
    let mut list = vec![
        Quantity::count("tooth spaces", "z", spaces),
        Quantity::count("tooth spaces milled", "", milled),
        Quantity::text("cutter of the flanks", cutter_words(&result.cutter)),
        Quantity::number("its cutting length", "l_c", result.cutter.cutting_length, "mm"),
    ];
    for (name, flank) in &result.flanks {
        list.push(Quantity::count(&format!("rows, {name} flank"), "", flank.rows.len() as i64));
    }
    list
}

fn operations(outcome: &MillingOutcome) -> Vec<OperationRow> {
    let options = &outcome.bodies.options;
    let row = |(operation, kind): (&super::result::OperationResult, OperationKind)| {
        let cutter = options.cutter_of(kind);
        OperationRow {
            name: operation.name.clone(),
            cutter: cutter_words(&CutterResult::new(cutter.shape(), cutter.cutting_length())),
            paths: operation.paths,
            places: operation.places,
            way_mm: operation.way_mm,
        }
    };
    let kinds = outcome.plan.operations.iter().map(|operation| operation.kind);
    outcome.result.operations.iter().zip(kinds).map(row).collect()
}
