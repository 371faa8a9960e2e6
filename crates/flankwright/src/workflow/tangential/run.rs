//! `plan` and `simulate` of tangential dressing: from a checked job to result, tables and report.

use super::plan::{PassPlan, conventional, plan_pass, result_grid, task_of};
use super::prepare::{TangentialPrepared, channel_of, measure_of, prepare_tangential, variable_of};
use super::referee::{Refereed, referee};
use super::result::{
    ChoiceStep, MethodResult, PassResult, RadialFeedResult, SensitivityResult, SettingsResult,
    TangentialFlankResult, TangentialResult, VariableValue,
};
use crate::contact::Measure;
use crate::exchange::tangential_job::{
    FlankValues, Passes, SplineValues, TangentialJob, TangentialSettings as JobSettings,
};
use crate::exchange::{Diagnostic, LoadedTangentialJob, Problem};
use crate::geometry::{Flank, Sides};
use crate::metrology::Topography;
use crate::numerics::Progress;
use crate::process::tangential_dressing::{
    Channel, Fit, FitGrid, FitLimits, Judged, RollGrid, Shape, TangentialError, TangentialFlank,
    TangentialSettings, TangentialStrokes, Variable,
};
use crate::workflow::finding::{Remark, RunFailure};
use crate::workflow::result::{CharacteristicsUm, FlankResult, Status};
use std::collections::BTreeMap;
use std::time::Instant;

/// Everything that a run produces.
pub struct TangentialOutcome {
    /// The document of `result.json`.
    pub result: TangentialResult,
    /// Bodies and targets.
    pub prepared: TangentialPrepared,
    /// The flanks with their motions.
    pub flanks: Sides<Option<TangentialRun>>,
}

/// One flank as run.
pub struct TangentialRun {
    /// Flanks of its pass.
    pub pass: Vec<Flank>,
    /// All values.
    pub settings: TangentialSettings,
    /// What the axes do.
    pub strokes: TangentialStrokes,
    /// What is wanted, normal, mm.
    pub target: Topography,
    /// What the exact contact gives, in the measure of the job.
    pub planned: Topography,
    /// What the rays left, in the measure of the job.
    pub simulated: Topography,
    /// Largest difference of rays and exact contact, mm.
    pub model_difference: f64,
    /// The same on the sample without a surface between the stages, mm.
    pub sample_difference: f64,
    /// The referee's own account.
    pub refereed: Refereed,
}

/// A pass whose values are settled, by a plan or by the job.
struct SettledPass {
    flanks: Vec<Flank>,
    settings: TangentialSettings,
    plan: Option<PassPlan>,
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
    let ready = prepare_tangential(loaded)?;
    let mut timing = BTreeMap::from([("prepare", begun.elapsed().as_secs_f64())]);
    let planning = Instant::now();
    let passes = ready
        .passes
        .iter()
        .map(|pass| {
            let plan = plan_pass(&loaded.job, &ready, pass, progress)?;
            Ok(SettledPass { flanks: pass.clone(), settings: plan.settings.clone(), plan: Some(plan) })
        })
        .collect::<Result<Vec<_>, RunFailure>>()?;
    timing.insert("plan", planning.elapsed().as_secs_f64());
    finish(loaded, ready, passes, timing, progress)
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
    let Some(given) = &loaded.job.settings else {
        let finding = Diagnostic::new(Problem::MissingKey, "the job has no settings to simulate")
            .field("settings")
            .way_out("plan the job first: `flankwright plan` writes settings.json, which `simulate` takes");
        return Err(RunFailure::bad_input(finding));
    };
    let passes = ready
        .passes
        .iter()
        .map(|pass| {
            let settings = settings_of_job(given, &ready, pass)?;
            Ok(SettledPass { flanks: pass.clone(), settings, plan: None })
        })
        .collect::<Result<Vec<_>, RunFailure>>()?;
    let timing = BTreeMap::from([("prepare", begun.elapsed().as_secs_f64())]);
    finish(loaded, ready, passes, timing, progress)
}

