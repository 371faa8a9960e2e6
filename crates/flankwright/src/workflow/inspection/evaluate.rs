//! One measured gear evaluated: every trace, the pitches of both flanks, run-out, thickness, eccentricity, classes. What cannot be evaluated
//! says why and does not keep the rest from being so. mm, rad.

use crate::exchange::inspection as file;
use crate::exchange::inspection::{Inspection, Trace, TraceKind};
use crate::geometry::{Flank, Gear, GearData, Sides};
use crate::metrology::inspection::{
    BallContact, Eccentricity, EvaluationRange, FlankAngles, InspectionError, MeasuredSection,
    MeasuredThickness, PitchDeviations, PitchEvaluation, ReachedClasses, Relief, RunOut, Sign,
    SlopeReference, SlopeRule, SlopeSign, ThicknessSizes, ToleranceGear, ToleranceQuantity, Tolerances,
    TraceEvaluation, TraceSamples, eccentricity, evaluate_trace, measured_thickness, reached_classes,
    run_out_from_pitch, thickness_variation,
};

/// What a measuring machine rounds values to, mm.
const PRINTED: f64 = 1e-4;

/// A trace with its evaluation.
#[derive(Clone, Debug, PartialEq)]
pub struct EvaluatedTrace {
    /// Its place among the traces of the inspection.
    pub trace: usize,
    /// In the transverse section.
    pub evaluation: TraceEvaluation,
    /// Relief at the tip of a profile, where the file has a zone for it.
    pub tip_relief: Option<Relief>,
}

/// Pitches of both flanks.
#[derive(Clone, Debug, PartialEq)]
pub struct EvaluatedPitch {
    /// By flank.
    pub flanks: Sides<Option<PitchEvaluation>>,
    /// R_p as a sheet prints it, of values rounded to 0.1 um.
    pub printed_range: Sides<Option<f64>>,
    /// R_s: range of the tooth thickness.
    pub thickness_variation: Option<f64>,
    /// Run-out from the pitches, where the measured thickness and a ball are known.
    pub run_out: Option<RunOut>,
    /// Eccentricity of the gear on its measuring axis.
    pub eccentricity: Option<Eccentricity>,
}

/// A measured gear.
#[derive(Clone, Debug, PartialEq)]
pub struct EvaluatedGear {
    /// The body with its measured profile shift, else that of the file, else none.
    pub gear: Gear,
    /// Traces in the order of the inspection, without those that cannot be evaluated.
    pub traces: Vec<EvaluatedTrace>,
    /// Pitches.
    pub pitch: Option<EvaluatedPitch>,
    /// Thickness.
    pub thickness: MeasuredThickness,
    /// Tolerances of the standard.
    pub tolerances: Option<Tolerances>,
    /// Values that are judged, mm: mean slopes with their signs, everything else one by one.
    pub judged: Vec<(ToleranceQuantity, f64)>,
    /// Classes that they reach, in their order.
    pub classes: Option<ReachedClasses>,
    /// What could not be evaluated, and why.
    pub left_out: Vec<(String, InspectionError)>,
}

/// Evaluates an inspection.
///
/// # Errors
/// [`file::InspectionError::BadInput`] for a header that makes no gear.
pub fn evaluate_inspection(inspection: &Inspection) -> Result<EvaluatedGear, file::InspectionError> {
    inspection.gear.checked()?;
    let mut left_out = Vec::new();
    let thickness = thickness(inspection, &mut left_out);
    // The span sees the teeth that are measured; printed run-outs follow from it (spec 85 section 13).
    let measured = thickness.by_span.or(thickness.by_balls);
    let shift = measured.or(inspection.gear.profile_shift).unwrap_or(0.0);
    let gear = match inspection.gear.gear(shift) {
        Ok(gear) => gear,
        // A shift that makes no gear is no reason to refuse the traces, which do not depend on it.
        Err(_) => inspection.gear.checked()?,
    };
    let traces: Vec<EvaluatedTrace> = inspection
        .traces
        .iter()
        .enumerate()
        .filter_map(|(number, trace)| match of_trace(inspection, &gear, trace) {
            Ok((evaluation, tip_relief)) => Some(EvaluatedTrace { trace: number, evaluation, tip_relief }),
            Err(error) => {
                left_out.push((trace_name(trace), error));
                None
            }
        })
        .collect();
    let pitch = pitch(inspection, &gear, &thickness, &mut left_out);
    let tolerances = tolerances(inspection, &gear, &mut left_out);
    let judged = judged(inspection, &traces, pitch.as_ref());
    let classes = tolerances.as_ref().and_then(|tolerances| {
        reached_classes(tolerances, &judged).map_err(|error| left_out.push(("classes".into(), error))).ok()
    });
    Ok(EvaluatedGear { gear, traces, pitch, thickness, tolerances, judged, classes, left_out })
}

