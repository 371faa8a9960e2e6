//! Tolerances of ISO 1328-1 for a measured gear, and the values that are judged by them. mm

use super::super::readings::means_of_teeth;
use super::{EvaluatedPitch, EvaluatedTrace, LeftOut};
use foundation::geometry::{Flank, Gear};
use measured_files::inspection::{Inspection, TraceKind};
use metrology::inspection::{ToleranceGear, ToleranceQuantity, Tolerances};

/// Tolerances of the gear; none without a face width.
pub(super) fn tolerances(inspection: &Inspection, gear: &Gear, left_out: &mut LeftOut) -> Option<Tolerances> {
    let of = ToleranceGear {
        teeth: inspection.gear.teeth.unsigned_abs(),
        normal_module: inspection.gear.normal_module_mm,
        reference_diameter: 2.0 * gear.pitch_radius(),
        face_width: inspection.gear.face_width_mm?,
        helix_angle: inspection.gear.helix_angle_deg.to_radians(),
    };
    left_out.take("tolerances", Tolerances::new(&of))
}

/// A value that is judged, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JudgedValue {
    /// Its flank; none for the run-out of the gear.
    pub flank: Option<Flank>,
    /// What it is.
    pub quantity: ToleranceQuantity,
    /// The value.
    pub value: f64,
}

/// Values that are judged: mean slopes with their signs, single values of everything else.
pub(super) fn judged(
    inspection: &Inspection,
    traces: &[EvaluatedTrace],
    pitch: Option<&EvaluatedPitch>,
) -> Vec<JudgedValue> {
    let mut values = Vec::new();
    let mut push = |flank, quantity, value| values.push(JudgedValue { flank, quantity, value });
    for flank in Flank::BOTH {
        for kind in [TraceKind::Profile, TraceKind::Helix] {
            let own = |one: &&EvaluatedTrace| {
                let trace = &inspection.traces[one.trace];
                trace.kind == kind && trace.flank == flank
            };
            let middle = |one: &&EvaluatedTrace| inspection.traces[one.trace].tag.is_empty();
            let mut of: Vec<&EvaluatedTrace> = traces.iter().filter(own).filter(middle).collect();
            if of.is_empty() {
                // Outer lines alone: both together stand for the middle.
                of = traces.iter().filter(own).collect();
            }
            if of.is_empty() {
                continue;
            }
            let slopes = means_of_teeth(
                of.iter().map(|one| (inspection.traces[one.trace].tooth, one.evaluation.slope.printed())),
            );
            let slope = slopes.iter().sum::<f64>() / slopes.len() as f64;
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
            push(Some(flank), slope_of, slope);
            for one in of {
                push(Some(flank), form_of, one.evaluation.form);
                push(Some(flank), total_of, one.evaluation.total);
            }
        }
        if let Some(found) = pitch.and_then(|pitch| pitch.flanks[flank].as_ref()) {
            push(Some(flank), ToleranceQuantity::SinglePitch, found.single);
            push(Some(flank), ToleranceQuantity::TotalPitch, found.total);
        }
    }
    if let Some(run_out) = pitch.and_then(|pitch| pitch.run_out.as_ref()) {
        push(None, ToleranceQuantity::RunOut, run_out.total);
    }
    values
}