/// The values of a pass as the job has them; the shift ratio and offset of the job stand in place of those of the bodies.
fn settings_of_job(
    given: &JobSettings,
    ready: &TangentialPrepared,
    pass: &[Flank],
) -> Result<TangentialSettings, RunFailure> {
    let values = given.of_flank(pass[0]);
    let mut settings = TangentialSettings::default();
    let offset = Variable::power(Channel::ToolShift, 0);
    for (&name, &value) in &values.values {
        let variable = variable_of(name, &format!("settings.values.{name}"))?;
        let own = if variable == offset { ready.model.shift_offset(pass) } else { 0.0 };
        settings.set(&variable, value - own);
    }
    if let Some(ratio) = values.kap {
        settings.set(&Variable::shift_ratio(), ratio - ready.model.shift_ratio);
    }
    for (i, spline) in values.splines.iter().enumerate() {
        let field = format!("settings.splines[{i}]");
        let channel = channel_of(spline.channel, &field)?;
        let functions = Variable::spline(channel, spline.intervals, ready.model.spline_range(channel, pass))
            .map_err(|e| RunFailure::of_tangential_on(&e, &field))?;
        if functions.len() != spline.coefficients.len() {
            let text =
                format!("a spline of {} intervals has {} coefficients", spline.intervals, functions.len());
            let finding = Diagnostic::new(Problem::InvalidJob, text)
                .field(format!("{field}.coefficients"))
                .value(spline.coefficients.len())
                .allowed(functions.len().to_string())
                .way_out("take the coefficients as `plan` wrote them");
            return Err(RunFailure::bad_input(finding));
        }
        for (variable, &value) in functions.iter().zip(&spline.coefficients) {
            settings.set(variable, value);
        }
    }
    Ok(settings)
}

/// The values of a pass as a job carries them.
fn settings_for_job(ready: &TangentialPrepared, pass: &SettledPass) -> FlankValues {
    let mut values = BTreeMap::new();
    let mut splines: Vec<SplineValues> = Vec::new();
    let mut shift_offset = ready.model.shift_offset(&pass.flanks);
    for (variable, value) in pass.settings.values() {
        match (&variable.shape, variable.channel) {
            (_, Channel::ShiftRatio) => {}
            (Shape::Power(0), Channel::ToolShift) => shift_offset += value,
            (Shape::Power(_), _) => {
                if let Ok(name) = variable.to_string().parse() {
                    values.insert(name, *value);
                }
            }
            (Shape::Spline { basis, index, .. }, channel) => {
                let Some(named) = crate::exchange::tangential_job::Channel::ALL
                    .into_iter()
                    .find(|c| c.name() == channel.name())
                else {
                    continue;
                };
                if !splines.iter().any(|s| s.channel == named) {
                    splines.push(SplineValues {
                        channel: named,
                        intervals: basis.count() - basis.degree(),
                        coefficients: vec![0.0; basis.count()],
                    });
                }
                if let Some(spline) = splines.iter_mut().find(|s| s.channel == named) {
                    spline.coefficients[*index] = *value;
                }
            }
        }
    }
    if let Ok(name) = Variable::power(Channel::ToolShift, 0).to_string().parse() {
        values.insert(name, shift_offset);
    }
    let ratio = ready.model.shift_ratio + pass.settings.value(&Variable::shift_ratio());
    FlankValues { kap: Some(ratio), values, splines }
}

