//! Planning of tangential dressing: per pass which variables, which values, and what else was tried. Knows no referee.

use super::finding;
use super::prepare::{TangentialPrepared, channel_of, measure_of, variable_of, weights_of};
use crate::job::{FitMethod as JobMethod, FitWeights, TangentialJob, VariableRule, Variables};
use crate::{
    Channel, Fit, FitGrid, FitLimits, FitMethod, FitTask, Selection, SelectionTask, TangentialError,
    TangentialSettings, Variable,
};
use foundation::geometry::Flank;
use foundation::numerics::Progress;
use run::RunFailure;

/// One pass as planned.
pub struct PassPlan {
    /// Flanks ground together.
    pub flanks: Vec<Flank>,
    /// All values, of free and fixed variables.
    pub settings: TangentialSettings,
    /// The free variables.
    pub free: Vec<Variable>,
    /// How they were chosen, if the plan chose.
    pub selection: Option<Selection>,
    /// The fit whose values were taken.
    pub fit: Fit,
    /// All methods beside each other, if the job asks.
    pub compared: Vec<MethodTried>,
}

/// A method of fitting and its result.
pub struct MethodTried {
    /// The method.
    pub method: FitMethod,
    /// Parts in which the target was stepped up.
    pub steps: usize,
    /// The fit and its largest error between the points, mm; or why there is none.
    pub outcome: Result<(Fit, f64), TangentialError>,
}

/// A fit that takes more trouble has to be better by this share.
const WORTH_MORE: f64 = 0.01;

/// The task of a pass.
pub fn task_of<'a>(
    job: &TangentialJob,
    ready: &'a TangentialPrepared,
    pass: &'a [Flank],
    wanted: &'a (dyn Fn(Flank, f64, f64) -> f64 + Sync),
    limits: FitLimits,
) -> FitTask<'a> {
    FitTask {
        model: &ready.model,
        pass,
        wanted,
        fixed: TangentialSettings::default(),
        measure: measure_of(job),
        grid: match job.dressing.weights {
            FitWeights::Uniform => FitGrid::Graded(job.dressing.fit_points),
            FitWeights::Source => FitGrid::Radii(job.dressing.fit_points),
        },
        weights: weights_of(job),
        limits,
    }
}

/// The grid of the result.
pub fn result_grid(job: &TangentialJob) -> FitGrid {
    FitGrid::Equidistant(job.grid.profile_points, job.grid.helix_points)
}

/// Plans a pass.
///
/// # Errors
/// [`RunFailure`] with a finding on the key concerned.
pub fn plan_pass(
    job: &TangentialJob,
    ready: &TangentialPrepared,
    pass: &[Flank],
    progress: &dyn Progress,
) -> Result<PassPlan, RunFailure> {
    let wanted = |flank: Flank, w: f64, z: f64| ready.wanted(flank, w, z);
    let failed = |e: TangentialError| RunFailure::from(&e);
    let splines = spline_variables(job, ready, pass)?;
    let named = job.dressing.variables.named();
    let limits = match &job.dressing.variables {
        Variables::Rule(VariableRule::Source) => FitLimits::SOURCE,
        Variables::Rule(VariableRule::Auto) | Variables::List(_) => FitLimits::STEADY,
    };
    let task = task_of(job, ready, pass, &wanted, limits);
    progress.start("fitting", 1);
    let (free, start, selection) = match named {
        Some(list) => {
            let mut free = list
                .iter()
                .enumerate()
                .map(|(i, &v)| variable_of(v, &format!("dressing.variables[{i}]")))
                .collect::<Result<Vec<_>, _>>()?;
            free.extend(splines);
            let start = vec![0.0; free.len()];
            (free, start, None)
        }
        None => {
            let excluded = job
                .dressing
                .exclude
                .iter()
                .enumerate()
                .map(|(i, &c)| channel_of(c, &format!("dressing.exclude[{i}]")))
                .collect::<Result<Vec<_>, _>>()?;
            let mut candidates = SelectionTask::standard_candidates(pass.len() > 1, &excluded);
            candidates.extend(splines);
            let selection = task
                .select(&SelectionTask {
                    candidates,
                    tolerance: job.target.tolerance_um * 1e-3,
                    most: job.dressing.most_variables,
                    judged_on: result_grid(job),
                })
                .map_err(failed)?;
            (selection.variables.clone(), selection.values.clone(), Some(selection))
        }
    };
    let (fit, compared) = if free.is_empty() {
        // The flank is what is wanted without any of them.
        (nothing_to_fit(), Vec::new())
    } else {
        let fit = best_fit(job, &task, &free, &start).map_err(failed)?;
        let compared = if job.dressing.compare_methods { compare(job, &task, &free) } else { Vec::new() };
        (fit, compared)
    };
    progress.advance(1);
    progress.finish();
    let settings = task.fixed.with(&free, &fit.values);
    Ok(PassPlan { flanks: pass.to_vec(), settings, free, selection, fit, compared })
}

