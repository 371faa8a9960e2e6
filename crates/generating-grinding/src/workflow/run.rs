//! `plan` and `simulate`: from a checked job to result, tables and report.

use super::conditions::conditions_of_plan;
use super::deviated::with_deviations;
use super::drawn_values::{drawn_values, judge_traces};
use super::equal_ratio_offers::equal_ratio_remark;
use super::execution::Execution;
use super::flank_verdict::{
    NO_MACHINE, judge_clearance, judge_control, judge_envelope, judge_flank, judge_programs,
    leave_other_flanks, owe_line_dressing,
};
use super::gear_root::gear_root;
use super::line_dressing::{LineDressingResult, WrittenFlank, line_dressing};
use super::measured_worm::measured_worm;
use super::miss::{Miss, missed};
use super::partition::Partition;
use super::prepare::{GivenSettings, Prepared, prepare};
use super::referee::{self, Cutting};
use super::refusal::{of_planning, of_simulation};
use super::removal::{RunCycle, judge_stock, put_on_stock, removal_of_run};
use super::result::{CandidateResult, FlankResult, JobResult, LeastDeviationResult, SettingsResult};
use super::roughing::{Roughed, judge_roughing, roughed_flanks};
use super::spared_worms::spared_worms;
use super::tip_edge::{judge_tip_edge, tip_edge_depths};
use super::tip_land::TipLands;
use super::wanted_worm::{gear_missed, judge_worm, worm_flanks};
use crate::job::LoadedJob;
use crate::workflow::control::of_grinding::control_of_grinding;
use crate::workflow::programs::of_grinding::programs_of_grinding;
use crate::workflow::programs::run_programs::RunPrograms;
use foundation::geometry::{Flank, Sides};
use foundation::numerics::Progress;
use generating::{Effort, GrindingPlan, ProfilePlace, RatioReason};
use report::charts::DressingSectionChart;
use run::{CharacteristicsUm, Release, RunFailure, output_warnings};
use std::collections::BTreeMap;
use std::time::Instant;
use verdict::{Remark, Status, Verdict};

/// Everything that a run produces.
pub struct Outcome {
    /// The document of `result.json`.
    pub result: JobResult,
    /// Bodies and targets.
    pub prepared: Prepared,
    /// Motions and flanks.
    pub execution: Execution,
    /// The plan, unless the settings stood in the job.
    pub plan: Option<GrindingPlan>,
    /// What the referee found.
    pub verdicts: Sides<Option<referee::Verdict>>,
    /// The dresser in the thread space where it has least room, a picture for each flank that is dressed alone.
    pub sections: Vec<DressingSectionChart>,
    /// How a disc in point contact writes the worm, where there is one.
    pub written: Sides<Option<WrittenFlank>>,
    /// NC programs with their proof, where the job names a machine.
    pub programs: Option<RunPrograms>,
}

/// Plans a job and has the plan refereed.
///
/// # Errors
/// [`RunFailure`]. A target missed within its tolerance is no error: the status says so.
pub fn plan_job(loaded: &LoadedJob, progress: &dyn Progress) -> Result<Outcome, RunFailure> {
    planned(|| prepare(loaded)?.on_machine(loaded), progress)
}

/// As [`plan_job`], with the effort of a plan that is tried beside others.
///
/// # Errors
/// [`RunFailure`].
pub(super) fn plan_as_trial(loaded: &LoadedJob, progress: &dyn Progress) -> Result<Outcome, RunFailure> {
    let begun = Instant::now();
    let mut ready = prepare(loaded)?;
    ready.rules.effort = Effort::Trial;
    // The worm that was measured was dressed for the plan itself.
    ready.measured_worm = None;
    planned_once(ready, begun, progress).map_err(|refused| refused.failure)
}

/// Runs the settings that stand in the job.
///
/// # Errors
/// [`RunFailure`], among them a job without `[settings]`.
pub fn simulate_job(loaded: &LoadedJob, progress: &dyn Progress) -> Result<Outcome, RunFailure> {
    let begun = Instant::now();
    let ready = prepare(loaded)?.on_machine(loaded)?;
    let settings = GivenSettings::of_job(loaded, &ready)?.ok_or_else(RunFailure::no_settings)?;
    simulated(ready, &settings, begun, progress)
}