fn finish(
    loaded: &LoadedTangentialJob,
    ready: TangentialPrepared,
    passes: Vec<SettledPass>,
    mut timing: BTreeMap<&'static str, f64>,
    progress: &dyn Progress,
) -> Result<TangentialOutcome, RunFailure> {
    let job = &loaded.job;
    let failed = |e: TangentialError| RunFailure::from(&e);
    let mut runs = Sides::both(()).map(|_, ()| None);
    let mut flanks = BTreeMap::new();
    let mut warnings = Vec::new();
    let refereeing = Instant::now();
    for pass in &passes {
        let wanted = |flank: Flank, w: f64, z: f64| ready.wanted(flank, w, z);
        let task = task_of(job, &ready, &pass.flanks, &wanted, FitLimits::NAMED);
        let judged = task.judge(&pass.settings, result_grid(job)).map_err(failed)?;
        let radial = job.dressing.compare_radial.then(|| conventional(job, &ready, &pass.flanks));
        for of_flank in &judged {
            let flank = of_flank.flank;
            let run = run_flank(job, &ready, of_flank, pass, progress)?;
            let radial = radial.as_ref().map(|r| radial_feed(job, &ready, pass, flank, r, &run.target));
            warnings.extend(flank_warnings(of_flank));
            flanks.insert(flank.name(), flank_result(job, &ready, of_flank, &run, radial));
            runs[flank] = Some(run);
        }
        warnings.extend(pass.plan.as_ref().and_then(pass_warning));
    }
    timing.insert("referee", refereeing.elapsed().as_secs_f64());
    let lengths = worm_lengths(&passes, &runs);
    check_worm_width(job, &runs, &passes, lengths)?;
    warnings.extend(shared_pass_warning(&passes));
    let sensitivities = sensitivities(job, &ready, &passes).map_err(failed)?;
    let met = flanks.values().all(|f: &TangentialFlankResult| f.flank.tolerance_share <= 1.0);
    let status = if !flanks.is_empty() && met { Status::Met } else { Status::Missed };
    let reason = (status == Status::Missed).then(|| missed(job, &flanks, &passes));
    let result = TangentialResult {
        job: job.job.name.clone(),
        process: job.job.process.name().to_string(),
        version: env!("CARGO_PKG_VERSION"),
        status,
        tolerance_um: job.target.tolerance_um,
        reason,
        warnings,
        settings: settings_result(job, &ready, &passes, lengths),
        flanks,
        passes: passes.iter().filter_map(|p| p.plan.as_ref().map(pass_result)).collect(),
        sensitivities,
        timing_s: timing,
    };
    Ok(TangentialOutcome { result, prepared: ready, flanks: runs })
}

fn topography(judged: &Judged, f: Vec<f64>) -> Topography {
    Topography { w: judged.grid.w.clone(), z: judged.grid.z.clone(), f }
}

fn run_flank(
    job: &TangentialJob,
    ready: &TangentialPrepared,
    judged: &Judged,
    pass: &SettledPass,
    progress: &dyn Progress,
) -> Result<TangentialRun, RunFailure> {
    let failed = |e: TangentialError| RunFailure::from(&e);
    // Rays measure along the normal. A job that measures on the arc is proven there all the same: what the rays differ by from
    // the plan along the normals is added to the plan on the arcs.
    let along_normals =
        TangentialFlank::new(&ready.model, judged.flank, &pass.flanks, &pass.settings, Measure::Ray);
    let strokes = along_normals.strokes(&judged.points);
    let planned = topography(judged, judged.points.iter().map(|p| p.deviation).collect());
    let wanted = judged.points.iter().zip(&judged.error).map(|(p, e)| p.deviation - e).collect();
    let target = topography(judged, wanted);
    let refereed = referee(&along_normals, &strokes, &target, progress)?;
    let rays = &refereed.verdict.simulated;
    let (difference, simulated) = match measure_of(job) {
        Measure::Ray => (rays.minus(&planned), rays.clone()),
        Measure::Arc => {
            let normal = topography(judged, along_normals.deviations(&judged.grid).map_err(failed)?);
            let difference = rays.minus(&normal);
            let f = planned.f.iter().zip(&difference.f).map(|(p, d)| p + d).collect();
            (difference, Topography { f, ..planned.clone() })
        }
    };
    let (sample, lengths) = &refereed.sample;
    let grid = RollGrid { w: sample.w().to_vec(), z: sample.z().to_vec() };
    let at_sample = along_normals.deviations(&grid).map_err(failed)?;
    let sample_difference = lengths.iter().zip(&at_sample).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    Ok(TangentialRun {
        pass: pass.flanks.clone(),
        settings: pass.settings.clone(),
        strokes,
        target,
        planned,
        simulated,
        model_difference: difference.largest(),
        sample_difference,
        refereed,
    })
}

