//! What is expected of single traces of a measured part, and what the machine printed of them.

use super::super::super::expected::Expected;
use super::super::super::given::{Checked, text};
use super::super::super::ledger::Ledger;
use super::super::traces::{compare_relief, compare_trace};
use super::Allowed;
use super::printed::{AS_PRINTED, compared};
use flankwright::workflow::inspection::{EvaluatedGear, EvaluatedTrace};
use measured_files::inspection::{Characteristic, Inspection, Statistic, TraceKind};
use serde_json::Value;

/// Compares the trace that an item names.
pub(super) fn compare(
    inspection: &Inspection,
    gear: &EvaluatedGear,
    allowed: &Allowed,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Checked {
    let found = named(inspection, gear, item, ledger)?;
    if let Some(mut expected) = item.object("expected", ledger) {
        compare_trace(&found.evaluation, &mut expected, allowed.um, ledger);
        // u(f_H) of noise of 1 um.
        let factor = found.evaluation.slope_uncertainty_factor();
        expected.number("u_slope_factor", factor, allowed.um, ledger);
        let printed_slope = printed_slope(found).map_or(f64::NAN, |mm| mm * 1e3);
        expected.number("fH_printed_sign_um", printed_slope, allowed.um, ledger);
        if let Some(relief) = &found.tip_relief {
            compare_relief(relief, &mut expected, [allowed.um, allowed.mm()], ledger);
        }
        expected.finish(ledger);
    }
    if let Some(mut printed) = item.object("printed_um", ledger) {
        compare_printed(inspection, found, allowed, &mut printed, ledger);
        printed.finish(ledger);
    }
    Ok(())
}

/// f_H as the machine prints it, if the file says with which sign. mm
fn printed_slope(found: &EvaluatedTrace) -> Option<f64> {
    found.sign_stated.then(|| found.evaluation.slope.printed())
}

fn named<'a>(
    inspection: &Inspection,
    gear: &'a EvaluatedGear,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Checked<&'a EvaluatedTrace> {
    let kind = text(item, "kind", ledger)?;
    let tag = text(item, "tag", ledger)?;
    let flank = item.given_flank(ledger).ok_or("flank is missing")?;
    let tooth = item.take("tooth").and_then(Value::as_u64).ok_or("tooth is missing")?;
    let is_it = |one: &&EvaluatedTrace| {
        let t = &inspection.traces[one.trace];
        t.kind.name() == kind && u64::from(t.tooth) == tooth && t.tag == tag && t.flank == flank
    };
    let trace = gear.traces.iter().find(is_it);
    trace.ok_or_else(|| format!("the file has no {kind} of tooth {tooth}{tag}, {flank} flank").into())
}

/// Printed values of a trace must stand in the file of values, and its evaluation must agree with them.
fn compare_printed(
    inspection: &Inspection,
    found: &EvaluatedTrace,
    allowed: &Allowed,
    printed: &mut Expected<'_>,
    ledger: &mut Ledger,
) {
    let trace = &inspection.traces[found.trace];
    let [slope, total, form] = match trace.kind {
        TraceKind::Helix => {
            [Characteristic::HelixSlope, Characteristic::HelixTotal, Characteristic::HelixForm]
        }
        TraceKind::Profile => {
            [Characteristic::ProfileSlope, Characteristic::ProfileTotal, Characteristic::ProfileForm]
        }
    };
    for (key, characteristic, evaluated) in [
        ("fH", slope, printed_slope(found)),
        ("F", total, Some(found.evaluation.total)),
        ("ff", form, Some(found.evaluation.form)),
        ("fKo", Characteristic::TipRelief, found.tip_relief.map(|relief| relief.amount)),
    ] {
        let Some(wanted) = printed.peek(key).and_then(Value::as_f64) else { continue };
        // Codes count the measured teeth and do not name them: one of them must have the value.
        let values = inspection.results.iter().filter(|q| {
            q.meaning.characteristic == characteristic
                && q.meaning.flank == Some(trace.flank)
                && matches!(q.meaning.statistic, Statistic::Tooth(_))
        });
        let nearest = values
            .filter_map(|q| q.value)
            .min_by(|a, b| (a - wanted).abs().total_cmp(&(b - wanted).abs()))
            .unwrap_or(f64::NAN);
        printed.number(key, nearest, AS_PRINTED, ledger);
        let evaluated = evaluated.map_or(f64::NAN, |mm| mm * 1e3);
        let quantity = compared(&printed.name(key));
        ledger.number(printed.case(), &quantity, nearest, evaluated, allowed.printed_um);
    }
}
