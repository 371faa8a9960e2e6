//! The verdict on a measured gear: against a class of ISO 1328-1 with every characteristic that the class has, against a job with its
//! surfaces, lines, bands and teeth. Without class and job nothing is asked for, and nothing is judged.

use super::closed_loop::Round;
use super::evaluate::{EvaluatedGear, EvaluatedTrace, trace_name};
use super::result::BandResult;
use foundation::geometry::Flank;
use job::Diagnostic;
use measured_files::inspection::{Inspection, Trace};
use metrology::inspection::{CLASSES, ToleranceQuantity as Q};
use run::RunFailure;
use std::collections::BTreeMap;
use verdict::{Remark, Verdict};

/// What a class of ISO 1328-1:2013 asks of a flank.
const OF_FLANK: [(&str, &[Q]); 3] = [
    ("profile", &[Q::ProfileSlope, Q::ProfileForm, Q::ProfileTotal]),
    ("helix", &[Q::HelixSlope, Q::HelixForm, Q::HelixTotal]),
    ("pitch", &[Q::SinglePitch, Q::TotalPitch]),
];

/// Refuses a class that the standard does not have.
///
/// # Errors
/// [`RunFailure::BadInput`] naming the classes.
pub(super) fn check_class(class: Option<i32>) -> Result<(), RunFailure> {
    let Some(class) = class.filter(|class| !CLASSES.contains(class)) else { return Ok(()) };
    let finding = Diagnostic::with_code("out-of-standard-range", "ISO 1328-1 has no such class")
        .field("class")
        .value(class)
        .allowed(format!("{} to {}", CLASSES.start(), CLASSES.end()))
        .way_out("choose a class of the standard");
    Err(RunFailure::bad_input(finding))
}

/// The verdict on a measurement by itself: against the class, if one is asked for.
pub(super) fn alone(inspection: &Inspection, gear: &EvaluatedGear, class: Option<i32>) -> Verdict {
    let mut verdict = Verdict::new();
    if !evaluated_at_all(gear) {
        let text = match inspection.results.len() {
            0 => "the file holds no trace, pitch or size that could be evaluated".to_owned(),
            printed => format!(
                "the file holds {printed} values that the measuring machine printed, but no trace, pitch or size that could be evaluated"
            ),
        };
        verdict.owe(
            "measurement",
            Remark::new(
                "nothing-evaluated",
                text,
                "look at the warnings; if the file is cut short or its other half (.mka, .mew) is missing, export it again",
            ),
        );
        return verdict;
    }
    match class {
        Some(class) => verdict.extend(of_class(inspection, gear, class)),
        None => verdict.leave("measured gear", "neither a job nor a class of ISO 1328-1 was given"),
    }
    verdict
}

/// Whether a trace, pitch or size was evaluated.
fn evaluated_at_all(gear: &EvaluatedGear) -> bool {
    let pitch = gear.pitch.as_ref().is_some_and(|pitch| pitch.flanks.iter().any(|(_, of)| of.is_some()));
    let thickness = gear.thickness.by_span.or(gear.thickness.by_balls).is_some();
    !gear.traces.is_empty() || pitch || thickness
}

/// The verdict by a class: every characteristic of both flanks, and what was lost in reading.
pub(super) fn of_class(inspection: &Inspection, gear: &EvaluatedGear, class: i32) -> Verdict {
    let mut verdict = Verdict::new();
    let name = format!("class {class} of ISO 1328-1:2013");
    let (Some(tolerances), Some(reached)) = (&gear.tolerances, &gear.classes) else {
        let why = gear.left_out.0.iter().find(|(what, _)| what == "tolerances" || what == "classes");
        let why =
            why.map_or_else(|| "the file states no face width".to_owned(), |(_, error)| error.to_string());
        let text = format!("{name} gives no tolerances for this gear: {why}");
        verdict.owe(
            name,
            Remark::new("no-tolerances", text, "complete the header of the file, or leave the class out"),
        );
        return verdict;
    };
    let values: Vec<(Option<Flank>, Q, f64, bool)> = gear
        .judged
        .iter()
        .zip(&reached.each)
        .map(|(of, (_, found))| (of.flank, of.quantity, of.value, found.is_some_and(|found| found <= class)))
        .collect();
    let mut judge = |item: String, flank: Option<Flank>, quantities: &[Q]| {
        let mut details = Vec::new();
        let mut beyond = None;
        for quantity in quantities {
            let own = values.iter().filter(|(of, q, ..)| *of == flank && q == quantity);
            let Some((_, _, value, kept)) = own.max_by(|a, b| a.2.abs().total_cmp(&b.2.abs())) else {
                continue;
            };
            let Ok(limit) = tolerances.rounded(*quantity, class) else { continue };
            let detail = format!("{} {:.1} of {:.1} um", quantity.symbol(), 1e3 * value, 1e3 * limit);
            if !kept && beyond.is_none() {
                beyond = Some(Remark::new(
                    "class-not-reached",
                    format!(
                        "{item}: {} is {:.1} um, {name} allows {:.1} um",
                        quantity.symbol(),
                        1e3 * value,
                        1e3 * limit
                    ),
                    "see the sheet for the traces; give the job by which the gear was ground to find which settings correct it",
                ));
            }
            details.push(detail);
        }
        if details.len() < quantities.len() {
            let text = format!("{item}: {name} needs it, and the file does not hold it");
            verdict
                .owe(item.clone(), Remark::new("not-measured", text, "measure it, or leave the class out"));
        }
        match beyond {
            Some(reason) => verdict.missed(item, details.join(", "), reason),
            None if details.is_empty() => {}
            None => verdict.met(item, details.join(", ")),
        }
    };
    for flank in Flank::BOTH {
        for (what, quantities) in OF_FLANK {
            judge(format!("{flank} flank, {what}"), Some(flank), quantities);
        }
    }
    if values.iter().any(|(_, quantity, ..)| *quantity == Q::RunOut) {
        judge("run-out".into(), None, &[Q::RunOut]);
    } else {
        verdict.leave("run-out", "its diameter over balls and thickness were not measured");
    }
    let lost = gear.left_out.0.iter().find(|(what, _)| is_of_class(inspection, what));
    let lines = inspection.warnings.iter().filter(|warning| warning.kind.loses_values()).count();
    if let Some((what, error)) = lost {
        let text = format!("{what} could not be evaluated: {error}");
        verdict.owe(what.clone(), Remark::new("not-evaluated", text, error.way_out()));
    } else if lines > 0 {
        let text = format!("{lines} warnings of reading say that values of the file were lost");
        verdict.owe(
            "lost values",
            Remark::new("values-lost", text, "look at the warnings; export the file again"),
        );
    }
    verdict
}