fn flank_result(
    job: &TangentialJob,
    ready: &TangentialPrepared,
    judged: &Judged,
    run: &TangentialRun,
    radial_feed: Option<RadialFeedResult>,
) -> TangentialFlankResult {
    let cos_b = ready.model.pair.work.flank(judged.flank).base_helix_angle.cos();
    let deviation = run.simulated.minus(&run.target);
    let largest = deviation.largest() * 1e3;
    TangentialFlankResult {
        flank: FlankResult {
            w_mm: run.target.w.clone(),
            z_mm: run.target.z.clone(),
            target_um: run.target.rows_um(),
            planned_um: run.planned.rows_um(),
            simulated_um: run.simulated.rows_um(),
            max_deviation_um: largest,
            tolerance_share: largest / job.target.tolerance_um,
            rms_deviation_um: deviation.rms() * 1e3,
            model_difference_um: run.model_difference * 1e3,
            referee_error_um: run.refereed.verdict.grinding.error_um,
            feed_mark_um: None,
            line_dressing: None,
            target_characteristics: CharacteristicsUm::of(&run.target, cos_b),
            simulated_characteristics: CharacteristicsUm::of(&run.simulated, cos_b),
            outside_class_um: 0.0,
            planned_between_um: None,
            least_determinant_ratio: judged.least_ratio(),
        },
        dresser_position_mm: run.strokes.positions,
        dressing_stroke_mm: run.strokes.dressing,
        feed_stroke_mm: run.strokes.feed,
        worm_occupation_mm: run.strokes.worm_faces,
        sample_difference_um: run.sample_difference * 1e3,
        sample_error_um: run.refereed.sample_error_um,
        radial_feed,
    }
}

/// Radial feed beside it: twist by formula and by contact, and the whole target as far as it goes.
fn radial_feed(
    job: &TangentialJob,
    ready: &TangentialPrepared,
    pass: &SettledPass,
    flank: Flank,
    fitted: &Result<(TangentialSettings, Fit), TangentialError>,
    target: &Topography,
) -> RadialFeedResult {
    let cos_b = ready.model.pair.work.flank(flank).base_helix_angle.cos();
    let crowning = CharacteristicsUm::of(target, cos_b).helix_crowning_um * cos_b * 1e-3;
    let plain = ready.model.radial_feed(flank, crowning, measure_of(job), FitGrid::Radii(5));
    let whole = fitted.as_ref().map_err(Clone::clone).and_then(|(settings, _)| {
        let ground = TangentialFlank::new(&ready.model, flank, &pass.flanks, settings, measure_of(job));
        let grid = RollGrid { w: target.w.clone(), z: target.z.clone() };
        Ok(Topography { f: ground.deviations(&grid)?, ..target.clone() }.minus(target))
    });
    let refused = plain.as_ref().err().or(whole.as_ref().err()).map(|error| Remark {
        code: error.code(),
        text: format!("radial feed cannot make this: {error}"),
        way_out: error.way_out().into(),
    });
    RadialFeedResult {
        lead_crowning_normal_um: crowning * 1e3,
        // The closed form counts material left, the product material removed.
        closed_twist_normal_um: -crowning * ready.model.natural_twist(flank) * 1e3,
        twist_normal_um: plain.ok().map(|r| -r.twist * 1e3),
        max_deviation_um: whole.as_ref().ok().map(|d| d.largest() * 1e3),
        deviation_um: whole.as_ref().ok().map(Topography::rows_um),
        refused,
    }
}