/// The run of a job, by its settings if it has some, whose programs are somebody else's: none are made.
///
/// # Errors
/// [`RunFailure`] as for a plan or a simulation.
pub fn run_without_programs(loaded: &LoadedJob, progress: &dyn Progress) -> Result<Outcome, RunFailure> {
    let begun = Instant::now();
    let ready = prepare(loaded)?;
    match GivenSettings::of_job(loaded, &ready)? {
        Some(settings) => simulated(ready, &settings, begun, progress),
        None => planned(|| prepare(loaded), progress),
    }
}

/// A plan that comes to nothing.
struct Refused {
    failure: RunFailure,
    /// Whether a best fit was planned, and the simulation does not carry it out.
    fitted: bool,
}

/// Whether a plan without shift misses its target, and corrections of dressing that the job leaves open may make the profile.
fn profile_is_left_to_dressing(outcome: &Outcome) -> bool {
    let rules = &outcome.prepared.rules;
    outcome.result.verdict.status() == Status::Missed
        && rules.known_ratio() == Some(0.0)
        && !rules.free_dresser
        && rules.places == [ProfilePlace::Diagonal, ProfilePlace::Correction]
        && outcome.prepared.law.is_none()
}

/// Plans. Without shift the profile of a dresser that is given is corrected by the dressing motion where that meets a target that is missed
/// else. A best fit that the simulation does not carry out gives way to the nearest one whose command is smoother: the target is then
/// missed with figures.
fn planned(
    ready: impl Fn() -> Result<Prepared, RunFailure>,
    progress: &dyn Progress,
) -> Result<Outcome, RunFailure> {
    let begun = Instant::now();
    let refused = match planned_once(ready()?, begun, progress) {
        Ok(outcome) if profile_is_left_to_dressing(&outcome) => {
            let mut ready = ready()?;
            ready.rules.places = vec![ProfilePlace::Correction];
            // Where the dresser has no room for it, the plan without stays.
            return Ok(match planned_once(ready, begun, progress) {
                Ok(corrected) if corrected.result.verdict.status() == Status::Met => corrected,
                _ => outcome,
            });
        }
        Ok(outcome) => return Ok(outcome),
        Err(refused) => refused,
    };
    if refused.fitted {
        for near in Effort::FURTHER {
            let mut ready = ready()?;
            ready.rules.effort = Effort::Further(near);
            if let Ok(outcome) = planned_once(ready, begun, progress) {
                return Ok(outcome);
            }
        }
    }
    Err(refused.failure)
}

fn planned_once(ready: Prepared, begun: Instant, progress: &dyn Progress) -> Result<Outcome, Refused> {
    let prepared_at = begun.elapsed().as_secs_f64();
    let planning = Instant::now();
    let plan = ready.task().plan_or_tried();
    let plan = plan.map_err(|refused| Refused { failure: of_planning(&refused, &ready), fitted: false })?;
    let planned_in = planning.elapsed().as_secs_f64();
    let execution = Execution::of_plan(&ready, &plan);
    let timing = BTreeMap::from([("prepare", prepared_at), ("plan", planned_in)]);
    let fitted = plan.choice.reason == RatioReason::BestFit;
    finish(ready, execution, Some(plan), timing, progress).map_err(|failure| Refused {
        fitted: fitted && matches!(failure, RunFailure::NotProducible(_)),
        failure,
    })
}

fn simulated(
    ready: Prepared,
    settings: &GivenSettings,
    begun: Instant,
    progress: &dyn Progress,
) -> Result<Outcome, RunFailure> {
    let execution = Execution::of_settings(&ready, settings)?;
    let timing = BTreeMap::from([("prepare", begun.elapsed().as_secs_f64())]);
    finish(ready, execution, None, timing, progress)
}

/// Why programs are left out.
const ROUGHED_TOO_DEEP: &str = "a roughing stroke goes below the finished flank";

