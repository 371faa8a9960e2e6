//! The document of a measured gear from its evaluation.

use super::closed_loop::RoundResult;
use super::evaluate::{EvaluatedGear, EvaluatedTrace};
use super::printed::printed;
use super::readings::means_of_teeth;
use super::result::{
    ArealResult, BandResult, ClassResult, GearInspectionResult, LinesResult, PitchInspectionResult,
    SummaryResult, ThicknessResult, TraceInspectionResult,
};
use super::twist::twists;
use foundation::geometry::Flank;
use measured_files::inspection::{Inspection, Section};
use metrology::inspection::{SlopeSign, TeethSummary};
use std::collections::BTreeMap;
use verdict::{Remark, Verdict};

/// What the document holds beside the evaluation.
pub(super) struct InspectionContext {
    /// Name of part or job.
    pub name: String,
    /// Lines that were not understood.
    pub not_understood: Vec<LinesResult>,
    /// Remarks of reading and judging.
    pub remarks: Vec<Remark>,
    /// What the user stated about the measurement.
    pub stated: Vec<String>,
    /// Rounds against a job.
    pub rounds: Vec<RoundResult>,
    /// What bands say of traces, by their number.
    pub bands: BTreeMap<usize, BandResult>,
    /// Tolerance of the job.
    pub tolerance_um: Option<f64>,
    /// Features of the flanks as surfaces.
    pub areal: BTreeMap<&'static str, ArealResult>,
    /// What was judged.
    pub verdict: Verdict,
    /// Class that was asked for.
    pub tolerance_class: Option<i32>,
    /// Seconds per stage.
    pub timing: BTreeMap<&'static str, f64>,
}

/// The document of a measured gear.
pub(super) fn gear_result(
    inspection: &Inspection,
    gear: &EvaluatedGear,
    context: InspectionContext,
) -> GearInspectionResult {
    let head = [
        ("part", &inspection.part),
        ("name", &inspection.name),
        ("drawing", &inspection.drawing),
        ("date", &inspection.date),
        ("time", &inspection.time),
        ("machine", &inspection.machine),
    ];
    // A job's design stands in none of the printed values.
    let printed = if context.rounds.is_empty() { printed(inspection, gear) } else { Vec::new() };
    let difference = printed.iter().map(|p| (p.printed_um - p.evaluated_um).abs()).fold(0.0, f64::max);
    let pitch = gear.pitch.as_ref();
    let eccentric = pitch.and_then(|p| p.eccentricity.as_ref());
    GearInspectionResult {
        job: context.name,
        process: "inspection",
        version: env!("CARGO_PKG_VERSION"),
        verdict: context.verdict,
        tolerance_class: context.tolerance_class,
        tolerance_um: context.tolerance_um,
        files: inspection.sources.clone(),
        head: head.into_iter().filter_map(|(key, text)| Some((key, text.clone()?))).collect(),
        warnings: context.remarks.into_iter().chain(warnings(inspection, gear)).collect(),
        stated: context.stated,
        not_understood: context.not_understood,
        section: match inspection.conditions.section {
            Section::Transverse => "transverse",
            Section::Normal => "normal",
        },
        traces: gear
            .traces
            .iter()
            .map(|one| TraceInspectionResult {
                band: context.bands.get(&one.trace).copied(),
                ..trace(inspection, one)
            })
            .collect(),
        summary: summary(inspection, gear),
        twist: twists(inspection, gear),
        areal: context.areal,
        pitch: Flank::BOTH
            .into_iter()
            .filter_map(|flank| Some((flank.name(), of_pitch(gear, flank)?)))
            .collect(),
        thickness_variation_um: pitch.and_then(|p| p.thickness_variation).map(|mm| 1e3 * mm),
        run_out_um: pitch.and_then(|p| p.run_out.as_ref()).map(|r| 1e3 * r.total),
        eccentricity: eccentric.map(|e| [1e3 * e.amount(), e.direction().to_degrees()]),
        pitch_without_eccentricity_um: eccentric.map(|e| {
            let total = e.total_without();
            [1e3 * total.left, 1e3 * total.right]
        }),
        thickness: ThicknessResult {
            x_from_span: gear.thickness.by_span,
            x_from_balls: gear.thickness.by_balls,
        },
        classes: gear
            .classes
            .iter()
            .flat_map(|classes| &classes.each)
            .zip(&gear.judged)
            .map(|((quantity, class), of)| ClassResult {
                flank: of.flank.map(Flank::name),
                quantity: quantity.symbol(),
                value_um: 1e3 * of.value,
                class: *class,
            })
            .collect(),
        class_is_partial: !gear.is_whole(inspection),
        class: gear.classes.as_ref().and_then(|classes| classes.overall),
        printed_values: inspection.results.len(),
        printed,
        printed_difference_um: difference,
        rounds: context.rounds,
        timing_s: context.timing,
    }
}