/// Ratio of the determinants below which the envelope is about to fold: the far branch cuts deeper than it (spec 40 section 3).
const NEAR_FOLD: f64 = 0.2;

fn flank_warnings(judged: &Judged) -> Option<Remark> {
    let ratio = judged.least_ratio();
    (ratio < NEAR_FOLD).then(|| Remark {
        code: "near-undercut",
        text: format!(
            "the {} flank is near its undercut: the determinant falls to {ratio:.3} of the unmodified one, and what lies beyond the fold may cut deeper",
            judged.flank
        ),
        way_out: "reduce the amount of the modification, or raise the form diameter".into(),
    })
}

fn pass_warning(plan: &PassPlan) -> Option<Remark> {
    (!plan.fit.converged).then(|| {
        let error = TangentialError::NotConverged {
            rounds: plan.fit.rounds_in_all,
            rms_um: plan.fit.weighted_rms * 1e3,
            best: plan.fit.values.clone(),
        };
        Remark { code: error.code(), text: error.to_string(), way_out: error.way_out().into() }
    })
}

/// What one pass for both flanks means (spec 40 section 5).
fn shared_pass_warning(passes: &[SettledPass]) -> Option<Remark> {
    let shared = passes.iter().find(|p| p.flanks.len() > 1)?;
    let against: Vec<String> = shared
        .settings
        .values()
        .iter()
        .filter(|(v, value)| *value != 0.0 && is_antisymmetric(v))
        .map(|(v, _)| v.to_string())
        .collect();
    (!against.is_empty()).then(|| Remark {
        code: "antisymmetric-variables",
        text: format!(
            "in one pass the even powers of {} crown one flank and hollow the other",
            against.join(", ")
        ),
        way_out: "crown both flanks by dA and dist, or give every flank a pass of its own".into(),
    })
}

/// Whether equal crownings of both flanks cannot come from it in one pass.
fn is_antisymmetric(variable: &Variable) -> bool {
    let even = matches!(variable.shape, Shape::Power(k) if k > 0 && k % 2 == 0);
    let across = matches!(
        variable.channel,
        Channel::TangentialShift | Channel::AxialOffset | Channel::WorkTurn | Channel::ToolShift
    );
    even && across
}

/// Worm length needed with a zone for every pass, and with the worm dressed again before every pass. mm.
fn worm_lengths(passes: &[SettledPass], runs: &Sides<Option<TangentialRun>>) -> [f64; 2] {
    let each = passes.iter().map(|pass| {
        let used = pass.flanks.iter().filter_map(|&f| runs[f].as_ref()).map(|run| run.strokes.worm_faces);
        let [from, to] =
            used.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], [from, to]| [a.min(from), b.max(to)]);
        to - from
    });
    each.fold([0.0, 0.0], |[sum, most], length| [sum + length, f64::max(most, length)])
}

fn check_worm_width(
    job: &TangentialJob,
    runs: &Sides<Option<TangentialRun>>,
    passes: &[SettledPass],
    [_, longest]: [f64; 2],
) -> Result<(), RunFailure> {
    let Some(width) = job.worm.width.filter(|&width| width < longest) else { return Ok(()) };
    let used: Vec<String> = runs
        .iter()
        .filter_map(|(flank, run)| {
            let [from, to] = run.as_ref()?.strokes.worm_faces;
            Some(format!("{flank} flank z_1 from {from:.2} to {to:.2} mm"))
        })
        .collect();
    let text = format!("the worm is too short: a pass needs {longest:.2} mm ({})", used.join(", "));
    let way_out = if passes.iter().any(|p| p.flanks.len() > 1) {
        "grind flank by flank (dressing.passes = \"each\"), or reduce grinding.shift_ratio"
    } else {
        "take a longer worm, or reduce grinding.shift_ratio"
    };
    let finding = Diagnostic::with_code("worm-too-short", text)
        .field("worm.width")
        .value(width)
        .allowed(format!("from {longest:.2} mm"))
        .way_out(way_out);
    Err(RunFailure::not_producible(finding))
}