fn finish(
    mut prepared: Prepared,
    execution: Execution,
    plan: Option<GrindingPlan>,
    mut timing: BTreeMap<&'static str, f64>,
    progress: &dyn Progress,
) -> Result<Outcome, RunFailure> {
    let partition = Partition::of_cycle(&prepared, execution.ratio, &execution.motion.shift)?;
    let stroking = Instant::now();
    let on_stock = put_on_stock(&mut prepared, &execution)?;
    let stroked_in = stroking.elapsed().as_secs_f64();
    let cycle = &prepared.cycle;
    let tip_lands = TipLands::of_execution(&prepared, &execution, plan.is_some())?;
    let (spared_worms, worm_cut) = spared_worms(&prepared, &execution);
    let dressing_lines = Instant::now();
    let written = line_dressing(&prepared, &execution, progress)?;
    if written.iter().any(|(_, w)| w.is_some()) {
        timing.insert("dressing lines", dressing_lines.elapsed().as_secs_f64());
    }
    let refereeing = Instant::now();
    let finishing_feed = on_stock.as_ref().and_then(RunCycle::finishing_feed);
    let cutting = Cutting {
        feed_per_revolution: finishing_feed.or(cycle.feed_per_revolution),
        strokes: cycle.strokes.as_ref(),
    };
    let verdicts = referee::run(&prepared.setup, &execution, cutting, progress).map_err(|e| {
        // What took the place of a refusal and cannot be ground is refused for the first reason.
        let refused = plan.as_ref().and_then(|plan| plan.instead_of.as_deref());
        refused.map_or_else(
            || of_simulation(&e, &prepared, plan.is_some()),
            |refused| of_planning(refused, &prepared),
        )
    })?;
    let traces = Sides::try_from_fn(|flank| match &verdicts[flank] {
        Some(verdict) => drawn_values(&prepared, &execution, (flank, verdict), cutting),
        None => Ok(Vec::new()),
    })
    .map_err(|e| of_simulation(&e, &prepared, plan.is_some()))?;
    let deviated = with_deviations(&prepared, &execution, (&verdicts, cutting), progress)?;
    let measured_worm = measured_worm(&prepared, &execution)?;
    let gear_root = gear_root(&prepared, &execution)?;
    let tip_edge = tip_edge_depths(&prepared, &execution, (&verdicts, cutting))?;
    timing.insert("referee", refereeing.elapsed().as_secs_f64());
    let controlling = Instant::now();
    let (control, alarms) = control_of_grinding(&prepared, &execution, &verdicts)?.unzip();
    if control.is_some() {
        timing.insert("control", controlling.elapsed().as_secs_f64());
    }
    let roughed = roughed_flanks(&prepared, &execution, (&verdicts, cutting));
    let too_deep = roughed.iter().any(Roughed::is_too_deep);
    // Programs that cut into the finished flank are not to be proven.
    let programs = match too_deep {
        true => None,
        false => programs_of_grinding(&prepared, &execution, &verdicts, (cutting, &written))?,
    };
    if let Some(programs) = &programs {
        timing.insert("programs", programs.seconds[0]);
        timing.insert("proof of the programs", programs.seconds[1]);
    }
    let removing = Instant::now();
    let removal =
        removal_of_run(&prepared, (on_stock.as_ref(), programs.as_ref().map(|programs| &programs.result)))?;
    if let Some(on_stock) = &on_stock {
        let choosing = on_stock.offers.as_ref().map_or(0.0, |offers| offers.seconds);
        timing.insert("cycles within the limits", choosing);
        timing.insert("stock and strokes", stroked_in - choosing + removing.elapsed().as_secs_f64());
    }
    let mut warnings = prepared.warnings.clone();
    warnings.extend(execution.warnings.iter().cloned());
    warnings.extend(tip_lands.warnings.iter().cloned());
    warnings.extend(worm_cut);
    warnings.extend(output_warnings(&prepared.output, prepared.names_machine));
    warnings.extend(programs.iter().flat_map(|programs| programs.warnings.iter().cloned()));
    let tolerance = prepared.tolerance.tightest() * 1e3;
    // A simulation has no plan that could say what stands on the tool's lines: the target is judged by its deviation alone.
    let outside = plan.as_ref().map_or(Sides::both(0.0), |p| p.ideal.outside);
    let mut flanks = BTreeMap::new();
    for flank in Flank::BOTH {
        let (Some(executed), Some(verdict)) = (&execution.flanks[flank], &verdicts[flank]) else { continue };
        let cos_b = prepared.setup.lines[flank].cos_b2;
        let deviation = verdict.simulated.minus(&executed.target);
        let lines = written[flank].as_ref().map(|w| &w.result);
        // What the lines leave of the worm counts in full: on the flank it is no more than that.
        let from_lines = lines.map_or(0.0, LineDressingResult::off_um) / tolerance;
        flanks.insert(
            flank.name(),
            FlankResult {
                w_mm: executed.target.w.clone(),
                z_mm: executed.target.z.clone(),
                target_um: executed.target.rows_um(),
                planned_um: executed.planned.rows_um(),
                simulated_um: verdict.simulated.rows_um(),
                max_deviation_um: deviation.largest() * 1e3,
                rms_deviation_um: deviation.rms() * 1e3,
                tolerance_share: prepared.tolerance_share(&deviation) + from_lines,
                model_difference_um: executed.planned.minus(&verdict.simulated).largest() * 1e3,
                referee_error_um: verdict.grinding.error_um,
                line_dressing: lines.cloned(),
                feed_mark_um: verdict.feed_mark.as_ref().and_then(|h| h.as_ref().ok()).map(|h| h * 1e3),
                target_characteristics: CharacteristicsUm::of(&executed.target, cos_b),
                simulated_characteristics: CharacteristicsUm::of(&verdict.simulated, cos_b),
                traces: traces[flank].clone(),
                outside_class_um: outside[flank] * cos_b * 1e3,
                planned_between_um: plan.as_ref().map(|p| p.between[flank] * 1e3).filter(|&um| um > 0.0),
                least_determinant_ratio: executed.determinant,
            },
        );
    }
    warnings.extend(feed_mark_warnings(&verdicts, tolerance));
    warnings.extend(alarms.unwrap_or_default());
    warnings.extend(removal.remarks);
    warnings.extend(line_dressing_warnings(&written, prepared.setup.worm_root_radius));
    warnings.extend(plan.as_ref().and_then(given_ratio_warning));
    warnings.extend(plan.as_ref().and_then(|_| equal_ratio_remark(&prepared.setup, &prepared.targets)));
    // Parts outside the class count by themselves: the grid may miss them (a wave between its points).
    let allowed = if prepared.tolerance.is_uniform() { tolerance } else { f64::INFINITY };
    let met = |f: &FlankResult| {
        f.tolerance_share <= 1.0
            && f.outside_class_um <= tolerance
            && f.planned_between_um.is_none_or(|between| between <= allowed)
    };
    let mut verdict = Verdict::new();
    let worm = worm_flanks(&prepared, &execution, &verdicts);
    let least_deviation = plan.as_ref().and_then(|plan| plan.least).map(|least| {
        let left = flanks.values().map(|flank| flank.tolerance_share * tolerance).fold(0.0, f64::max);
        LeastDeviationResult::of(&least, left, tolerance)
    });
    let why = || {
        if !worm.is_empty() {
            return gear_missed(&worm);
        }
        missed(&Miss {
            prepared: &prepared,
            plan: plan.as_ref(),
            least: least_deviation.as_ref(),
            flanks: &flanks,
            ratio: execution.ratio,
        })
    };
    for (name, flank) in &flanks {
        let judged_on = (tolerance, prepared.judged_on.as_deref());
        judge_flank(&mut verdict, name, flank, judged_on, met(flank), why);
    }
    judge_traces(&mut verdict, &flanks, why);
    judge_worm(&mut verdict, &worm, tolerance);
    for (name, flank) in &flanks {
        let limit = prepared.rules.least_determinant();
        judge_envelope(&mut verdict, name, flank.least_determinant_ratio, limit);
    }
    leave_other_flanks(&mut verdict, &flanks);
    judge_tip_edge(&mut verdict, &tip_edge, tolerance);
    judge_control(&mut verdict, control.as_ref(), tolerance);
    if gear_root.is_some() {
        verdict.met(
            "root of the gear",
            "the simulation finds the planned fillet; the job gives it no tolerance",
        );
    } else {
        verdict.leave("root of the gear", "the job does not grind it");
    }
    let made = programs.as_ref().map(|programs| &programs.result);
    let without = if too_deep { ROUGHED_TOO_DEEP } else { NO_MACHINE };
    judge_programs(&mut verdict, made.ok_or(without), tolerance, |name| flanks[name].tolerance_share);
    if let Some(made) = made {
        judge_clearance(&mut verdict, made.clearance.as_ref());
        if written.iter().any(|(_, lines)| lines.is_some())
            && made.proofs.iter().any(|proof| proof.lines.is_empty())
        {
            owe_line_dressing(&mut verdict);
        }
    }
    judge_roughing(&mut verdict, &prepared, roughed);
    if let Some(removal) = &removal.result {
        judge_stock(&mut verdict, removal);
    }
    prepared.measures.leave_class(&mut verdict);
    if programs.is_some() {
        warnings.extend(Release::of(&verdict, prepared.output.programs_of_missed).remark(&verdict));
    }
    let result = JobResult {
        job: prepared.info.name.clone(),
        process: prepared.info.process.name().to_string(),
        version: env!("CARGO_PKG_VERSION"),
        verdict,
        tolerance_um: tolerance,
        warnings,
        settings: settings_result(&prepared, &execution, plan.as_ref(), partition, &tip_lands),
        flanks,
        worm,
        least_deviation,
        changes: Vec::new(),
        deviated,
        measured_worm,
        spared_worms,
        gear_root,
        control,
        drawing: prepared.measures.result(&prepared.setup.input.gear),
        removal: removal.result,
        programs: programs.as_ref().map(|programs| programs.result.clone()),
        ideal_error_by_round_um: plan.as_ref().map_or(Sides { left: Vec::new(), right: Vec::new() }, |p| {
            p.ideal_error_by_round.map(|_, e| e.iter().map(|e| e * 1e3).collect())
        }),
        timing_s: timing,
    };
    Ok(Outcome {
        result,
        prepared,
        execution,
        plan,
        verdicts,
        sections: tip_lands.pictures,
        written,
        programs,
    })
}

