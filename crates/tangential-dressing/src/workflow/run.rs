//! `plan` and `simulate` of tangential dressing: from a checked job to result, tables and report.

use super::flank::{TangentialRun, flank_result, radial_feed, run_flank};
use super::plan::{conventional, plan_pass, task_of};
use super::prepare::{TangentialPrepared, given_settings, prepare_tangential};
use super::remarks::{
    check_worm_width, flank_warnings, missed, pass_warning, shared_pass_warning, worm_lengths,
};
use super::result::{PassResult, SettingsResult, TangentialFlankResult, TangentialResult};
use super::sensitivities::sensitivities;
use super::settings::{SettledPass, job_settings};
use crate::job::LoadedTangentialJob;
use crate::workflow::control::control_of_tangential;
use crate::workflow::programs::programs_of_tangential;
use crate::{FitLimits, TangentialError, TangentialSettings};
use foundation::geometry::{Flank, Sides};
use foundation::numerics::Progress;
use generating_grinding::workflow::flank_verdict::{
    NO_MACHINE, judge_clearance, judge_control, judge_flank, judge_programs, leave_other_flanks,
};
use generating_grinding::workflow::programs::run_programs::RunPrograms;
use run::{Release, RunFailure, output_warnings};
use std::collections::BTreeMap;
use std::time::Instant;
use verdict::Verdict;

/// Everything that a run produces.
pub struct TangentialOutcome {
    /// The document of `result.json`.
    pub result: TangentialResult,
    /// Bodies and targets.
    pub prepared: TangentialPrepared,
    /// The flanks with their motions.
    pub flanks: Sides<Option<TangentialRun>>,
    /// NC programs with their proof, where the job names a machine.
    pub programs: Option<RunPrograms>,
}

/// Plans a job and has the plan refereed.
///
/// # Errors
/// [`RunFailure`]. A target missed within its tolerance is no error: the status says so.
pub fn plan_tangential(
    loaded: &LoadedTangentialJob,
    progress: &dyn Progress,
) -> Result<TangentialOutcome, RunFailure> {
    let begun = Instant::now();
    let ready = prepare_tangential(loaded)?.on_machine(loaded)?;
    plan_prepared(ready, begun, progress)
}

/// Plans a job whose preparation began at an instant.
pub(super) fn plan_prepared(
    ready: TangentialPrepared,
    begun: Instant,
    progress: &dyn Progress,
) -> Result<TangentialOutcome, RunFailure> {
    let mut timing = BTreeMap::from([("prepare", begun.elapsed().as_secs_f64())]);
    let planning = Instant::now();
    let passes = ready
        .passes
        .iter()
        .map(|pass| {
            let plan = plan_pass(&ready, pass, progress)?;
            Ok(SettledPass { flanks: pass.clone(), settings: plan.settings.clone(), plan: Some(plan) })
        })
        .collect::<Result<Vec<_>, RunFailure>>()?;
    timing.insert("plan", planning.elapsed().as_secs_f64());
    finish(ready, passes, timing, progress)
}

/// Runs the settings that stand in the job.
///
/// # Errors
/// [`RunFailure`], among them a job without `[settings]`.
pub fn simulate_tangential(
    loaded: &LoadedTangentialJob,
    progress: &dyn Progress,
) -> Result<TangentialOutcome, RunFailure> {
    let begun = Instant::now();
    let ready = prepare_tangential(loaded)?;
    let settings = given_settings(loaded, &ready)?;
    simulate_prepared(ready.on_machine(loaded)?, settings, begun, progress)
}

/// Runs the settings of each pass for a job whose preparation began at an instant.
pub(super) fn simulate_prepared(
    ready: TangentialPrepared,
    settings: Vec<TangentialSettings>,
    begun: Instant,
    progress: &dyn Progress,
) -> Result<TangentialOutcome, RunFailure> {
    let of_pass =
        |(pass, settings): (&Vec<Flank>, _)| SettledPass { flanks: pass.clone(), settings, plan: None };
    let passes = ready.passes.iter().zip(settings).map(of_pass).collect();
    let timing = BTreeMap::from([("prepare", begun.elapsed().as_secs_f64())]);
    finish(ready, passes, timing, progress)
}