fn missed(
    job: &TangentialJob,
    flanks: &BTreeMap<&'static str, TangentialFlankResult>,
    passes: &[SettledPass],
) -> Remark {
    let worst =
        flanks.iter().max_by(|a, b| a.1.flank.max_deviation_um.total_cmp(&b.1.flank.max_deviation_um));
    let text = worst.map_or("no flank is ground".to_string(), |(flank, f)| {
        format!(
            "the {flank} flank differs from the target by up to {:.4} um, {:.4} um are allowed",
            f.flank.max_deviation_um, job.target.tolerance_um
        )
    });
    let chosen = passes.iter().any(|p| p.plan.as_ref().is_some_and(|plan| plan.selection.is_some()));
    let way_out = if passes.iter().any(|p| p.flanks.len() > 1) {
        "grind flank by flank (dressing.passes = \"each\"), or try grinding.shift_ratio = \"neutral\""
    } else if chosen {
        "allow more variables (dressing.most_variables) or splines, or exclude fewer channels"
    } else {
        "let the plan choose the variables (dressing.variables = \"auto\"), or add powers and channels"
    };
    Remark { code: "target-missed", text, way_out: way_out.into() }
}

fn settings_result(
    job: &TangentialJob,
    ready: &TangentialPrepared,
    passes: &[SettledPass],
    [side_by_side, one_after_the_other]: [f64; 2],
) -> SettingsResult {
    let model = &ready.model;
    SettingsResult {
        settings: job_settings(job, ready, passes),
        centre_distance_mm: model.pair.chain.centre_distance,
        crossed_axes_angle_deg: model.pair.chain.crossed_axes_angle.to_degrees(),
        dressing_centre_distance_mm: model.chain.centre_distance,
        dressing_crossing_angle_deg: model.chain.crossing_angle.to_degrees(),
        screw_parameter_mm: model.chain.screw_parameter,
        shift_width_mm: model.input().shift_width,
        shift_ratio: model.shift_ratio,
        neutral_shift_ratio: model.neutral_ratio,
        contact_shift_offset_mm: Flank::BOTH.map(|f| (f.name(), model.lines[f].offset)).into(),
        worm_pitch_diameter_mm: 2.0 * model.pair.worm.pitch_radius(),
        dresser_pitch_diameter_mm: 2.0 * model.input().dresser_pitch_radius,
        worm_length_side_by_side_mm: side_by_side,
        worm_length_one_after_the_other_mm: one_after_the_other,
    }
}

fn job_settings(job: &TangentialJob, ready: &TangentialPrepared, passes: &[SettledPass]) -> JobSettings {
    let mut settings = JobSettings::default();
    for pass in passes {
        let values = settings_for_job(ready, pass);
        match (job.dressing.passes, pass.flanks.as_slice()) {
            (Passes::One, _) => settings.both = Some(values),
            (Passes::Each, [Flank::Left]) => settings.left = Some(values),
            (Passes::Each, _) => settings.right = Some(values),
        }
    }
    settings
}

