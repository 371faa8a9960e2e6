//! Blocks `traces` and `trace_errors`: one trace in its range.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::evaluation_case::{check_each, check_refusals, deviations_mm, flag};
use foundation::geometry::Flank;
use metrology::inspection::{
    EvaluationRange, InspectionError, Relief, SlopeReference, SlopeRule, TraceEvaluation, TraceSamples,
    evaluate_trace,
};
use serde::Deserialize;
use serde_json::Value;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Input {
    abscissa_first_mm: f64,
    abscissa_last_mm: f64,
    evaluation_start_mm: f64,
    evaluation_end_mm: f64,
    reference_length_mm: Option<f64>,
    f_um: Vec<Option<f64>>,
    relief_zone_mm: Option<[f64; 2]>,
    design_crowning_um: Option<f64>,
}

impl Input {
    fn evaluate(&self) -> Result<(TraceSamples, TraceEvaluation), InspectionError> {
        let range = EvaluationRange::new(self.evaluation_start_mm, self.evaluation_end_mm)?;
        let span = [self.abscissa_first_mm, self.abscissa_last_mm];
        let crowning = self.design_crowning_um.unwrap_or(0.0) * 1e-3;
        // A design crowning leaves the middle of the range where it is.
        let trace = TraceSamples::uniform(span, deviations_mm(&self.f_um))?
            .against(|a| -crowning * range.unit(a).powi(2));
        let reference = self.reference_length_mm.map_or(SlopeReference::Range, SlopeReference::Given);
        let rule = SlopeRule { reference, ..SlopeRule::profile(Flank::Left) };
        let evaluation = evaluate_trace(&trace, range, rule)?;
        Ok((trace, evaluation))
    }
}

/// Block `traces`: every quantity of every trace.
pub(crate) fn traces(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_each("traces", block, ledger, |input: &Input, tolerances, expected, ledger| {
        let (trace, found) = input.evaluate()?;
        let um = tolerances.get("um");
        compare_trace(&found, expected, um, ledger);
        let factor = found.slope_uncertainty_factor();
        expected.number("u_slope_factor", factor, tolerances.get("relative") * factor, ledger);
        flag(expected, "range_check_ff_above_F", found.form > found.total, ledger);
        if let Some(zone) = input.relief_zone_mm {
            let relief = found.relief(&trace, zone)?;
            compare_relief(&relief, expected, [um, tolerances.get("start_mm")], ledger);
        }
        Ok(())
    });
}

/// Numbers of samples and deviations of a trace; slopes are those of material.
pub(super) fn compare_trace(
    found: &TraceEvaluation,
    expected: &mut Expected<'_>,
    um: f64,
    ledger: &mut Ledger,
) {
    expected.whole("n", found.samples as i64, ledger);
    expected.whole("undefined", found.undefined as i64, ledger);
    for (key, actual) in [
        ("F_um", found.total),
        ("ff_um", found.form),
        ("fH_um", found.slope.material()),
        ("line_at_lo_um", found.line.at(found.range.from())),
        ("line_at_hi_um", found.line.at(found.range.to())),
        ("crowning_um", found.crowning.height),
        ("crowning_slope_um", found.crowning.slope.material()),
        ("form_parabola_um", found.crowning.form),
    ] {
        expected.number(key, actual * 1e3, um, ledger);
    }
}

/// A relief, to tolerances in um and for its start in mm.
pub(super) fn compare_relief(
    found: &Relief,
    expected: &mut Expected<'_>,
    [um, start_mm]: [f64; 2],
    ledger: &mut Ledger,
) {
    expected.number("relief_um", found.amount * 1e3, um, ledger);
    expected.optional("start_mm", found.start, start_mm, ledger);
    expected.number("zone_slope_um_per_mm", found.line.gradient * 1e3, um, ledger);
}

/// Block `trace_errors`.
pub(crate) fn trace_errors(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_refusals("trace_errors", block, ledger, |input: &Input| input.evaluate().map(|_| ()));
}
