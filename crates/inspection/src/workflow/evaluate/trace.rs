//! One trace of an inspection in the range, with the sign and the reference length that its file states. mm

use super::{Design, EvaluatedTrace};
use foundation::geometry::{Flank, Gear, Sides};
use measured_files::inspection as file;
use measured_files::inspection::{Inspection, Trace, TraceKind};
use metrology::inspection::{
    EvaluationRange, InspectionError, MeasuredSection, Sign, SlopeReference, SlopeRule, SlopeSign,
    TraceSamples, evaluate_trace,
};

/// A trace in words.
pub fn trace_name(trace: &Trace) -> String {
    format!("{} of tooth {}{}, {} flank", trace.kind.name(), trace.tooth, trace.tag, trace.flank)
}

/// Samples of a trace in the transverse section, without the design.
///
/// # Errors
/// Those of [`TraceSamples::new`] and of the section.
pub fn transverse_samples(
    inspection: &Inspection,
    gear: &Gear,
    trace: &Trace,
    design: Option<Design<'_>>,
) -> Result<TraceSamples, InspectionError> {
    let section = match inspection.conditions.section {
        file::Section::Transverse => MeasuredSection::Transverse,
        file::Section::Normal => MeasuredSection::Normal,
    };
    let to_transverse = section.to_transverse(gear.flank(trace.flank).base_helix_angle)?;
    let deviation = trace.f_um.iter().map(|um| 1e-3 * um * to_transverse).collect();
    let samples = TraceSamples::new(trace.abscissa_mm.clone(), deviation)?;
    Ok(match (design, trace.kind) {
        (None, _) => samples,
        (Some(design), TraceKind::Profile) => samples.against(|w| design(trace.flank, w, trace.position_mm)),
        (Some(design), TraceKind::Helix) => samples.against(|z| design(trace.flank, trace.position_mm, z)),
    })
}

/// The inspection less a design: what evaluations against it see, as a measurement of its own.
pub fn without_design(inspection: &Inspection, gear: &Gear, design: Design<'_>) -> Inspection {
    let mut less = inspection.clone();
    let normal = inspection.conditions.section == file::Section::Normal;
    let um = |flank: Flank, w: f64, z: f64| {
        let to_section = if normal { gear.flank(flank).base_helix_angle.cos() } else { 1.0 };
        1e3 * design(flank, w, z) * to_section
    };
    for trace in &mut less.traces {
        for (a, f) in trace.abscissa_mm.iter().zip(&mut trace.f_um) {
            *f -= match trace.kind {
                TraceKind::Profile => um(trace.flank, *a, trace.position_mm),
                TraceKind::Helix => um(trace.flank, trace.position_mm, *a),
            };
        }
    }
    for field in &mut less.topographies {
        for ([w, z], f) in field.points_mm.iter().zip(&mut field.f_um) {
            *f -= um(field.flank, *w, *z);
        }
    }
    less
}

/// A trace, and why its tip relief could not be evaluated.
pub(super) fn of_trace(
    inspection: &Inspection,
    gear: &Gear,
    number: usize,
    design: Option<Design<'_>>,
) -> Result<(EvaluatedTrace, Option<InspectionError>), InspectionError> {
    let trace = &inspection.traces[number];
    let conditions = &inspection.conditions;
    let samples = transverse_samples(inspection, gear, trace, design)?;
    let [lo, hi] = conditions.range(trace.kind, trace.flank).map_err(missing)?;
    let length = conditions
        .reference_length(trace.kind, trace.flank, inspection.gear.face_width_mm)
        .map_err(missing)?;
    let (sign, sign_stated) = match trace.kind {
        TraceKind::Profile => (SlopeSign::Material, true),
        TraceKind::Helix => printed_sign(inspection),
    };
    let rule = SlopeRule { flank: trace.flank, sign, reference: SlopeReference::Given(length) };
    let evaluation = evaluate_trace(&samples, EvaluationRange::new(lo, hi)?, rule)?;
    let zone = conditions.flanks[trace.flank].tip_relief_mm;
    // Against a design that has the relief nothing is left to find in its zone.
    let zone = zone.filter(|_| trace.kind == TraceKind::Profile && design.is_none());
    // A zone beyond the trace keeps nothing else from being evaluated.
    let (tip_relief, relief_error) = match zone.map(|zone| evaluation.relief(&samples, zone)) {
        Some(Err(error)) => (None, Some(error)),
        found => (found.and_then(Result::ok), None),
    };
    Ok((EvaluatedTrace { trace: number, evaluation, tip_relief, sign_stated }, relief_error))
}

/// What the file would have to state.
fn missing(error: file::InspectionError) -> InspectionError {
    let setting = match error {
        file::InspectionError::MissingCode { meaning, .. } => meaning,
        _ => "range of the evaluation",
    };
    InspectionError::NotStated { setting }
}

/// The sign of helix slopes that the file states, else that of the standard; and whether it is stated.
fn printed_sign(inspection: &Inspection) -> (SlopeSign, bool) {
    let sign = |flank: Flank| {
        let stated = inspection.conditions.flanks[flank].printed_sign?;
        Some(if stated < 0.0 { Sign::Minus } else { Sign::Plus })
    };
    match (sign(Flank::Left), sign(Flank::Right)) {
        (Some(left), Some(right)) => (SlopeSign::Custom(Sides { left, right }), true),
        _ => (SlopeSign::Din, false),
    }
}