/// Whether something that was left out counts for a class: traces and pitches.
fn is_of_class(inspection: &Inspection, what: &str) -> bool {
    what.starts_with("pitch, ") || inspection.traces.iter().any(|trace| trace_name(trace) == what)
}

/// The verdict on a part by its job.
pub(super) fn of_job(
    last: &Round,
    (tolerance_um, asks_for): (f64, &dyn Fn(Flank) -> bool),
    bands: &BTreeMap<usize, BandResult>,
    unjudged: usize,
) -> Verdict {
    let way_out = match (&last.result.correction, &last.result.no_correction) {
        (Some(_), _) if last.corrected_milling.is_some() => "mill the next part by corrected-job.json".into(),
        (Some(_), _) => "grind the next part by corrected-job.json".into(),
        (None, Some(why)) => {
            format!("look at clamping, machine and measurement; no correction: {why}")
        }
        (None, None) => "look at clamping, machine and measurement".into(),
    };
    let remark = |code, text: String| Remark::new(code, text, way_out.clone());
    let mut verdict = Verdict::new();
    let flanks = &last.result.flanks;
    let mut far: Vec<_> = flanks.iter().collect();
    far.sort_by(|a, b| b.1.measured.largest_um.total_cmp(&a.1.measured.largest_um));
    for (flank, of) in far {
        let most = of.measured.largest_um;
        verdict.judge(
            format!("{flank} flank"),
            most <= tolerance_um,
            format!("{most:.3} of {tolerance_um} um"),
            || {
                let text = format!(
                    "the {flank} flank was measured {most:.3} um off its target (tolerance {tolerance_um} um)"
                );
                remark("tolerance-exceeded", text)
            },
        );
    }
    // Where no surface could be laid through the lines, each line is judged by itself.
    let lines = last.gear.traces.iter().map(|one| (&last.inspection.traces[one.trace], one));
    let alone = lines.filter(|(trace, _)| !flanks.contains_key(trace.flank.name()));
    let total = |(trace, one): &(&Trace, &EvaluatedTrace)| {
        1e3 * one.evaluation.total * last.gear.gear.flank(trace.flank).base_helix_angle.cos()
    };
    if let Some(found) = alone.max_by(|a, b| total(a).total_cmp(&total(b))) {
        let (name, most) = (trace_name(found.0), total(&found));
        let item = "lines of flanks that were not measured as surfaces";
        verdict.judge(item, most <= tolerance_um, format!("{most:.3} of {tolerance_um} um"), || {
            remark(
                "tolerance-exceeded",
                format!("{name}: total deviation {most:.3} um (tolerance {tolerance_um} um)"),
            )
        });
    }
    if !bands.is_empty() {
        let out = bands.values().filter(|band| !band.passed).count();
        let detail = format!("{} of {} traces lie in their band", bands.len() - out, bands.len());
        verdict.judge("bands", out == 0, detail, || {
            remark("outside-the-band", format!("{out} of {} traces lie outside their band", bands.len()))
        });
    }
    for (flank, of) in flanks {
        for (tooth, most) in &of.standing_out {
            let item = format!("tooth {tooth}, {flank} flank");
            let text = format!(
                "tooth {tooth} of the {flank} flank differs from what all teeth share by {most:.3} um (tolerance {tolerance_um} um)"
            );
            verdict.missed(item, format!("{most:.3} of {tolerance_um} um"), remark("tooth-stands-out", text));
        }
    }
    for flank in Flank::BOTH {
        if !asks_for(flank) {
            verdict.leave(format!("{flank} flank as a surface"), "the job does not ask for it");
            continue;
        }
        let whole = flanks.get(flank.name()).map(|of| of.measured_um.iter().flatten().all(Option::is_some));
        if whole != Some(true) {
            let how = if whole.is_some() { "only in part" } else { "not" };
            let text = format!("the {flank} flank was {how} measured as a surface");
            let way_out =
                "measure at least one profile and one helix trace of the same tooth on every ground flank";
            verdict.owe(format!("{flank} flank as a surface"), Remark::new("not-judged", text, way_out));
        }
    }
    if unjudged > 0 {
        let text = format!("{unjudged} traces could not be laid into their band");
        let way_out = "see the warnings; the band has to lie within the measured traces";
        verdict.owe("bands of these traces", Remark::new("not-judged", text, way_out));
    }
    verdict
}
