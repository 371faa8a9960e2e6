//! What is expected of single traces of a measured part, and what the machine printed of them.

use super::super::super::expected::Expected;
use super::super::super::given::{Checked, text};
use super::super::super::ledger::Ledger;
use super::super::evaluation_case::mm;
use super::super::traces::{compare_relief, compare_trace};
use super::Allowed;
use super::printed::{AS_PRINTED, compared};
use crate::exchange::inspection::{Characteristic, Inspection, Statistic, Trace, TraceKind};
use crate::geometry::Sides;
use crate::metrology::inspection::{
    EvaluationRange, Relief, Sign, SlopeReference, SlopeRule, SlopeSign, TraceEvaluation, TraceSamples,
    evaluate_trace,
};
use serde_json::Value;

/// A trace and what it comes to.
struct Evaluated<'a> {
    trace: &'a Trace,
    evaluation: TraceEvaluation,
    relief: Option<Relief>,
    /// f_H as the machine prints it, if the file says with which sign. mm
    printed_slope: Option<f64>,
}

/// Compares the trace that an item names.
pub(super) fn compare(
    inspection: &Inspection,
    allowed: &Allowed,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Checked {
    let trace = named(inspection, item, ledger)?;
    let found = evaluated(inspection, trace)?;
    if let Some(mut expected) = item.object("expected", ledger) {
        compare_trace(&found.evaluation, &mut expected, allowed.um, ledger);
        // u(f_H) of noise of 1 um.
        let factor = found.evaluation.slope_uncertainty_factor();
        expected.number("u_slope_factor", factor, allowed.um, ledger);
        let printed_slope = found.printed_slope.map_or(f64::NAN, |mm| mm * 1e3);
        expected.number("fH_printed_sign_um", printed_slope, allowed.um, ledger);
        if let Some(relief) = &found.relief {
            compare_relief(relief, &mut expected, [allowed.um, allowed.mm()], ledger);
        }
        expected.finish(ledger);
    }
    if let Some(mut printed) = item.object("printed_um", ledger) {
        compare_printed(inspection, &found, allowed, &mut printed, ledger);
        printed.finish(ledger);
    }
    Ok(())
}

fn named<'a>(inspection: &'a Inspection, item: &mut Expected<'_>, ledger: &mut Ledger) -> Checked<&'a Trace> {
    let kind = text(item, "kind", ledger)?;
    let tag = text(item, "tag", ledger)?;
    let flank = item.given_flank(ledger).ok_or("flank is missing")?;
    let tooth = item.take("tooth").and_then(Value::as_u64).ok_or("tooth is missing")?;
    let is_it =
        |t: &&Trace| t.kind.name() == kind && u64::from(t.tooth) == tooth && t.tag == tag && t.flank == flank;
    let trace = inspection.traces.iter().find(is_it);
    trace.ok_or_else(|| format!("the file has no {kind} of tooth {tooth}{tag}, {flank} flank").into())
}

/// Evaluates a trace in the range and with the reference length and the sign that its file states.
fn evaluated<'a>(inspection: &Inspection, trace: &'a Trace) -> Checked<Evaluated<'a>> {
    let (kind, flank, conditions) = (trace.kind, trace.flank, &inspection.conditions);
    let samples = TraceSamples::new(trace.abscissa_mm.clone(), mm(&trace.f_um))?;
    let [from, to] = conditions.range(kind, flank)?;
    let length = conditions.reference_length(kind, flank, inspection.gear.face_width_mm)?;
    let stated = &conditions.flanks[flank];
    let sigma = match kind {
        TraceKind::Profile => Some(SlopeSign::Material),
        TraceKind::Helix => stated
            .printed_sign
            .map(|sigma| SlopeSign::Custom(Sides::both(if sigma < 0.0 { Sign::Minus } else { Sign::Plus }))),
    };
    let sign = sigma.unwrap_or(SlopeSign::Material);
    let rule = SlopeRule { flank, sign, reference: SlopeReference::Given(length) };
    let evaluation = evaluate_trace(&samples, EvaluationRange::new(from, to)?, rule)?;
    let zone = stated.tip_relief_mm.filter(|_| kind == TraceKind::Profile);
    let relief = zone.map(|zone| evaluation.relief(&samples, zone)).transpose()?;
    let printed_slope = sigma.map(|_| evaluation.slope.printed());
    Ok(Evaluated { trace, evaluation, relief, printed_slope })
}

/// Printed values of a trace must stand in the file of values, and its evaluation must agree with them.
fn compare_printed(
    inspection: &Inspection,
    found: &Evaluated<'_>,
    allowed: &Allowed,
    printed: &mut Expected<'_>,
    ledger: &mut Ledger,
) {
    let [slope, total, form] = match found.trace.kind {
        TraceKind::Helix => {
            [Characteristic::HelixSlope, Characteristic::HelixTotal, Characteristic::HelixForm]
        }
        TraceKind::Profile => {
            [Characteristic::ProfileSlope, Characteristic::ProfileTotal, Characteristic::ProfileForm]
        }
    };
    for (key, characteristic, evaluated) in [
        ("fH", slope, found.printed_slope),
        ("F", total, Some(found.evaluation.total)),
        ("ff", form, Some(found.evaluation.form)),
        ("fKo", Characteristic::TipRelief, found.relief.map(|relief| relief.amount)),
    ] {
        let Some(wanted) = printed.peek(key).and_then(Value::as_f64) else { continue };
        // Codes count the measured teeth and do not name them: one of them must have the value.
        let values = inspection.results.iter().filter(|q| {
            q.meaning.characteristic == characteristic
                && q.meaning.flank == Some(found.trace.flank)
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