fn nothing_to_fit() -> Fit {
    Fit {
        method: FitMethod::Plain,
        steps: 1,
        values: Vec::new(),
        weighted_rms: 0.0,
        largest: 0.0,
        rounds: Vec::new(),
        rounds_in_all: 0,
        converged: true,
    }
}

/// Coefficients of the splines that the job asks for.
fn spline_variables(
    job: &TangentialJob,
    ready: &TangentialPrepared,
    pass: &[Flank],
) -> Result<Vec<Variable>, RunFailure> {
    let mut all = Vec::new();
    for (i, spline) in job.dressing.splines.iter().enumerate() {
        let field = format!("dressing.splines[{i}]");
        let channel = channel_of(spline.channel, &field)?;
        all.extend(
            Variable::spline(channel, spline.intervals, ready.model.spline_range(channel, pass))
                .map_err(|e| finding::on_field(&e, &field))?,
        );
    }
    Ok(all)
}

/// Methods and steps that a job allows.
fn ways(job: &TangentialJob) -> Vec<(FitMethod, usize)> {
    let steps = job.dressing.steps;
    let methods = match job.dressing.method {
        JobMethod::Auto => FitMethod::ALL.to_vec(),
        JobMethod::Svd => vec![FitMethod::Plain],
        JobMethod::Damped => vec![FitMethod::Damped],
        JobMethod::GaussNewton => vec![FitMethod::GaussNewton],
    };
    let stepped: &[usize] = if steps > 1 { &[1, steps] } else { &[1] };
    stepped.iter().flat_map(|&n| methods.iter().map(move |&m| (m, n))).collect()
}

/// The fit of least weighted error among the ways that the job allows; more trouble is taken, stepping last, as long as no fit has
/// settled within the tolerance, or is within half of it. What a selection found is taken further from where it is.
fn best_fit(
    job: &TangentialJob,
    task: &FitTask<'_>,
    free: &[Variable],
    start: &[f64],
) -> Result<Fit, TangentialError> {
    let tolerance = job.target.tolerance_um * 1e-3;
    let mut best: Option<Fit> = None;
    let mut refused = None;
    for (method, steps) in ways(job) {
        let enough = |b: &Fit| b.largest <= if b.converged { tolerance } else { 0.5 * tolerance };
        if best.as_ref().is_some_and(enough) {
            break;
        }
        let zero = vec![0.0; free.len()];
        match task.fit_in_steps(free, if steps > 1 { &zero } else { start }, method, steps) {
            Ok(fit)
                if best.as_ref().is_none_or(|b| fit.weighted_rms < b.weighted_rms * (1.0 - WORTH_MORE)) =>
            {
                best = Some(fit);
            }
            Ok(_) => {}
            Err(error) => refused = Some(error),
        }
    }
    match (best, refused) {
        (Some(fit), _) => Ok(fit),
        (None, Some(error)) => Err(error),
        (None, None) => Err(TangentialError::NoLiveVariable { count: free.len() }),
    }
}

/// Every method straight there and stepped, from nothing.
fn compare(job: &TangentialJob, task: &FitTask<'_>, free: &[Variable]) -> Vec<MethodTried> {
    let zero = vec![0.0; free.len()];
    let steps: &[usize] = if job.dressing.steps > 1 { &[1, job.dressing.steps] } else { &[1] };
    let each = FitMethod::ALL.into_iter().flat_map(|m| steps.iter().map(move |&n| (m, n)));
    each.map(|(method, steps)| {
        let outcome = task.fit_in_steps(free, &zero, method, steps).and_then(|fit| {
            let judged = task.judge(&task.fixed.with(free, &fit.values), result_grid(job))?;
            let largest = judged.iter().map(|j| j.largest()).fold(0.0, f64::max);
            Ok((fit, largest))
        });
        MethodTried { method, steps, outcome }
    })
    .collect()
}

/// What conventional grinding makes of the same target: a plain worm that does not shift, the profile in the dresser, the centre
/// distance over the feed.
///
/// # Errors
/// [`TangentialError`], most of all `Undercut`.
pub fn conventional(
    job: &TangentialJob,
    ready: &TangentialPrepared,
    pass: &[Flank],
) -> Result<(TangentialSettings, Fit), TangentialError> {
    let wanted = |flank: Flank, w: f64, z: f64| ready.wanted(flank, w, z);
    let mut task = task_of(job, ready, pass, &wanted, FitLimits::STEADY);
    task.fixed.set(&Variable::shift_ratio(), -ready.model.shift_ratio);
    task.fixed.set(&Variable::power(Channel::ToolShift, 0), -ready.model.shift_offset(pass));
    let profile = (1..=4).map(|k| Variable::power(Channel::Profile(None), k));
    let distance = [0, 2].map(|k| Variable::power(Channel::CentreDistance, k));
    let free: Vec<Variable> = profile.chain(distance).collect();
    let fit = task.fit(&free, &vec![0.0; free.len()], FitMethod::Plain)?;
    Ok((task.fixed.with(&free, &fit.values), fit))
}