fn warnings(inspection: &Inspection, gear: &EvaluatedGear) -> Vec<Remark> {
    let read = inspection.warnings.iter().map(|warning| Remark {
        code: warning.kind.code(),
        text: warning.line.map_or_else(String::new, |line| format!("line {line}: ")) + &warning.message,
        way_out: "look at the file, or measure again".into(),
    });
    let left_out = gear.left_out.0.iter().map(|(what, error)| Remark {
        code: error.code(),
        text: format!("{what}: not evaluated, {error}"),
        way_out: error.way_out().into(),
    });
    let doubts = [
        gear.thickness.warning.as_ref(),
        gear.pitch.as_ref().and_then(|pitch| pitch.run_out.as_ref()?.warning.as_ref()),
    ];
    let doubts = doubts.into_iter().flatten().map(|warning| Remark {
        code: warning.code(),
        text: warning.to_string(),
        way_out: "compare with the drawing and with another measurement".into(),
    });
    read.chain(left_out).chain(doubts).collect()
}

fn trace(inspection: &Inspection, one: &EvaluatedTrace) -> TraceInspectionResult {
    let (trace, e) = (&inspection.traces[one.trace], &one.evaluation);
    TraceInspectionResult {
        kind: trace.kind.name(),
        tooth: trace.tooth,
        flank: trace.flank.name(),
        tag: trace.tag.clone(),
        position_mm: trace.position_mm,
        range_mm: [e.range.from(), e.range.to()],
        samples: [e.samples, e.undefined],
        slope_um: 1e3 * e.slope.printed(),
        slope_material_um: 1e3 * e.slope.material(),
        slope_length_mm: e.slope.length,
        slope_sign: match e.slope.rule.sign {
            SlopeSign::Material => "material rises along the trace",
            SlopeSign::Din => "the flank turns right-handed",
            SlopeSign::Custom(_) => "as the file states",
        },
        total_um: 1e3 * e.total,
        form_um: 1e3 * e.form,
        crowning_um: 1e3 * e.crowning.height,
        tip_relief_um: one.tip_relief.as_ref().map(|relief| 1e3 * relief.amount),
        band: None,
    }
}

/// Mean and range over the teeth of every line that was measured on several.
fn summary(inspection: &Inspection, gear: &EvaluatedGear) -> Vec<SummaryResult> {
    let mut lines: BTreeMap<(&'static str, &'static str, String), Vec<TraceInspectionResult>> =
        BTreeMap::new();
    for one in &gear.traces {
        let of = trace(inspection, one);
        lines.entry((of.kind, of.flank, of.tag.clone())).or_default().push(of);
    }
    let mut rows = Vec::new();
    for ((kind, flank, tag), traces) in lines {
        let of = |value: fn(&TraceInspectionResult) -> Option<f64>| {
            means_of_teeth(traces.iter().filter_map(|trace| Some((trace.tooth, value(trace)?))))
        };
        for (characteristic, values) in [
            ("fH", of(|t| Some(t.slope_um))),
            ("F", of(|t| Some(t.total_um))),
            ("ff", of(|t| Some(t.form_um))),
            ("C", of(|t| Some(t.crowning_um))),
            ("fKo", of(|t| t.tip_relief_um)),
        ] {
            let Ok(found) = TeethSummary::of(&values) else { continue };
            rows.push(SummaryResult {
                kind,
                flank,
                tag: tag.clone(),
                characteristic,
                teeth: found.teeth,
                mean_um: found.mean,
                range_um: (found.teeth > 1).then(|| found.range()),
            });
        }
    }
    rows
}

fn of_pitch(gear: &EvaluatedGear, flank: Flank) -> Option<PitchInspectionResult> {
    let p = gear.pitch.as_ref()?.flanks[flank].as_ref()?;
    Some(PitchInspectionResult::of(p))
}
