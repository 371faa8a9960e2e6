//! Contradictions in `[grinding]`.

use crate::job::{DiagonalRatio, DiagonalRule, Grinding, Job, Method, ShiftCurve, ShiftLaw};
use job::{Diagnostic, Problem, shown_number};

const RATIO: &str = "grinding.diagonal_ratio";

pub(super) fn check(job: &Job, findings: &mut Vec<Diagnostic>) {
    let grinding = &job.grinding;
    shift_without_method(grinding, findings);
    if let Some(DiagonalRatio::Law(law)) = &grinding.diagonal_ratio {
        shift_law(law, findings);
    }
    if let Some(ratio) = grinding.free_ratio
        && grinding.diagonal_ratio != Some(DiagonalRatio::Rule(DiagonalRule::Areas))
    {
        findings.push(
            Diagnostic::new(
                Problem::InvalidJob,
                "only regions with ratios of their own have one between them",
            )
            .field("grinding.free_ratio")
            .value(shown_number(ratio))
            .allowed("no key, or diagonal_ratio = \"areas\"")
            .way_out("leave `free_ratio` out, or use diagonal_ratio = \"areas\""),
        );
    }
    if let Some(ratio) = grinding.roughing_ratio
        && grinding.roughing_areas == 0
    {
        findings.push(
            Diagnostic::new(Problem::InvalidJob, "a roughing ratio is given, but no area for roughing")
                .field("grinding.roughing_ratio")
                .value(shown_number(ratio))
                .allowed("no key, or roughing_areas >= 1")
                .way_out("give `roughing_areas`, or leave `roughing_ratio` out"),
        );
    }
    active_threads(job, findings);
}

fn shift_without_method(grinding: &Grinding, findings: &mut Vec<Diagnostic>) {
    if grinding.method != Method::Radial {
        return;
    }
    let (message, value) = match &grinding.diagonal_ratio {
        None => return,
        Some(DiagonalRatio::Number(ratio)) if *ratio == 0.0 => return,
        Some(DiagonalRatio::Number(ratio)) => {
            ("the method `radial` has no shift, yet a diagonal ratio is given", shown_number(*ratio))
        }
        Some(DiagonalRatio::Rule(rule)) => (
            "the method `radial` has no shift, yet a diagonal ratio is asked for",
            match rule {
                DiagonalRule::Auto => "\"auto\"".to_owned(),
                DiagonalRule::Areas => "\"areas\"".to_owned(),
                DiagonalRule::Variable => "\"variable\"".to_owned(),
            },
        ),
        Some(DiagonalRatio::Law(_)) => {
            ("the method `radial` has no shift, yet a law of the shift is given", "a table".to_owned())
        }
    };
    findings.push(
        Diagnostic::new(Problem::InvalidJob, message)
            .field(RATIO)
            .value(value)
            .allowed("0, or no key, with method = \"radial\"")
            .way_out("use method = \"diagonal\", or leave `diagonal_ratio` out"),
    );
}

fn shift_law(law: &ShiftLaw, findings: &mut Vec<Diagnostic>) {
    match (&law.curve, &law.table) {
        (None, None) => findings.push(
            Diagnostic::new(
                Problem::MissingKey,
                "`grinding.diagonal_ratio` does not say how the shift follows the feed",
            )
            .field("grinding.diagonal_ratio.curve")
            .allowed("exactly one of curve, table")
            .way_out("add `curve` or `table`, or use \"auto\""),
        ),
        (Some(_), Some(_)) => findings.push(
            Diagnostic::new(Problem::InvalidJob, "the shift is given twice")
                .field("grinding.diagonal_ratio.table")
                .value("a table beside `curve`")
                .allowed("exactly one of curve, table")
                .way_out("keep one of them"),
        ),
        (Some(ShiftCurve::Points(points)), None) => {
            pairs(["curve.w_mm", "curve.z_mm"], &points.w_mm, &points.z_mm, findings);
        }
        (None, Some(table)) => {
            pairs(["table.z_v2_mm", "table.z_v1_mm"], &table.z_v2_mm, &table.z_v1_mm, findings)
        }
        (Some(ShiftCurve::LineBlend(_) | ShiftCurve::LineSine(_)), None) => {}
    }
}

/// As many values as places, places ascending.
fn pairs(keys: [&str; 2], x: &[f64], y: &[f64], findings: &mut Vec<Diagnostic>) {
    let [key_x, key_y] = keys;
    if x.len() != y.len() {
        findings.push(
            Diagnostic::new(Problem::InvalidList, format!("{} values for {} places", y.len(), x.len()))
                .field(format!("{RATIO}.{key_y}"))
                .value(format!("{} entries", y.len()))
                .allowed(format!("{} entries, as many as `{key_x}`", x.len()))
                .way_out("give both lists the same length"),
        );
    }
    if let Some(i) = x.windows(2).position(|pair| pair[1] <= pair[0]) {
        findings.push(
            Diagnostic::new(Problem::InvalidList, format!("the list `{key_x}` does not ascend"))
                .field(format!("{RATIO}.{key_x}[{}]", i + 1))
                .value(shown_number(x[i + 1]))
                .allowed(format!("> {}", shown_number(x[i])))
                .way_out("sort the places, each once"),
        );
    }
}

fn active_threads(job: &Job, findings: &mut Vec<Diagnostic>) {
    let threads = job.worm.threads;
    let given = job.grinding.active_threads.as_deref().unwrap_or_default();
    for (i, thread) in given.iter().enumerate() {
        let (message, way_out) = if *thread >= threads {
            (
                format!("the worm has no thread {thread}: its {threads} threads are counted from 0"),
                "correct the number",
            )
        } else if given[..i].contains(thread) {
            (format!("thread {thread} stands twice in `active_threads`"), "delete one of the two")
        } else {
            continue;
        };
        findings.push(
            Diagnostic::new(Problem::InvalidList, message)
                .field(format!("grinding.active_threads[{i}]"))
                .value(thread)
                .allowed(format!("0 to {}, each once", threads - 1))
                .way_out(way_out),
        );
    }
}