fn finish(
    ready: TangentialPrepared,
    passes: Vec<SettledPass>,
    mut timing: BTreeMap<&'static str, f64>,
    progress: &dyn Progress,
) -> Result<TangentialOutcome, RunFailure> {
    let failed = |e: TangentialError| RunFailure::from(&e);
    let mut runs = Sides::both(()).map(|_, ()| None);
    let mut flanks = BTreeMap::new();
    let mut warnings = ready.warnings.clone();
    let refereeing = Instant::now();
    for pass in &passes {
        let wanted = |flank: Flank, w: f64, z: f64| ready.wanted(flank, w, z);
        let task = task_of(&ready, &pass.flanks, &wanted, FitLimits::STEADY);
        let judged = task.judge(&pass.settings, ready.rules.judged_on).map_err(failed)?;
        let radial = ready.rules.compare_radial.then(|| conventional(&ready, &pass.flanks));
        for of_flank in &judged {
            let flank = of_flank.flank;
            let run = run_flank(&ready, of_flank, pass, progress)?;
            let radial = radial.as_ref().map(|r| radial_feed(&ready, pass, flank, r, &run.target));
            warnings.extend(flank_warnings(of_flank));
            flanks.insert(flank.name(), flank_result(&ready, of_flank, &run, radial));
            runs[flank] = Some(run);
        }
        warnings.extend(pass.plan.as_ref().and_then(|plan| pass_warning(plan, ready.tolerance())));
    }
    timing.insert("referee", refereeing.elapsed().as_secs_f64());
    let lengths = worm_lengths(&passes, &runs);
    check_worm_width(&ready, &runs, &passes, lengths)?;
    warnings.extend(shared_pass_warning(&passes));
    let controlling = Instant::now();
    let (control, alarms) = control_of_tangential(&ready, &runs)?.unzip();
    if control.is_some() {
        timing.insert("control", controlling.elapsed().as_secs_f64());
    }
    let programs = programs_of_tangential(&ready, &runs)?;
    if let Some(programs) = &programs {
        timing.insert("programs", programs.seconds[0]);
        timing.insert("proof of the programs", programs.seconds[1]);
    }
    warnings.extend(output_warnings(&ready.output, ready.names_machine));
    warnings.extend(programs.iter().flat_map(|programs| programs.warnings.iter().cloned()));
    warnings.extend(alarms.unwrap_or_default());
    let sensitivities = sensitivities(&ready, &passes).map_err(failed)?;
    let tolerance = ready.tolerance_um;
    let mut verdict = Verdict::new();
    for (name, TangentialFlankResult { flank, .. }) in &flanks {
        let met = flank.tolerance_share <= 1.0;
        judge_flank(&mut verdict, name, flank, (tolerance, None), met, || missed(&ready, &flanks, &passes));
    }
    leave_other_flanks(&mut verdict, &flanks);
    judge_control(&mut verdict, control.as_ref(), tolerance);
    let made = programs.as_ref().map(|programs| &programs.result);
    judge_programs(&mut verdict, made.ok_or(NO_MACHINE), tolerance, |name| {
        flanks[name].flank.tolerance_share
    });
    if let Some(made) = made {
        judge_clearance(&mut verdict, made.clearance.as_ref());
    }
    ready.measures.leave_class(&mut verdict);
    if programs.is_some() {
        warnings.extend(Release::of(&verdict, ready.output.programs_of_missed).remark(&verdict));
    }
    let result = TangentialResult {
        job: ready.info.name.clone(),
        process: ready.info.process.name().to_string(),
        version: env!("CARGO_PKG_VERSION"),
        verdict,
        tolerance_um: tolerance,
        warnings,
        settings: settings_result(&ready, &passes, lengths),
        flanks,
        passes: passes.iter().filter_map(|p| p.plan.as_ref().map(PassResult::from)).collect(),
        drawing: ready.measures.result(&ready.model.input().gear),
        control,
        programs: programs.as_ref().map(|programs| programs.result.clone()),
        sensitivities,
        timing_s: timing,
    };
    Ok(TangentialOutcome { result, prepared: ready, flanks: runs, programs })
}

fn settings_result(
    ready: &TangentialPrepared,
    passes: &[SettledPass],
    [side_by_side, one_after_the_other]: [f64; 2],
) -> SettingsResult {
    let model = &ready.model;
    SettingsResult {
        settings: job_settings(ready, passes),
        centre_distance_mm: model.pair.chain.centre_distance,
        crossed_axes_angle_deg: model.pair.chain.crossed_axes_angle.to_degrees(),
        dressing_centre_distance_mm: model.chain.centre_distance,
        dressing_crossing_angle_deg: model.chain.crossing_angle.to_degrees(),
        screw_parameter_mm: model.chain.screw_parameter,
        shift_width_mm: model.input().shift_width,
        shift_ratio: model.shift_ratio,
        neutral_shift_ratio: model.neutral_ratio(),
        neutral_shift_ratio_by_flank: match model.neutral_ratio() {
            Some(_) => BTreeMap::new(),
            None => {
                Flank::BOTH.into_iter().filter_map(|f| Some((f.name(), model.neutral_ratios[f]?))).collect()
            }
        },
        contact_shift_offset_mm: Flank::BOTH.map(|f| (f.name(), model.lines[f].offset)).into(),
        worm_pitch_diameter_mm: 2.0 * model.pair.worm.pitch_radius(),
        dresser_pitch_diameter_mm: 2.0 * model.input().dresser_pitch_radius,
        worm_length_side_by_side_mm: side_by_side,
        worm_length_one_after_the_other_mm: one_after_the_other,
    }
}
