//! One round: a measurement against a job, from the surfaces to the corrected job and its proof.

use super::super::asked::Asked;
use super::super::drawn::DrawnGear;
use super::super::evaluate::{EvaluatedGear, evaluate_inspection};
use super::super::standing_out::standing_out;
use super::super::surface::{MeasuredSurface, field_points, measured_surface};
use super::axes::axes;
use super::characteristics::{TestedCharacteristic, tested};
use super::correction::{FoundCorrection, compensation, correct, first_order, unit, worth_turning};
use super::ground::Ground;
use super::lines::mean_lines;
use super::result::{
    CharacteristicResult, CorrectedSettingResult, CorrectionResult, DifferenceResult, MachineChange,
    MeasuredFlankResult, ProofResult, RoundResult,
};
use foundation::geometry::{Flank, Sides};
use foundation::numerics::Progress;
use generating::correction::{ClosedLoop, CorrectionError, LoopEnd};
use generating_grinding::job::LoadedJob;
use generating_grinding::workflow::influence::{influence, shifts_at_constant_ratio};
use job::Diagnostic;
use measured_files::inspection::Inspection;
use metrology::Topography;
use metrology::areal::{ArealDegree, ArealError, ArealField, Comparison, Difference};
use metrology::inspection::InspectionError;
use milling::job::LoadedMillingJob;
use run::RunFailure;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// A measurement against a job.
pub struct Round {
    /// What it comes to.
    pub result: RoundResult,
    /// The evaluation of its traces against the target.
    pub gear: EvaluatedGear,
    /// The measurement.
    pub inspection: Inspection,
    /// The job with the compensation that answers it.
    pub corrected: Option<LoadedJob>,
    /// The job of five-axis milling with the compensation that answers it.
    pub corrected_milling: Option<LoadedMillingJob>,
    /// That job planned.
    pub(super) next: Option<Ground>,
}

/// A header that makes no gear.
pub(in super::super) fn of_header(error: &measured_files::inspection::InspectionError) -> RunFailure {
    RunFailure::bad_input(Diagnostic::of(error))
}

/// An error of the evaluation.
pub(super) fn of_inspection(error: &InspectionError) -> RunFailure {
    RunFailure::bad_input(Diagnostic::of(error).field("FILE"))
}

pub(super) fn of_areal(error: &ArealError) -> RunFailure {
    RunFailure::bad_input(Diagnostic::of(error).field("FILE"))
}

fn of_correction(error: &CorrectionError) -> RunFailure {
    RunFailure::bad_input(Diagnostic::of(error).field("inspection.settings"))
}