/// A trace in words.
pub(super) fn trace_name(trace: &Trace) -> String {
    format!("{} of tooth {}{}, {} flank", trace.kind.name(), trace.tooth, trace.tag, trace.flank)
}

fn of_trace(
    inspection: &Inspection,
    gear: &Gear,
    trace: &Trace,
) -> Result<(TraceEvaluation, Option<Relief>), InspectionError> {
    let conditions = &inspection.conditions;
    let missing = |error: file::InspectionError| match error {
        file::InspectionError::MissingCode { meaning, .. } => {
            InspectionError::UnverifiedSetting { setting: meaning }
        }
        _ => InspectionError::UnverifiedSetting { setting: "range of the evaluation" },
    };
    let section = match conditions.section {
        file::Section::Transverse => MeasuredSection::Transverse,
        file::Section::Normal => MeasuredSection::Normal,
    };
    let to_transverse = section.to_transverse(gear.flank(trace.flank).base_helix_angle)?;
    let deviation = trace.f_um.iter().map(|um| 1e-3 * um * to_transverse).collect();
    let samples = TraceSamples::new(trace.abscissa_mm.clone(), deviation)?;
    let [lo, hi] = conditions.range(trace.kind, trace.flank).map_err(missing)?;
    let length = conditions
        .reference_length(trace.kind, trace.flank, inspection.gear.face_width_mm)
        .map_err(missing)?;
    let rule = match trace.kind {
        TraceKind::Profile => {
            SlopeRule { reference: SlopeReference::Given(length), ..SlopeRule::profile(trace.flank) }
        }
        TraceKind::Helix => SlopeRule {
            flank: trace.flank,
            sign: printed_sign(inspection),
            reference: SlopeReference::Given(length),
        },
    };
    let evaluation = evaluate_trace(&samples, EvaluationRange::new(lo, hi)?, rule)?;
    let zone = conditions.flanks[trace.flank].tip_relief_mm;
    let relief = zone
        .filter(|_| trace.kind == TraceKind::Profile)
        .map(|zone| evaluation.relief(&samples, zone))
        .transpose()?;
    Ok((evaluation, relief))
}

/// The sign of helix slopes that the file states, else that of the standard.
fn printed_sign(inspection: &Inspection) -> SlopeSign {
    let sign = |flank: Flank| {
        let stated = inspection.conditions.flanks[flank].printed_sign?;
        Some(if stated < 0.0 { Sign::Minus } else { Sign::Plus })
    };
    match (sign(Flank::Left), sign(Flank::Right)) {
        (Some(left), Some(right)) => SlopeSign::Custom(Sides { left, right }),
        _ => SlopeSign::Din,
    }
}

fn thickness(inspection: &Inspection, left_out: &mut Vec<(String, InspectionError)>) -> MeasuredThickness {
    let measured = &inspection.thickness;
    let sizes = ThicknessSizes {
        span: measured.span_teeth.zip(measured.span.and_then(|size| size.mean_mm)),
        balls: measured.ball_diameter_mm.zip(measured.over_balls.and_then(|size| size.mean_mm)),
    };
    let gear = &inspection.gear;
    let data = GearData {
        teeth: gear.teeth,
        normal_module: gear.normal_module_mm,
        pressure_angle: Sides::both(gear.normal_pressure_angle_deg.to_radians()),
        helix_angle: gear.helix_angle_deg.to_radians(),
        profile_shift: 0.0,
        cone_angle: 0.0,
    };
    measured_thickness(data, &sizes).unwrap_or_else(|error| {
        left_out.push(("thickness".into(), error));
        MeasuredThickness { by_span: None, by_balls: None, warning: None }
    })
}

