//! Plans by a best fit to the whole target (`docs/mathematics/best-fit.md`), for targets that the closed decomposition misses or refuses.

mod between;
mod carrying;
mod fitted;
mod rounds;
mod trials;

use super::best_fit::{BestFitTask, Expected, NEAR, Within};
use super::plan::PlanTask;
use super::ratio::NoPlan;
use super::{
    Effort, GeneratingError, GrindingPlan, LeastDeviation, PlanGauge, PlanningGrid, Prefer, ProfilePlace,
    Tool,
};
use between::between;
use fitted::narrower;
use foundation::geometry::{Flank, Sides};
use std::cell::Cell;
use trials::{Dressed, Failed, FittedPlan, Manner, Trials};

/// Points over profile and face width of the fit, and intervals of its functions over the flank.
const FIT_GRID: [usize; 2] = [21, 41];
const FIT_INTERVALS: usize = 24;
/// The same where ratios are compared.
const SCAN_GRID: [usize; 2] = [9, 25];
const SCAN_INTERVALS: usize = 12;
/// Factor between ratios of one sign that are carried out, where they are expected to cost no more than this.
const APART: f64 = 1.9;
const APART_UP_TO: f64 = 0.4;
/// Ratios that are carried out, at most.
const CARRIED_OUT: usize = 6;
/// Share of the tolerance within which commands are smooth in the end where accuracy is preferred.
const ACCURATELY_NEAR: f64 = 0.02;
/// A round ends the correction at this share of the tolerance beyond that.
const SETTLED: f64 = 0.05;
/// A plan below this share of the tolerance needs no further ratio.
const GOOD: f64 = 0.5;
/// From so many ratios on this share is enough.
const SOUGHT: usize = 3;
const WITHIN: f64 = 0.9;
/// Fits of one ratio with narrower limits, at most.
const RETRIES: usize = 2;
/// A plan within so many tolerances is nearly one; ratios about its own that are tried then, as factors.
const NEARLY: f64 = 2.5;
const NEIGHBOURS: [f64; 4] = [1.04, 0.96, 1.1, 0.9];
/// Ratios between these that are carried out where all of them miss, at most.
const BETWEEN: usize = 10;
/// What is missed by more than so many tolerances no ratio between makes.
const WORTH_MORE: f64 = 5.0;
/// A fit that leaves more than this of what an unmodified flank would is hardly one.
const OF_UNMODIFIED: f64 = 0.5;
/// So many of those that were not dressed are dressed after all where there is no plan, the most promising first, until one is.
const DRESSED_AT_LAST: usize = 6;

/// A fit without a tool.
struct Waiting {
    left: f64,
    ratio: f64,
    within: Within,
}

/// Ratios that are expected to serve, the best first.
struct Ratios<'t> {
    known: Vec<Expected>,
    /// What tells more of them, where only few were looked at.
    scan: Option<BestFitTask<'t>>,
}

impl Ratios<'_> {
    /// The next one that was not tried. What one cannot do that was expected to be easy its neighbours hardly can.
    fn next(&self, tried: &[f64]) -> Option<f64> {
        let next = |expected: &&Expected| {
            let apart = |other: &f64| far_apart(expected.ratio, *other);
            let new = |other: &f64| expected.ratio != *other;
            if expected.cost <= APART_UP_TO { tried.iter().all(apart) } else { tried.iter().all(new) }
        };
        Some(self.known.iter().find(next)?.ratio)
    }

    /// Compares all; false where that was done.
    fn compare(&mut self, prefer: Prefer) -> bool {
        let Some(scan) = self.scan.take() else { return false };
        self.known = scan.ratios(prefer);
        true
    }
}

/// Whether two ratios are so far apart that one may do what the other cannot.
fn far_apart(a: f64, b: f64) -> bool {
    a * b < 0.0 || a.abs().max(b.abs()) > APART * a.abs().min(b.abs())
}