/// Judges a measurement against a job that was planned, and corrects the job.
pub(super) fn judge(
    made: &Ground,
    asked: &Asked,
    inspection: Inspection,
    number: usize,
    progress: &dyn Progress,
) -> Result<Round, RunFailure> {
    made.check_cylinders()?;
    let drawn = DrawnGear::of_setup(&made.prepared.setup)?;
    drawn.is_of(&inspection)?;
    let (table, tolerance) = (&asked.table, 1e-3 * asked.tolerance_um);
    let design = asked.design();
    let gear = evaluate_inspection(&inspection, Some(&design)).map_err(|error| of_header(&error))?;
    let setup = &made.prepared.setup;
    let fields = setup.fields.map(|_, field| [field.roll(), field.face()]);
    let pitch = TAU / f64::from(inspection.gear.teeth.unsigned_abs());
    let mut surfaces: Sides<Option<MeasuredSurface>> = Sides::default();
    let mut flanks = BTreeMap::new();
    for flank in Flank::BOTH {
        let (Some(simulated), Some(executed)) = (&made.simulated[flank], &made.execution.flanks[flank])
        else {
            continue;
        };
        let places = [&simulated.w[..], &simulated.z[..]];
        let surface = measured_surface(&inspection, &gear.gear, flank, places, &design);
        let Some(surface) = surface.map_err(|e| of_inspection(&e))? else { continue };
        let cos = setup.lines[flank].cos_b2;
        let target: Vec<f64> = places[0]
            .iter()
            .flat_map(|&w| places[1].iter().map(move |&z| (w, z)))
            .map(|(w, z)| cos * design(flank, w, z))
            .collect();
        let target = Topography { f: target, ..simulated.clone() };
        let measured = Topography {
            f: target.f.iter().zip(&surface.deviation.f).map(|(t, d)| t + d).collect(),
            ..simulated.clone()
        };
        let [roll, face] = fields[flank];
        let field = ArealField::new(roll, face).map_err(|e| of_areal(&e))?;
        let compared =
            Comparison::new([&target, simulated, &measured], &field, ArealDegree::Second, tolerance)
                .map_err(|e| of_areal(&e))?;
        let result = flank_result(
            [&target, &executed.planned, simulated, &measured],
            &surface,
            &compared,
            (pitch, tolerance),
        );
        flanks.insert(flank.name(), result);
        surfaces[flank] = Some(surface);
    }
    let points = |field: &measured_files::inspection::Topography| {
        field_points(&inspection, &gear.gear, field, &design).unwrap_or_default()
    };
    let tests = tested(&inspection, &gear, &fields, table, tolerance, points);
    let lines = mean_lines(&inspection, &gear.gear, &design).map_err(|e| of_inspection(&e))?;
    let mut round = Round {
        result: RoundResult {
            round: number,
            flanks,
            characteristics: tests.iter().map(characteristic).collect(),
            correction: None,
            no_correction: None,
            axes: Vec::new(),
            axes_together: None,
            axes_not_asked: BTreeMap::new(),
        },
        gear,
        inspection,
        corrected: None,
        corrected_milling: None,
        next: None,
    };
    if !shifts_at_constant_ratio(&made.execution) {
        let why = "what settings do to the flank is known for a constant diagonal ratio only; this job varies it over the feed";
        round.result.no_correction = Some(why.into());
        return Ok(round);
    }
    let influence = influence(&made.prepared, &made.execution)?;
    let asked = axes(made, &lines);
    (round.result.axes, round.result.axes_together) = (asked.alone, asked.together);
    round.result.axes_not_asked = asked.not_asked;
    let settings = worth_turning(table, &tests, &influence);
    if surfaces.iter().all(|(_, surface)| surface.is_none()) && !settings.is_empty() {
        let why = "without a measured surface nothing would be proven: measure a profile and a helix trace of the same tooth";
        round.result.no_correction = Some(why.into());
        return Ok(round);
    }
    if settings.is_empty() {
        round.result.no_correction = Some(reason(&tests));
        return Ok(round);
    }
    let found = correct(table, settings, &lines, &influence, made.compensation());
    let Some(found) = found.map_err(|e| of_correction(&e))? else {
        let why = "the measured traces do not determine any of the settings that may be turned: measure more of them";
        round.result.no_correction = Some(why.into());
        return Ok(round);
    };
    if let Some(end) = ClosedLoop::end(&found.correction) {
        round.result.no_correction = Some(match end {
            LoopEnd::NothingRemovable => {
                "these settings can remove hardly anything of what was measured".into()
            }
            LoopEnd::NothingToTurn => "every setting would change by less than it is known".into(),
        });
        return Ok(round);
    }
    let rounds = made.compensation().map_or(0, |c| c.rounds) + 1;
    let is_ground = |flank: Flank| made.simulated[flank].is_some();
    let next = made.compensated(compensation(&found, &influence, is_ground, rounds), progress)?;
    let mut proof = BTreeMap::new();
    for flank in Flank::BOTH {
        let (Some(surface), Some(before), Some(after)) =
            (&surfaces[flank], &made.simulated[flank], &next.simulated[flank])
        else {
            continue;
        };
        let [roll, face] = fields[flank];
        let field = ArealField::new(roll, face).map_err(|e| of_areal(&e))?;
        let change = after.minus(before);
        let model = first_order(&found, &influence, flank, [&before.w, &before.z]);
        let off_um = 1e3 * largest_about_mean(&change.f, &model);
        proof.insert(flank.name(), proof_of(surface, &change, &field, tolerance, off_um)?);
    }
    let [before, after] = rms_of(&proof);
    if after >= before {
        round.result.no_correction = Some(not_confirmed([before, after]));
        return Ok(round);
    }
    round.result.correction = Some(correction(&found, proof, made, &next));
    round.corrected = Some(next.job.clone());
    round.next = Some(next);
    Ok(round)
}