/// The settings with how the ratio was found and what follows from the bodies.
pub fn settings_result(
    prepared: &Prepared,
    execution: &Execution,
    plan: Option<&GrindingPlan>,
    partition: Option<Partition>,
    tip_lands: &TipLands,
) -> SettingsResult {
    let setup = &prepared.setup;
    let candidates = plan.iter().flat_map(|p| &p.choice.candidates);
    let dressing = execution.dresser.as_ref().map(|d| &d.flanks.left.chain);
    SettingsResult {
        settings: execution.settings(),
        diagonal_ratio_reason: plan.map(|p| ratio_reason(p.choice.reason).to_string()),
        demanded_ratios: plan
            .map(|p| p.choice.demanded.clone())
            .filter(|demanded| demanded.iter().any(|(_, ratios)| !ratios.is_empty())),
        dressing_conditions: plan.map_or(Vec::new(), conditions_of_plan),
        lead_correction_ratio: plan.map(|p| p.choice.lead_correction),
        profile_crowning_by: plan.map(|p| p.choice.place.name()),
        candidates: candidates.map(CandidateResult::of).collect(),
        centre_distance_mm: setup.pair.chain.centre_distance,
        crossed_axes_angle_deg: setup.pair.chain.crossed_axes_angle.to_degrees(),
        feed_stroke_mm: execution.feed_range,
        partition,
        index_strokes: prepared.cycle.strokes.clone(),
        worm_occupation_mm: execution.occupation,
        worm_length_mm: execution.occupation[1] - execution.occupation[0],
        worm_pitch_diameter_mm: 2.0 * setup.worm_pitch_radius,
        worm_root_diameter_mm: 2.0 * setup.worm_root_radius,
        largest_tip_land_mm: Some(tip_lands.largest)
            .filter(|lands| lands.iter().any(|(_, land)| land.is_some())),
        dressing_centre_distance_mm: dressing.map(|chain| chain.centre_distance),
        dressing_crossing_angle_deg: dressing.map(|chain| chain.crossing_angle.to_degrees()),
    }
}