impl PlanTask<'_> {
    /// Whether the best fit knows the bodies and rules of this task.
    pub(super) fn may_be_fitted(&self) -> bool {
        matches!(self.setup.tool, Tool::Dressed(_))
            && self.setup.strokes.is_none()
            && self.law.is_none()
            && self.gauge == PlanGauge::Centred
            && !self.dressing.of_both_flanks()
            && self.targets.iter().all(|(_, target)| target.as_ref().is_none_or(|t| t.moved.is_none()))
            && (self.precompensation || self.keeps_natural_twist() && !self.is_smooth())
            && Flank::BOTH.into_iter().all(|flank| self.setup.lines[flank].is_cylindrical())
            && self.setup.pair.worm.is_cylindrical()
            && self.setup.pair.work.is_cylindrical()
            && !(self.free_dresser && self.places.first() != Some(&ProfilePlace::Dresser))
    }

    /// Whether the twist that a feed without shift leaves stays: nothing of the traces in the middle is given up for it.
    fn keeps_natural_twist(&self) -> bool {
        self.ratio == Some(0.0) && !self.precompensation
    }

    /// Shares of the tolerance within which commands are smooth, one after the other: from a smooth one near the target a nearer one is found.
    fn nears(&self) -> &'static [f64] {
        if self.prefer == Prefer::Accuracy { &[NEAR, ACCURATELY_NEAR] } else { &[NEAR] }
    }

    /// Share of the tolerance at which a plan is as near as it is wanted.
    pub(super) fn settled_at(&self) -> f64 {
        self.nears().last().copied().unwrap_or(NEAR) + SETTLED
    }

    /// What fits on a grid are asked for, with functions of so many intervals over the flank; `None` where a target has no value there.
    fn fit_task<'g>(&'g self, grid: (&'g PlanningGrid, usize), within: Within) -> Option<BestFitTask<'g>> {
        let asked = (&self.targets, self.tolerance_map.as_ref(), self.keeps_natural_twist());
        BestFitTask::new(self.setup, asked, grid, (self.free_dresser, self.dressing), within).ok()
    }

    /// The best plan by fits at some ratios; `None` where none can be carried out. `ruled` is what the rules came to.
    pub(super) fn plan_by_fit(&self, ruled: &Result<GrindingPlan, Box<NoPlan>>) -> Option<GrindingPlan> {
        let first = Within::new(self.tolerance, self.limits);
        let fits = |grid| self.fit_task(grid, first);
        let coarse = PlanningGrid::new(self.setup, SCAN_GRID[0], SCAN_GRID[1]);
        // All are compared where the first one, found with few, is not enough.
        let mut ratios = match self.ratio {
            Some(ratio) => Ratios { known: vec![Expected { ratio, cost: 0.0 }], scan: None },
            None => {
                let scan = fits((&coarse, SCAN_INTERVALS))?;
                Ratios { known: scan.easiest(self.prefer).into_iter().collect(), scan: Some(scan) }
            }
        };
        let grid = PlanningGrid::new(self.setup, FIT_GRID[0], FIT_GRID[1]).closer_at_ends();
        let task = fits((&grid, FIT_INTERVALS))?;
        let trials = |manner: Manner| Trials {
            grid: &grid,
            ruled,
            manner,
            rounds: Cell::new(0),
            rounds_in_all: self.effort.rounds(),
        };
        if let Effort::Further(near) = self.effort {
            ratios.compare(self.prefer);
            let all = ratios.known.iter().map(|expected| expected.ratio);
            let mut ratios: Vec<f64> = all.take(CARRIED_OUT).collect();
            if self.ratio.is_none() && !ratios.contains(&0.0) {
                ratios.push(0.0);
            }
            return self.further(&trials(Manner::Near), &ratios, near);
        }
        let manners = if self.effort == Effort::Trial { &Manner::ALL[..1] } else { &Manner::ALL };
        let (mut best, mut tried): (Option<FittedPlan>, Vec<f64>) = (None, Vec::new());
        for &manner in manners {
            let (found, carried_out) = self.sought(&task, &trials(manner), &mut ratios);
            best = best.into_iter().chain(found).min_by(|a, b| a.strain.total_cmp(&b.strain));
            tried = carried_out;
            if best.as_ref().is_some_and(|known| known.strain <= self.tolerance) {
                break;
            }
        }
        let near = |known: &FittedPlan| known.strain <= WORTH_MORE * self.tolerance;
        if self.effort == Effort::Full && self.ratio.is_none() && best.as_ref().is_none_or(near) {
            let scan = fits((&coarse, SCAN_INTERVALS))?;
            best = self.sought_between(
                &task,
                &trials(Manner::Near),
                between(&scan, &ratios.known, &tried),
                best,
            );
        }
        let best = best.map(|best| best.plan);
        let worth = |known: &GrindingPlan| self.deviation(known) <= OF_UNMODIFIED * self.unmodified(known);
        if self.effort == Effort::Trial || best.as_ref().is_some_and(worth) {
            return best;
        }
        // None that is worth it can be carried out: what is less near to the target is easier to make, and without shift the worm needs no
        // corrections.
        if self.ratio.is_none() && !tried.contains(&0.0) {
            tried.push(0.0);
        }
        let trials = trials(Manner::Near);
        let further = Effort::FURTHER.into_iter().find_map(|near| self.further(&trials, &tried, near));
        best.into_iter().chain(further).min_by(|a, b| self.deviation(a).total_cmp(&self.deviation(b)))
    }

    /// The best plan in one manner, with the ratios that were carried out; `None` where none can be.
    fn sought(
        &self,
        task: &BestFitTask<'_>,
        trials: &Trials<'_>,
        ratios: &mut Ratios<'_>,
    ) -> (Option<FittedPlan>, Vec<f64>) {
        let mut best: Option<FittedPlan> = None;
        let mut waiting: Vec<Waiting> = Vec::new();
        let nearly = |best: &Option<FittedPlan>| {
            let allowed = |known: &FittedPlan| if known.folds { 2.0 } else { 1.0 } * self.tolerance;
            best.as_ref().is_some_and(|known| known.strain <= allowed(known))
        };
        let mut tried: Vec<f64> = Vec::new();
        while tried.len() < CARRIED_OUT && !trials.are_over(nearly(&best)) {
            let Some(ratio) = ratios.next(&tried) else {
                if ratios.compare(self.prefer) {
                    continue;
                }
                break;
            };
            tried.push(ratio);
            // Where a plan within the tolerance is known, another ratio is worth one fit.
            let known = best.as_ref().is_some_and(|known| known.strain <= WITHIN * self.tolerance);
            let retries = match known {
                true => 0,
                false if tried.len() <= SOUGHT => RETRIES,
                false => 1,
            };
            let over = || trials.are_over(nearly(&best));
            let Some(fitted) = self.fitted_within(task, trials, (ratio, retries), over, &mut waiting) else {
                continue;
            };
            if best.as_ref().is_none_or(|known| fitted.strain < known.strain) {
                best = Some(fitted);
            }
            let enough = match self.prefer {
                Prefer::Accuracy => self.settled_at(),
                Prefer::Worm | Prefer::Time if tried.len() < SOUGHT => GOOD,
                Prefer::Worm | Prefer::Time => WITHIN,
            };
            if best.as_ref().is_some_and(|known| known.strain <= enough * self.tolerance) {
                break;
            }
        }
        if let (Some(known), None) = (&mut best, self.ratio)
            && known.strain > WITHIN * self.tolerance
            && known.strain <= NEARLY * self.tolerance
        {
            // What is missed by little a neighbour may make.
            let about = known.plan.choice.ratio;
            for by in NEIGHBOURS {
                if known.strain <= WITHIN * self.tolerance || trials.are_over(true) {
                    break;
                }
                if let Ok(fitted) = self.fitted_at(task, trials, by * about, Dressed::Promising)
                    && fitted.strain < known.strain
                {
                    *known = fitted;
                }
            }
        }
        if best.is_none() {
            waiting.sort_by(|a, b| a.left.total_cmp(&b.left));
            best = waiting.iter().take(DRESSED_AT_LAST).find_map(|of| {
                let task = self.fit_task((trials.grid, FIT_INTERVALS), of.within)?;
                self.fitted_at(&task, trials, of.ratio, Dressed::Each).ok()
            });
        }
        (best, tried)
    }

    /// The best plan of those known and at further ratios, which are tried until one meets the tolerance.
    fn sought_between(
        &self,
        task: &BestFitTask<'_>,
        trials: &Trials<'_>,
        ratios: Vec<f64>,
        mut best: Option<FittedPlan>,
    ) -> Option<FittedPlan> {
        for ratio in ratios.into_iter().take(BETWEEN) {
            let met =
                |best: &Option<FittedPlan>| best.as_ref().is_some_and(|known| known.strain <= self.tolerance);
            if met(&best) || trials.are_over(false) {
                break;
            }
            let over = || trials.are_over(false);
            let found = self.fitted_within(task, trials, (ratio, 1), over, &mut Vec::new());
            best = best.into_iter().chain(found).min_by(|a, b| a.strain.total_cmp(&b.strain));
        }
        best
    }

    /// The best fit at a ratio, made again with narrower limits where one is to blame, up to `retries` times.
    fn fitted_within(
        &self,
        task: &BestFitTask<'_>,
        trials: &Trials<'_>,
        (ratio, retries): (f64, usize),
        over: impl Fn() -> bool,
        waiting: &mut Vec<Waiting>,
    ) -> Option<FittedPlan> {
        let mut wait = |fitted: &Result<FittedPlan, Failed>, within: Within| {
            if let Err(Failed { left: Some(left), .. }) = fitted {
                waiting.push(Waiting { left: *left, ratio, within });
            }
        };
        let mut within = task.within();
        let mut fitted = self.fitted_at(task, trials, ratio, Dressed::Promising);
        wait(&fitted, within);
        for _ in 0..retries {
            let narrower = match &fitted {
                Err(failed) => narrower(&failed.error, within),
                Ok(fitted) if fitted.folds && !within.closely => Some(Within { closely: true, ..within }),
                Ok(_) => None,
            };
            let Some(narrower) = narrower.filter(|_| !over()) else { break };
            let Some(task) = self.fit_task((trials.grid, FIT_INTERVALS), narrower) else { break };
            within = narrower;
            let again = self.fitted_at(&task, trials, ratio, Dressed::Promising);
            wait(&again, within);
            fitted = match (fitted, again) {
                (Ok(known), Ok(again)) if known.strain <= again.strain => Ok(known),
                (Ok(known), Err(_)) => Ok(known),
                (_, again) => again,
            };
        }
        fitted.ok()
    }

    /// The best plan at some ratios whose command stays within so many tolerances; `None` where none can be carried out.
    fn further(&self, trials: &Trials<'_>, ratios: &[f64], near: f64) -> Option<GrindingPlan> {
        let first = Within::new(self.tolerance, self.limits);
        let within = Within { tolerance: near * self.tolerance, on_worm: true, ..first };
        let task = self.fit_task((trials.grid, FIT_INTERVALS), within)?;
        let fitted = |&ratio: &f64| Some(self.fitted_at(&task, trials, ratio, Dressed::Each).ok()?.plan);
        let plans = ratios.iter().filter_map(fitted);
        plans.min_by(|a, b| self.deviation(a).total_cmp(&self.deviation(b)))
    }

    /// How near any flank of the class comes to the target, for a plan that misses it. `None` where no programme tells.
    pub(super) fn least_deviation(&self, plan: &GrindingPlan) -> Option<LeastDeviation> {
        let grid = PlanningGrid::new(self.setup, SCAN_GRID[0], SCAN_GRID[1]);
        let task = self.fit_task((&grid, FIT_INTERVALS), Within::new(self.tolerance, self.limits))?;
        let least = task.least(self.ratio, self.least_determinant)?;
        let ground = Sides::try_from_fn(|flank| {
            let Some(made) = &plan.flanks[flank] else { return Ok(None) };
            let cos = self.setup.lines[flank].cos_b2;
            let contacts = made.tool.ground(self.setup, flank, &grid, &plan.ideal.motion)?;
            Ok::<_, GeneratingError>(Some(contacts.iter().map(|at| at.f_n / cos).collect()))
        });
        let beyond_class = task.beyond_class(plan.choice.ratio, &ground.ok()?)?;
        let normal = |share: f64| share * self.tolerance;
        Some(LeastDeviation {
            ratio: least.ratio,
            first_order: normal(least.all),
            beyond_class: normal(beyond_class),
            without_axes: normal(least.without_axes),
            without_envelope: normal(least.without_envelope),
        })
    }
}