/// What a measured flank leaves before and after a change of the flank that the referee finds.
pub(super) fn proof_of(
    surface: &MeasuredSurface,
    change: &Topography,
    field: &ArealField,
    tolerance: f64,
    first_order_off_um: f64,
) -> Result<ProofResult, RunFailure> {
    let of = |left: &Topography| {
        Difference::new(left, field, ArealDegree::Second, tolerance)
            .map(|found| difference(&found))
            .map_err(|e| of_areal(&e))
    };
    let (before, after) = (of(&surface.deviation)?, of(&surface.deviation.plus(change))?);
    Ok(ProofResult { before, after, first_order_off_um })
}

/// Root mean squares over the flanks before and after a correction, um.
pub(super) fn rms_of(proof: &BTreeMap<&'static str, ProofResult>) -> [f64; 2] {
    let of = |of: fn(&ProofResult) -> &DifferenceResult| {
        let squares = proof.values().map(|flank| of(flank).rms_um.powi(2)).sum::<f64>();
        (squares / proof.len().max(1) as f64).sqrt()
    };
    [of(|flank| &flank.before), of(|flank| &flank.after)]
}

/// Why a correction that the referee does not confirm is none.
pub(super) fn not_confirmed([before, after]: [f64; 2]) -> String {
    format!(
        "the referee does not confirm what the lines propose: it would make {after:.3} of {before:.3} um rms"
    )
}

/// A flank on the grid: target, planned, simulated and measured.
pub(super) fn flank_result(
    [target, planned, simulated, measured]: [&Topography; 4],
    surface: &MeasuredSurface,
    compared: &Comparison,
    (pitch, tolerance): (f64, f64),
) -> MeasuredFlankResult {
    MeasuredFlankResult {
        w_mm: target.w.clone(),
        z_mm: target.z.clone(),
        target_um: target.rows_um(),
        planned_um: planned.rows_um(),
        simulated_um: simulated.rows_um(),
        measured_um: known(measured),
        teeth: surface.teeth.len(),
        surface: surface.how.clone(),
        mismatch_um: surface.mismatch_um(),
        outside_traces: surface.outside_traces(),
        sees_twist: surface.sees_twist,
        standing_out: standing_out(&surface.teeth, |tooth| f64::from(tooth) * pitch)
            .iter()
            .filter(|odd| odd.largest > tolerance)
            .map(|odd| (odd.tooth, 1e3 * odd.largest))
            .collect(),
        produced: difference(&compared.produced),
        measured: difference(&compared.measured),
        model: difference(&compared.model),
        correlation: compared.correlation,
        explained: compared.model_explains(tolerance),
    }
}

/// Values in um; `None` where nothing was measured.
fn known(found: &Topography) -> Vec<Vec<Option<f64>>> {
    let rows = found.rows_um();
    rows.into_iter().map(|row| row.into_iter().map(|f| Some(f).filter(|f| f.is_finite())).collect()).collect()
}

fn largest_about_mean(a: &[f64], b: &[f64]) -> f64 {
    let apart: Vec<f64> = a.iter().zip(b).map(|(a, b)| a - b).collect();
    let mean = apart.iter().sum::<f64>() / apart.len() as f64;
    apart.iter().fold(0.0, |m: f64, x| m.max((x - mean).abs()))
}

pub(super) fn difference(of: &Difference) -> DifferenceResult {
    let features = of.fit.features();
    DifferenceResult {
        rms_um: 1e3 * of.rms,
        largest_um: 1e3 * of.largest,
        range_um: 1e3 * of.range,
        profile_slope_um: 1e3 * features.profile_slope,
        helix_slope_um: 1e3 * features.helix_slope,
        profile_crowning_um: 1e3 * features.profile_crowning,
        helix_crowning_um: 1e3 * features.helix_crowning,
        twist_um: 1e3 * features.twist,
        within_tolerance: of.within_tolerance,
    }
}

