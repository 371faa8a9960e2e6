//! One measured gear evaluated: every trace, the pitches of both flanks, run-out, thickness, eccentricity, classes. What cannot be evaluated
//! says why and does not keep the rest from being so. mm, rad.

mod classes;
mod teeth;
mod trace;

pub use classes::JudgedValue;
pub use trace::{trace_name, transverse_samples, without_design};

use foundation::geometry::{Flank, Gear, Sides};
use measured_files::inspection as file;
use measured_files::inspection::Inspection;
use metrology::inspection::{
    Eccentricity, InspectionError, MeasuredThickness, PitchDeviations, PitchEvaluation, ReachedClasses,
    Relief, RunOut, Tolerances, TraceEvaluation, reached_classes,
};

/// The wanted deviation at (flank, w, z), transverse, > 0 material left, mm.
pub type Design<'a> = &'a (dyn Fn(Flank, f64, f64) -> f64 + Sync);

/// What could not be evaluated, and why.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LeftOut(pub Vec<(String, InspectionError)>);

impl LeftOut {
    /// Notes an error of `what`.
    fn take<T>(&mut self, what: &str, found: Result<T, InspectionError>) -> Option<T> {
        found.map_err(|error| self.0.push((what.into(), error))).ok()
    }
}

/// A trace with its evaluation.
#[derive(Clone, Debug, PartialEq)]
pub struct EvaluatedTrace {
    /// Its place among the traces of the inspection.
    pub trace: usize,
    /// In the transverse section.
    pub evaluation: TraceEvaluation,
    /// Relief at the tip of a profile, where the file has a zone for it.
    pub tip_relief: Option<Relief>,
    /// Whether the file states the sign with which the slope is printed; otherwise it is that of DIN.
    pub sign_stated: bool,
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
    /// Eccentricity of the gear on its measuring axis, where the measured thickness is known.
    pub eccentricity: Option<Eccentricity>,
    /// Pitches from the positions of the probe, where the file has them.
    pub from_positions: Option<Sides<PitchDeviations>>,
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
    /// Measure over balls of the gear that the span means, mm.
    pub over_balls_by_span: Option<f64>,
    /// Tolerances of the standard.
    pub tolerances: Option<Tolerances>,
    /// Values that are judged, mm: mean slopes with their signs, everything else one by one.
    pub judged: Vec<JudgedValue>,
    /// Classes that they reach, in their order.
    pub classes: Option<ReachedClasses>,
    /// What could not be evaluated, and why.
    pub left_out: LeftOut,
}

impl EvaluatedGear {
    /// Whether everything that was measured could be read and evaluated.
    pub fn is_whole(&self, inspection: &Inspection) -> bool {
        self.left_out.0.is_empty() && !inspection.warnings.iter().any(|warning| warning.kind.loses_values())
    }
}

/// Evaluates an inspection: with a design every trace against it, as ISO 1328-1 wants it, without one against the involute.
///
/// # Errors
/// [`file::InspectionError::BadInput`] for a header that makes no gear.
pub fn evaluate_inspection(
    inspection: &Inspection,
    design: Option<Design<'_>>,
) -> Result<EvaluatedGear, file::InspectionError> {
    let nominal = inspection.gear.checked()?;
    let mut left_out = LeftOut::default();
    let thickness = teeth::thickness(inspection, &mut left_out);
    // The span sees the teeth that are measured; printed run-outs follow from it (`docs/mathematics/inspection.md#how-it-is-verified`).
    let sized = thickness.by_span.or(thickness.by_balls);
    let measured = sized
        .and_then(|x| left_out.take("thickness", inspection.gear.gear(x).map_err(InspectionError::from)));
    // A header's shift that makes no gear is no reason to refuse traces, which do not depend on it.
    let stated = inspection.gear.profile_shift.and_then(|x| inspection.gear.gear(x).ok());
    let gear = measured.or(stated).unwrap_or(nominal);
    let ball = inspection.thickness.ball_diameter_mm;
    let over_balls = measured.filter(|_| thickness.by_span.is_some()).zip(ball).and_then(|(gear, ball)| {
        let found = gear.over_balls(ball, 0.0).map_err(InspectionError::from);
        left_out.take("measure over balls", found)
    });
    let traces = (0..inspection.traces.len())
        .filter_map(|number| {
            let found = trace::of_trace(inspection, &gear, number, design);
            let name = trace_name(&inspection.traces[number]);
            let (evaluated, relief) = left_out.take(&name, found)?;
            if let Some(error) = relief {
                left_out.0.push((format!("tip relief, {name}"), error));
            }
            Some(evaluated)
        })
        .collect::<Vec<EvaluatedTrace>>();
    let pitch = teeth::pitch(inspection, &nominal, measured.as_ref(), &mut left_out);
    let tolerances = classes::tolerances(inspection, &gear, &mut left_out);
    let judged = classes::judged(inspection, &traces, pitch.as_ref());
    let reached = tolerances.as_ref().map(|tolerances| {
        let values: Vec<_> = judged.iter().map(|of| (of.quantity, of.value)).collect();
        reached_classes(tolerances, &values)
    });
    let classes = reached.and_then(|found| left_out.take("classes", found));
    Ok(EvaluatedGear {
        gear,
        traces,
        pitch,
        thickness,
        over_balls_by_span: over_balls.map(|found| found.size),
        tolerances,
        judged,
        classes,
        left_out,
    })
}