fn pitch(
    inspection: &Inspection,
    gear: &Gear,
    thickness: &MeasuredThickness,
    left_out: &mut Vec<(String, InspectionError)>,
) -> Option<EvaluatedPitch> {
    let measured = inspection.pitch.as_ref()?;
    let teeth = inspection.gear.teeth.unsigned_abs() as usize;
    let mut of_flank = |flank: Flank| {
        let single = measured.flanks[flank].as_ref()?.fp_um.iter().map(|um| 1e-3 * um).collect();
        let found = PitchDeviations::new(single, teeth)
            .and_then(|pitch| Ok((pitch.evaluate(None)?, pitch.printed_single_range(PRINTED))));
        found.map_err(|error| left_out.push((format!("pitch, {flank} flank"), error))).ok()
    };
    let found = Sides { left: of_flank(Flank::Left), right: of_flank(Flank::Right) };
    let printed_range = found.map(|_, of| of.as_ref().map(|(_, range)| *range));
    let flanks = found.map(|_, of| of.as_ref().map(|(evaluation, _)| evaluation.clone()));
    let both = match (&flanks.left, &flanks.right) {
        (Some(left), Some(right)) => {
            Some(Sides { left: left.cumulative.clone(), right: right.cumulative.clone() })
        }
        _ => None,
    };
    let ball =
        inspection.thickness.ball_diameter_mm.filter(|_| thickness.by_span.or(thickness.by_balls).is_some());
    let run_out = both.as_ref().zip(ball).and_then(|(cumulative, ball)| {
        let found = BallContact::of(gear, ball).and_then(|contact| run_out_from_pitch(cumulative, &contact));
        found.map_err(|error| left_out.push(("run-out".into(), error))).ok()
    });
    let eccentric = both.as_ref().and_then(|cumulative| {
        let found = eccentricity(cumulative, &FlankAngles::of(gear));
        found.map_err(|error| left_out.push(("eccentricity".into(), error))).ok()
    });
    Some(EvaluatedPitch {
        thickness_variation: both.as_ref().map(thickness_variation),
        run_out,
        eccentricity: eccentric,
        printed_range,
        flanks,
    })
}

fn tolerances(
    inspection: &Inspection,
    gear: &Gear,
    left_out: &mut Vec<(String, InspectionError)>,
) -> Option<Tolerances> {
    let of = ToleranceGear {
        teeth: inspection.gear.teeth.unsigned_abs(),
        normal_module: inspection.gear.normal_module_mm,
        reference_diameter: 2.0 * gear.pitch_radius(),
        face_width: inspection.gear.face_width_mm?,
        helix_angle: inspection.gear.helix_angle_deg.to_radians(),
    };
    Tolerances::new(&of).map_err(|error| left_out.push(("tolerances".into(), error))).ok()
}

/// Values that are judged: mean slopes with their signs, single values of everything else.
fn judged(
    inspection: &Inspection,
    traces: &[EvaluatedTrace],
    pitch: Option<&EvaluatedPitch>,
) -> Vec<(ToleranceQuantity, f64)> {
    let mut values = Vec::new();
    for flank in Flank::BOTH {
        for kind in [TraceKind::Profile, TraceKind::Helix] {
            let of: Vec<&EvaluatedTrace> = traces
                .iter()
                .filter(|one| {
                    let trace = &inspection.traces[one.trace];
                    trace.kind == kind && trace.flank == flank && trace.tag.is_empty()
                })
                .collect();
            if of.is_empty() {
                continue;
            }
            let slope = of.iter().map(|one| one.evaluation.slope.printed()).sum::<f64>() / of.len() as f64;
            let [slope_of, form_of, total_of] = match kind {
                TraceKind::Profile => [
                    ToleranceQuantity::ProfileSlope,
                    ToleranceQuantity::ProfileForm,
                    ToleranceQuantity::ProfileTotal,
                ],
                TraceKind::Helix => [
                    ToleranceQuantity::HelixSlope,
                    ToleranceQuantity::HelixForm,
                    ToleranceQuantity::HelixTotal,
                ],
            };
            values.push((slope_of, slope));
            for one in of {
                values.push((form_of, one.evaluation.form));
                values.push((total_of, one.evaluation.total));
            }
        }
        if let Some(found) = pitch.and_then(|pitch| pitch.flanks[flank].as_ref()) {
            values.push((ToleranceQuantity::SinglePitch, found.single));
            values.push((ToleranceQuantity::TotalPitch, found.total));
        }
    }
    if let Some(run_out) = pitch.and_then(|pitch| pitch.run_out.as_ref()) {
        values.push((ToleranceQuantity::RunOut, run_out.total));
    }
    values
}