pub(super) fn characteristic(of: &TestedCharacteristic) -> CharacteristicResult {
    let test = of.test.as_ref().ok();
    let mean = of.values.iter().sum::<f64>() / of.values.len() as f64;
    let removed = test.filter(|t| t.harmonic_removed).and_then(|t| t.harmonic.as_ref());
    CharacteristicResult {
        flank: of.flank.name(),
        characteristic: of.characteristic.name(),
        teeth: of.teeth.clone(),
        repeats: of.repeats,
        values_um: of.values.iter().map(|mm| 1e3 * mm).collect(),
        common_um: 1e3 * test.map_or(mean, |t| t.common),
        uncertainty_um: test.map(|t| 1e3 * t.uncertainty),
        limit_um: test.map(|t| 1e3 * t.limit),
        p: test.map(|t| t.p),
        harmonic_um: removed.map(|h| 1e3 * h.amplitude),
        decision: test.map_or("not-tested", |t| t.decision.name()),
    }
}

/// Why no setting is worth turning.
pub(super) fn reason(tests: &[TestedCharacteristic]) -> String {
    if tests.is_empty() {
        return "nothing was measured that could be corrected".into();
    }
    if tests.iter().all(|t| t.test.is_err()) {
        return "at least 3 teeth must be measured, evenly around the gear".into();
    }
    "nothing that all teeth share is large enough for the settings that may be turned".into()
}

fn correction(
    found: &FoundCorrection,
    proof: BTreeMap<&'static str, ProofResult>,
    before: &Ground,
    after: &Ground,
) -> CorrectionResult {
    let of = &found.correction;
    let settings = found.settings.iter().zip(&of.settings).map(|(setting, s)| {
        let (size, ending) = unit(*setting);
        CorrectedSettingResult {
            name: setting.name() + ending,
            change: s.value / size,
            deviation: s.deviation.filter(|d| d.is_finite()).map(|d| d / size),
            total: found.total.get(&setting.name()).map_or(0.0, |(_, value)| value / size),
            at_bound: s.at_bound,
            dropped: s.dropped,
        }
    });
    CorrectionResult {
        settings: settings.collect(),
        rms_before_um: 1e3 * of.rms_before,
        rms_predicted_um: 1e3 * of.rms_after,
        rms_unremovable_um: 1e3 * of.rms_unremovable,
        rank: [of.rank, of.unknowns],
        not_told_apart: of.unseen.clone(),
        proof,
        machine: machine(before, after),
    }
}

/// What the corrected job changes on the machine.
fn machine(before: &Ground, after: &Ground) -> MachineChange {
    let (a, b) = (before.execution.settings(), after.execution.settings());
    let minus = |b: &[f64], a: &[f64]| {
        let at = |x: &[f64], k: usize| x.get(k).copied().unwrap_or(0.0);
        (0..a.len().max(b.len())).map(|k| at(b, k) - at(a, k)).collect::<Vec<f64>>()
    };
    let mut dressing = BTreeMap::new();
    for flank in Flank::BOTH {
        let of = |made: &Ground| made.execution.flanks[flank].as_ref()?.dressing().cloned();
        if let (Some(old), Some(new)) = (of(before), of(after)) {
            let (from, to) = old.corrections[0].interval();
            let largest = std::array::from_fn(|axis| {
                let places = foundation::numerics::equidistant([from, to], 101);
                let apart = places
                    .iter()
                    .map(|v| (new.corrections[axis].value(*v) - old.corrections[axis].value(*v)).abs());
                apart.fold(0.0, f64::max) * [1f64.to_degrees(), 1f64.to_degrees(), 1.0, 1.0][axis]
            });
            dressing.insert(flank.name(), largest);
        }
    }
    MachineChange {
        delta_d_um: minus(&b.delta_d_um, &a.delta_d_um),
        delta_phi_2_urad: minus(&b.delta_phi_2_urad, &a.delta_phi_2_urad),
        dressing,
    }
}