fn pass_result(plan: &PassPlan) -> PassResult {
    let um = |x: f64| x * 1e3;
    let ends = [plan.fit.rounds.first(), plan.fit.rounds.last()];
    PassResult {
        flanks: plan.flanks.iter().map(|f| f.name()).collect(),
        variables: plan
            .free
            .iter()
            .zip(&plan.fit.values)
            .map(|(v, &value)| VariableValue {
                name: v.to_string(),
                value,
                unit: v.channel.unit(),
                meaning: v.channel.meaning(),
            })
            .collect(),
        method: plan.fit.method.name(),
        steps: plan.fit.steps,
        rounds: plan.fit.rounds_in_all,
        converged: plan.fit.converged,
        weighted_rms_um: um(plan.fit.weighted_rms),
        largest_um: um(plan.fit.largest),
        weighted_rms_by_round_um: plan.fit.rounds.iter().map(|r| um(r.weighted_rms)).collect(),
        singular_values: ends.into_iter().flatten().map(|r| r.singular_values.clone()).collect(),
        choice: plan
            .selection
            .iter()
            .flat_map(|s| &s.steps)
            .map(|s| ChoiceStep {
                variable: s.variable.to_string(),
                taken: s.taken,
                largest_um: um(s.largest),
                count: s.count,
            })
            .collect(),
        compared: plan
            .compared
            .iter()
            .map(|tried| {
                let fit = tried.outcome.as_ref().ok();
                MethodResult {
                    method: tried.method.name(),
                    steps: tried.steps,
                    rounds: fit.map(|(f, _)| f.rounds_in_all),
                    converged: fit.map(|(f, _)| f.converged),
                    weighted_rms_um: fit.map(|(f, _)| um(f.weighted_rms)),
                    largest_um: fit.map(|(_, largest)| um(*largest)),
                    refused: tried.outcome.as_ref().err().map(|e| Remark {
                        code: e.code(),
                        text: e.to_string(),
                        way_out: e.way_out().into(),
                    }),
                }
            })
            .collect(),
    }
}

/// The nine variables of the source, whose topographies every report shows (its table 3).
const SOURCE_VARIABLES: [(Channel, u32); 9] = [
    (Channel::Profile(None), 1),
    (Channel::Profile(None), 2),
    (Channel::Profile(None), 3),
    (Channel::TangentialShift, 2),
    (Channel::TangentialShift, 3),
    (Channel::CrossedAxesAngle, 0),
    (Channel::CentreDistance, 0),
    (Channel::WorkTurn, 2),
    (Channel::WorkTurn, 3),
];

/// Points of a sensitivity topography each way.
const SENSITIVITY_POINTS: usize = 11;

/// Derivatives of the unmodified flank by the variables of the source and those that the passes use.
fn sensitivities(
    job: &TangentialJob,
    ready: &TangentialPrepared,
    passes: &[SettledPass],
) -> Result<Vec<SensitivityResult>, TangentialError> {
    let mut all = Vec::new();
    for pass in passes {
        let mut variables: Vec<Variable> = SOURCE_VARIABLES.map(|(c, k)| Variable::power(c, k)).into();
        let used = pass.settings.values().iter().map(|(v, _)| v);
        for variable in used.filter(|v| matches!(v.shape, Shape::Power(_))) {
            if !variables.contains(variable) {
                variables.push(variable.clone());
            }
        }
        for &flank in &pass.flanks {
            let settings = TangentialSettings::default();
            let plain = TangentialFlank::new(&ready.model, flank, &pass.flanks, &settings, measure_of(job));
            let grid = FitGrid::Radii(SENSITIVITY_POINTS).of(&ready.model, flank);
            let (_, by) = plain.linearised(&grid, &variables)?;
            let columns = grid.z.len();
            for (j, variable) in variables.iter().enumerate().filter(|(_, v)| v.channel.concerns(flank)) {
                let angle = variable.channel == Channel::DressingAngle;
                let values = (0..grid.w.len())
                    .map(|i| (0..columns).map(|k| by[(i * columns + k, j)]).collect())
                    .collect();
                all.push(SensitivityResult {
                    flank: flank.name(),
                    variable: variable.to_string(),
                    // mm per rad are um per mrad.
                    unit: if angle { "um/mrad" } else { "um/um" },
                    w_mm: grid.w.clone(),
                    z_mm: grid.z.clone(),
                    values,
                });
            }
        }
    }
    Ok(all)
}
