//! Planning of tangential dressing: per pass which variables, which values, and what else was tried. Knows no referee.

use super::prepare::{Choice, FitRules, TangentialPrepared};
use crate::{
    Channel, Fit, FitLimits, FitMethod, FitTask, Selection, SelectionTask, TangentialError,
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
    ready: &'a TangentialPrepared,
    pass: &'a [Flank],
    wanted: &'a (dyn Fn(Flank, f64, f64) -> f64 + Sync),
    limits: FitLimits,
) -> FitTask<'a> {
    let FitRules { measure, grid, weights, .. } = ready.rules;
    let fixed = TangentialSettings::default();
    FitTask { model: &ready.model, pass, wanted, fixed, measure, grid, weights, limits }
}

/// Plans a pass.
///
/// # Errors
/// [`RunFailure`] with a finding on the key concerned.
pub fn plan_pass(
    ready: &TangentialPrepared,
    pass: &[Flank],
    progress: &dyn Progress,
) -> Result<PassPlan, RunFailure> {
    let wanted = |flank: Flank, w: f64, z: f64| ready.wanted(flank, w, z);
    let failed = |e: TangentialError| RunFailure::from(&e);
    let rules = &ready.rules;
    let splines = rules.spline_variables(&ready.model, pass)?;
    let task = task_of(ready, pass, &wanted, rules.limits);
    progress.start("fitting", 1);
    let (free, start, selection) = match &rules.choice {
        Choice::Given(list) => {
            let free: Vec<Variable> = list.iter().cloned().chain(splines).collect();
            let start = vec![0.0; free.len()];
            (free, start, None)
        }
        Choice::Chosen { excluded, most } => {
            let mut candidates = SelectionTask::standard_candidates(pass.len() > 1, excluded);
            if ready.dresser_exists {
                let settling = SelectionTask::settling_candidates(excluded);
                candidates
                    .extend(settling.into_iter().filter(|v| !candidates.contains(v)).collect::<Vec<_>>());
            }
            candidates.extend(splines);
            let selection = task
                .select(&SelectionTask {
                    candidates,
                    tolerance: ready.tolerance(),
                    most: *most,
                    judged_on: rules.judged_on,
                })
                .map_err(failed)?;
            (selection.variables.clone(), selection.values.clone(), Some(selection))
        }
    };
    let (fit, compared) = if free.is_empty() {
        // The flank is what is wanted without any of them.
        (nothing_to_fit(), Vec::new())
    } else {
        let fit = best_fit(ready, &task, &free, &start).map_err(failed)?;
        let compared = if rules.compare_methods { compare(rules, &task, &free) } else { Vec::new() };
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

/// The fit of least weighted error among the ways that the job allows; more trouble is taken, stepping last, as long as no fit has
/// settled within the tolerance, or is within half of it. What a selection found is taken further from where it is.
fn best_fit(
    ready: &TangentialPrepared,
    task: &FitTask<'_>,
    free: &[Variable],
    start: &[f64],
) -> Result<Fit, TangentialError> {
    let (rules, tolerance) = (&ready.rules, ready.tolerance());
    let ways = rules.ways_there().into_iter().flat_map(|n| rules.methods.iter().map(move |&m| (m, n)));
    let mut best: Option<Fit> = None;
    let mut refused = None;
    for (method, steps) in ways {
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
fn compare(rules: &FitRules, task: &FitTask<'_>, free: &[Variable]) -> Vec<MethodTried> {
    let zero = vec![0.0; free.len()];
    let each = FitMethod::ALL.into_iter().flat_map(|m| rules.ways_there().into_iter().map(move |n| (m, n)));
    each.map(|(method, steps)| {
        let outcome = task.fit_in_steps(free, &zero, method, steps).and_then(|fit| {
            let judged = task.judge(&task.fixed.with(free, &fit.values), rules.judged_on)?;
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
    ready: &TangentialPrepared,
    pass: &[Flank],
) -> Result<(TangentialSettings, Fit), TangentialError> {
    let wanted = |flank: Flank, w: f64, z: f64| ready.wanted(flank, w, z);
    let mut task = task_of(ready, pass, &wanted, FitLimits::STEADY);
    task.fixed.set(&Variable::shift_ratio(), -ready.model.shift_ratio);
    task.fixed.set(&Variable::power(Channel::ToolShift, 0), -ready.model.shift_offset(pass));
    // A dresser that exists has the profile that it has.
    let powers = if ready.dresser_exists { 0 } else { 4 };
    let profile = (1..=powers).map(|k| Variable::power(Channel::Profile(None), k));
    let distance = [0, 2].map(|k| Variable::power(Channel::CentreDistance, k));
    let free: Vec<Variable> = profile.chain(distance).collect();
    let fit = task.fit(&free, &vec![0.0; free.len()], FitMethod::Plain)?;
    Ok((task.fixed.with(&free, &fit.values), fit))
}