/// The rule that settled the ratio, in words.
pub fn ratio_reason(reason: RatioReason) -> &'static str {
    match reason {
        RatioReason::Given => "Given in the job.",
        RatioReason::EqualSwivel => "The ratio at which both flanks ask for the same swivel of the dresser.",
        RatioReason::RadialSuffices => "The radial method makes this target without mixed residual.",
        RatioReason::LeadCorrection => "Lead-correction ratio K*: needs the smallest dressing correction.",
        RatioReason::Compromise => {
            "The flanks want different lead-correction ratios: the one with the smallest dressing corrections between them."
        }
        RatioReason::LeastError => {
            "No allowed ratio is exact to half the tolerance on an ideal worm: the one of least error."
        }
        RatioReason::Scan => "Ratio with the smallest dressing corrections among those tried.",
        RatioReason::LeastWorm => {
            "The ratio that uses least of the worm within half the tolerance and half the limits of the axes (`grinding.prefer`)."
        }
        RatioReason::LeastTravel => {
            "The ratio of the shortest feed travel within half the tolerance and half the limits of the axes (`grinding.prefer`)."
        }
        RatioReason::LinesOfTarget => {
            "The ratio that lays the tool's lines onto reliefs or waves of the target."
        }
        RatioReason::BestFit => {
            "The ratio at which worm, dresser and motion together come nearest to the whole target."
        }
        RatioReason::Law => "The shift follows a law of the feed; the ratio is its mean.",
    }
}

/// Feed marks that cannot be followed or stand above the tolerance.
fn feed_mark_warnings(verdicts: &Sides<Option<referee::Verdict>>, tolerance: f64) -> Vec<Remark> {
    let mut warnings = Vec::new();
    for (flank, verdict) in verdicts.iter() {
        match verdict.as_ref().and_then(|v| v.feed_mark.as_ref()) {
            Some(Ok(height)) if height * 1e3 > tolerance => warnings.push(Remark {
                code: "feed-marks-above-tolerance",
                text: format!(
                    "the feed marks of the {flank} flank stand up to {:.3} um above the envelope",
                    height * 1e3
                ),
                way_out: "reduce grinding.feed_per_revolution".into(),
            }),
            Some(Err(error)) => warnings.push(Remark {
                code: "feed-marks-not-followed",
                text: format!("the feed marks of the {flank} flank could not be followed: {error}"),
                way_out: "reduce grinding.feed_per_revolution".into(),
            }),
            _ => {}
        }
    }
    warnings
}

/// A disc that reaches below the worm's root.
fn line_dressing_warnings(written: &Sides<Option<WrittenFlank>>, root_radius: f64) -> Vec<Remark> {
    let mut warnings = Vec::new();
    for (flank, written) in written.iter() {
        let Some(r) = written.as_ref().map(|w| &w.result) else { continue };
        if r.deepest_radius_mm < root_radius {
            warnings.push(Remark {
                code: "disc-below-worm-root",
                text: format!(
                    "writing the {flank} flank, the disc reaches to {:.3} mm radius, {:.3} mm below the root of the worm",
                    r.deepest_radius_mm,
                    root_radius - r.deepest_radius_mm
                ),
                way_out: "take a smaller dresser.tip_radius, or raise dresser.root_clearance".into(),
            });
        }
    }
    warnings
}

/// A ratio that the job gives overrides the limits, with a remark.
fn given_ratio_warning(plan: &GrindingPlan) -> Option<Remark> {
    let (code, whose) = match plan.choice.reason {
        RatioReason::Given => ("given-ratio-beyond-limits", "the given diagonal ratio"),
        RatioReason::EqualSwivel => ("swivel-ratio-beyond-limits", "the diagonal ratio of equal swivel"),
        _ => return None,
    };
    let refusal = plan.choice.candidates.first()?.refusal.as_ref()?;
    Some(Remark {
        code,
        text: format!("{whose} would not have been chosen: {refusal}"),
        way_out: "use diagonal_ratio = \"auto\", or check that the machine has the travel".into(),
    })
}
