//! Plans by a best fit to the whole target (`docs/mathematics/best-fit.md`), for targets that the closed decomposition misses or refuses.

use super::best_fit::{BestFit, BestFitTask, Contact, Contacts, Expected, NEAR, Step, Within};
use super::dressed::{DRESSING_MARGIN, finished_rolls};
use super::plan::{Equipped, LARGEST_DRESSING_MARGIN, PlanTask, Records};
use super::planning_grid::GroundError;
use super::ratio::{CORRECTION_AXES, Candidate, FlankResidual, NoPlan, RatioChoice, RatioReason};
use super::{
    DressingRows, FeedLaw, GeneratingError, GrindingPlan, IdealPlan, LeastDeviation, PlanGauge, PlannedTool,
    PlanningGrid, Prefer, ProfilePlace, ProfilePolicy, SeriesRule, Tool,
};
use contact::{ContactError, ModifiedThread};
use foundation::geometry::{Flank, Sides};
use std::cell::Cell;

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
/// Rounds of correction with the ideal worm, and with the worm as dressed.
const ROUNDS: usize = 12;
const DRESSED_ROUNDS: usize = 4;
/// Share of the tolerance within which commands are smooth in the end where accuracy is preferred.
const ACCURATELY_NEAR: f64 = 0.02;
/// A round ends the correction at this share of the tolerance beyond that.
const SETTLED: f64 = 0.05;
/// Price of moving the contact, what it grows by where a round does not come nearer, and falls by where it does; rounds that do not or hardly,
/// one after the other, at most, and where a plan is good already; the largest price; and the share of the last distance below which a round within the tolerance is worth another.
const HOLD: f64 = 10.0;
const TIGHTER: f64 = 10.0;
const LOOSER: f64 = 3.0;
const FAILURES: usize = 4;
const PATIENCE_WHERE_GOOD: usize = 1;
const LARGEST_HOLD: f64 = 1e5;
const WORTH: f64 = 0.9;
/// A round that leaves more than this share of the last distance counts like one that does not come nearer.
const HARDLY: f64 = 0.97;
/// A plan below this share of the tolerance needs no further ratio.
const GOOD: f64 = 0.5;
/// From so many ratios on this share is enough.
const SOUGHT: usize = 3;
const WITHIN: f64 = 0.9;
/// Nodes of DK(v) to begin with: as fine as the splines.
const FIRST_NODES: usize = 97;
/// Share of the tolerance that the last quarter of the series of DK may hold.
const SERIES: f64 = 1e-3;
/// Length of the tool beyond its contacts, mm: room for the search and for dressed lines that are not those of the ideal worm.
const MARGIN_OF_CONTACTS: f64 = 3.0;

/// Share of the limit aimed at by a fit that follows one beyond it.
const NARROWER: f64 = 0.9;
/// The same where no dressing motion is found.
const WELL_NARROWER: f64 = 0.3;
/// Fits of one ratio with narrower limits, at most.
const RETRIES: usize = 2;
/// Share of the bend that is left to a fit whose envelope folds though it is looked at closely.
const LESS_BENT: f64 = 0.4;
/// Share of the least determinant ratio below which a command folds between the points of a grid: between them the second order tells it.
const FOLDED: f64 = 0.5;
/// A plan within so many tolerances is nearly one; ratios about its own that are tried then, as factors.
const NEARLY: f64 = 2.5;
const NEIGHBOURS: [f64; 4] = [1.04, 0.96, 1.1, 0.9];
/// A fit that leaves more than this of what an unmodified flank would is hardly one.
const OF_UNMODIFIED: f64 = 0.5;
/// Tolerances within which the command stays near the target where none within one can be carried out.
const FURTHER: [f64; 4] = [3.0, 10.0, 30.0, 100.0];
/// Length of roll that contacts stay within the finished part of the worm, mm: rays stand between the points of a fit. And by how much
/// beyond that counts as a tolerance, mm.
const ROOM_AT_ENDS: f64 = 0.02;
const STRAINED: f64 = 0.3;
/// An ideal worm that leaves more than this share of the tolerance is not dressed as long as there is another to be tried.
const UNDRESSED: f64 = 1.2;
/// Nor is one whose contacts are so far beyond the finished part of the worm, in what counts as a tolerance: rounds with the worm as dressed bring
/// back less.
const FAR_BEYOND: f64 = 0.5;
/// So many of those that were not dressed are dressed after all where there is no plan, the most promising first, until one is.
const DRESSED_AT_LAST: usize = 6;
/// Rounds after which no further ratio or limit is tried where a plan keeps to the tolerance on the grid though it may fold beside it, and where there is none.
const ROUNDS_IN_ALL: [usize; 2] = [60, 400];
/// The smallest step towards a command that folds, over the part that is reached then, and steps at most.
const LEAST_STEP: f64 = 0.05;
const PARTS: usize = 10;

/// Ways to a command that folds if it is made at once; a part of 1 is the command.
#[derive(Clone, Copy, Debug)]
enum Way {
    /// From smoother ones, further from the target.
    Nearness,
    /// From a share of what is wanted.
    Share,
}

impl Way {
    const ALL: [Self; 2] = [Self::Nearness, Self::Share];

    /// Parts with which to begin.
    fn first(self) -> &'static [f64] {
        match self {
            Self::Nearness => &[0.2, 0.05],
            Self::Share => &[0.4, 0.15],
        }
    }

    /// The next part.
    fn more(self, part: f64) -> f64 {
        match self {
            Self::Nearness => 2.0 * part,
            Self::Share => part + 0.3,
        }
        .min(1.0)
    }

    /// Share of what is wanted and nearness of a part.
    fn aim(self, part: f64) -> (f64, f64) {
        match self {
            Self::Nearness => (1.0, NEAR / part),
            Self::Share => (part, NEAR),
        }
    }
}

/// A fit at one ratio with its tool.
struct FittedPlan {
    plan: GrindingPlan,
    /// What speaks against it, mm.
    strain: f64,
    /// Whether its command folds between the points of the grid, as far as the second order tells.
    folds: bool,
}

/// A fit that came to no plan.
struct Failed {
    error: GeneratingError,
    /// What its ideal worm leaves, limits that are not kept included, mm, where that was why no tool was made.
    left: Option<f64>,
}

impl From<GeneratingError> for Failed {
    fn from(error: GeneratingError) -> Self {
        Self { error, left: None }
    }
}

/// Which fits get a tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Dressed {
    /// Those whose ideal worm promises a plan.
    Promising,
    /// All.
    Each,
}

/// What the fits of one plan share.
struct Trials<'t> {
    grid: &'t PlanningGrid,
    /// What the rules came to.
    ruled: &'t Result<GrindingPlan, Box<NoPlan>>,
    /// Commands that were carried out.
    rounds: Cell<usize>,
}

impl Trials<'_> {
    fn count(&self) {
        self.rounds.set(self.rounds.get() + 1);
    }

    /// Whether no more is tried; `nearly` tells whether there is a plan, if perhaps with a fold.
    fn are_over(&self, nearly: bool) -> bool {
        self.rounds.get() >= ROUNDS_IN_ALL[usize::from(!nearly)]
    }
}

/// A fit without a tool.
struct Waiting {
    left: f64,
    ratio: f64,
    within: Within,
}

/// A fit that is carried out.
struct CarriedOut<'f, T> {
    fit: BestFit<'f>,
    made: T,
    contacts: Sides<Option<Contacts>>,
}

/// Whether two ratios are so far apart that one may do what the other cannot.
fn far_apart(a: f64, b: f64) -> bool {
    a * b < 0.0 || a.abs().max(b.abs()) > APART * a.abs().min(b.abs())
}

/// Limits for a fit that follows one beyond them: the first order says too little of large modifications, and places of a grid of those between.
/// `None` where no limit is to blame.
fn narrower(error: &GeneratingError, mut within: Within) -> Option<Within> {
    match error {
        GeneratingError::AxisLimit { axis, value, limit, .. } => {
            let by = NARROWER * limit / value;
            match CORRECTION_AXES.iter().position(|known| known == axis) {
                Some(j) => within.axes.correction[j] *= by,
                None => within.axes.delta_d *= by,
            }
        }
        // Far from where the first order holds.
        GeneratingError::Dressing(_) => {
            within.axes.correction.iter_mut().for_each(|limit| *limit *= WELL_NARROWER);
        }
        GeneratingError::Contact(ContactError::WormSurfaceMissing { .. }) => within.on_worm = true,
        // Far from the target what is between the contacts tells little.
        GeneratingError::ModelError { .. } if !within.closely => within.closely = true,
        GeneratingError::EnvelopeBroken { .. }
        | GeneratingError::Contact(ContactError::Undercut { .. } | ContactError::NotSettled { .. }) => {
            within.bend *= if within.closely { LESS_BENT } else { 1.0 };
            within.closely = true;
        }
        _ => return None,
    }
    Some(within)
}

impl PlanTask<'_> {
    /// Whether the best fit knows the bodies and rules of this task.
    pub(super) fn may_be_fitted(&self) -> bool {
        matches!(self.setup.tool, Tool::Dressed(_))
            && self.setup.strokes.is_none()
            && self.law.is_none()
            && self.gauge == PlanGauge::Centred
            && matches!(self.dressing, DressingRows::Alone(_))
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
        let (mut ratios, mut scan): (Vec<Expected>, _) = match self.ratio {
            Some(ratio) => (vec![Expected { ratio, cost: 0.0 }], None),
            None => {
                let scan = fits((&coarse, SCAN_INTERVALS))?;
                (scan.easiest(self.prefer).into_iter().collect(), Some(scan))
            }
        };
        let grid = PlanningGrid::new(self.setup, FIT_GRID[0], FIT_GRID[1]).closer_at_ends();
        let task = fits((&grid, FIT_INTERVALS))?;
        let trials = Trials { grid: &grid, ruled, rounds: Cell::new(0) };
        let mut best: Option<FittedPlan> = None;
        let mut waiting: Vec<Waiting> = Vec::new();
        let mut wait = |fitted: &Result<FittedPlan, Failed>, ratio: f64, within: Within| {
            if let Err(Failed { left: Some(left), .. }) = fitted {
                waiting.push(Waiting { left: *left, ratio, within });
            }
        };
        let nearly = |best: &Option<FittedPlan>| {
            let allowed = |known: &FittedPlan| if known.folds { 2.0 } else { 1.0 } * self.tolerance;
            best.as_ref().is_some_and(|known| known.strain <= allowed(known))
        };
        let mut tried: Vec<f64> = Vec::new();
        while tried.len() < CARRIED_OUT && !trials.are_over(nearly(&best)) {
            // What one ratio cannot do that was expected to be easy its neighbours hardly can.
            let next = |expected: &&Expected| {
                let apart = |other: &f64| far_apart(expected.ratio, *other);
                let new = |other: &f64| expected.ratio != *other;
                if expected.cost <= APART_UP_TO { tried.iter().all(apart) } else { tried.iter().all(new) }
            };
            let found = ratios.iter().find(next).copied();
            let Some(Expected { ratio, .. }) = found else {
                let Some(scan) = scan.take() else { break };
                ratios = scan.ratios(self.prefer);
                continue;
            };
            tried.push(ratio);
            let mut fitted = self.fitted_at(&task, &trials, ratio, Dressed::Promising);
            wait(&fitted, ratio, first);
            let mut within = first;
            // Where a plan within the tolerance is known, another ratio is worth one fit.
            let known = best.as_ref().is_some_and(|known| known.strain <= WITHIN * self.tolerance);
            let retries = match known {
                true => 0,
                false if tried.len() <= SOUGHT => RETRIES,
                false => 1,
            };
            for _ in 0..retries {
                let narrower = match &fitted {
                    Err(failed) => narrower(&failed.error, within),
                    Ok(fitted) if fitted.folds && !within.closely => Some(Within { closely: true, ..within }),
                    Ok(_) => None,
                };
                let Some(narrower) = narrower.filter(|_| !trials.are_over(nearly(&best))) else { break };
                let Some(task) = self.fit_task((&grid, FIT_INTERVALS), narrower) else { break };
                within = narrower;
                let again = self.fitted_at(&task, &trials, ratio, Dressed::Promising);
                wait(&again, ratio, within);
                fitted = match (fitted, again) {
                    (Ok(known), Ok(again)) if known.strain <= again.strain => Ok(known),
                    (Ok(known), Err(_)) => Ok(known),
                    (_, again) => again,
                };
            }
            let Ok(fitted) = fitted else { continue };
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
                if let Ok(fitted) = self.fitted_at(&task, &trials, by * about, Dressed::Promising)
                    && fitted.strain < known.strain
                {
                    *known = fitted;
                }
            }
        }
        if best.is_none() {
            waiting.sort_by(|a, b| a.left.total_cmp(&b.left));
            best = waiting.iter().take(DRESSED_AT_LAST).find_map(|of| {
                let task = self.fit_task((&grid, FIT_INTERVALS), of.within)?;
                self.fitted_at(&task, &trials, of.ratio, Dressed::Each).ok()
            });
        }
        let best = best.map(|best| best.plan);
        if best.as_ref().is_some_and(|known| self.deviation(known) <= OF_UNMODIFIED * self.unmodified(known))
        {
            return best;
        }
        // None that is worth it can be carried out: what is less near to the target is easier to make, and without shift the worm needs no
        // corrections.
        if self.ratio.is_none() && !tried.contains(&0.0) {
            tried.push(0.0);
        }
        let nearer = |a: &GrindingPlan, b: &GrindingPlan| self.deviation(a).total_cmp(&self.deviation(b));
        let further = FURTHER.into_iter().find_map(|near| {
            let within = Within { tolerance: near * self.tolerance, on_worm: true, ..first };
            let task = self.fit_task((&grid, FIT_INTERVALS), within)?;
            let fitted = |&ratio: &f64| Some(self.fitted_at(&task, &trials, ratio, Dressed::Each).ok()?.plan);
            tried.iter().filter_map(fitted).min_by(nearer)
        });
        best.into_iter().chain(further).min_by(nearer)
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

    /// Why the ideal worm of a fit promises no plan; `off` is what it leaves, limits that are not kept included, mm.
    fn unpromising(
        &self,
        task: &BestFitTask<'_>,
        ratio: f64,
        ideal: &CarriedOut<'_, IdealPlan>,
        off: f64,
    ) -> Option<Failed> {
        let failed = |left: f64, error: GeneratingError| Some(Failed { error, left: Some(left) });
        if self.strain(&ideal.contacts) > FAR_BEYOND
            && let Err(error) = self.on_the_worm(&ideal.contacts)
        {
            return failed(off, error);
        }
        let allowed = UNDRESSED * self.tolerance;
        if off > allowed {
            let (error_um, allowed_um) = (1e3 * off, 1e3 * allowed);
            return failed(off, GeneratingError::ModelError { ratio, error_um, allowed_um });
        }
        // Points that stand closer tell it where they are bounded closely.
        let least = ideal.fit.least_between(&ideal.contacts);
        if !task.within().closely && least < FOLDED * self.least_determinant {
            let flank = task.which().first().copied().unwrap_or(Flank::Left);
            let limit = self.least_determinant;
            return failed(
                off + self.tolerance,
                GeneratingError::EnvelopeBroken { flank, ratio: least, limit },
            );
        }
        None
    }

    /// The best fit at one ratio, carried out.
    fn fitted_at(
        &self,
        task: &BestFitTask<'_>,
        trials: &Trials<'_>,
        ratio: f64,
        which_dressed: Dressed,
    ) -> Result<FittedPlan, Failed> {
        let Trials { grid, ruled, .. } = *trials;
        let place = *self.places.first().ok_or(GeneratingError::NoFlank)?;
        let which = self.rule(grid).which();
        let [from, to] = self.setup.occupation(&FeedLaw::Ratio(ratio).law(self.setup, &which), &which);
        self.rule(grid).check_width(to - from, ratio)?;
        let series = SeriesRule { nodes: FIRST_NODES, tolerance: SERIES * self.tolerance };
        let policy = ProfilePolicy { series, ..self.rule(grid).policy(place) };
        let ideally = |plan: IdealPlan| self.ideal_contacts(grid, &plan).map(|contacts| (plan, contacts));
        let begun = self.begun(task, trials, ratio, &ideally)?;
        let (ideal, ideal_record) = self.settled(task, trials, begun, ROUNDS, ideally);
        let off = ideal_record.iter().copied().fold(f64::INFINITY, f64::min);
        if which_dressed == Dressed::Promising
            && let Some(failed) = self.unpromising(task, ratio, &ideal, off)
        {
            return Err(failed);
        }
        let margin = self.margin(&ideal.made, &ideal.contacts).max(DRESSING_MARGIN);
        let dressed = |plan: IdealPlan| self.equipped(&plan, policy, grid, margin);
        let (made, contacts) = dressed(ideal.made)?;
        let begun = CarriedOut { fit: ideal.fit, made, contacts };
        let (dressed, dressed_record) = self.settled(task, trials, begun, DRESSED_ROUNDS, dressed);
        self.unbroken(grid, &dressed.contacts)?;
        let folds = dressed.fit.least_between(&dressed.contacts) < FOLDED * self.least_determinant;
        self.on_the_worm(&dressed.contacts)?;
        let mut equipped = dressed.made;
        equipped.ideal.outside = dressed.fit.off;
        let candidate = self.candidate_of(&equipped, grid, ratio, place);
        if let (None, Some(refusal)) = (self.ratio, &candidate.refusal) {
            return Err(refusal.clone().into());
        }
        let rule = self.rule(grid);
        let (mut candidates, failed) = match ruled {
            Ok(plan) => (plan.choice.candidates.clone(), plan.choice.failed.clone()),
            Err(no) => (no.candidates.clone(), no.failed.clone()),
        };
        candidates.push(candidate);
        let choice = RatioChoice {
            ratio,
            place,
            reason: RatioReason::BestFit,
            lead_correction: rule.lead_corrections(place),
            demanded: rule.demanded(),
            candidates,
            failed,
        };
        let records = Records { ideal: Sides::both(ideal_record), dressed: Sides::both(dressed_record) };
        let plan = self.finish(equipped, choice, policy, grid, records)?;
        if plan.determinant < self.least_determinant {
            let (ratio, limit) = (plan.determinant, self.least_determinant);
            return Err(GeneratingError::EnvelopeBroken { flank: rule.which()[0], ratio, limit }.into());
        }
        // What folds between the points of the grid may look well on them.
        let strain = self.strain_of(&plan) + if folds { self.tolerance } else { 0.0 };
        Ok(FittedPlan { plan, strain, folds })
    }

    /// The first command with its contacts. Where it folds, a smoother one comes first and is brought nearer from its contacts as far as that
    /// goes; where that folds too, a share of what is wanted, and more of it.
    fn begun<'f>(
        &self,
        task: &'f BestFitTask<'_>,
        trials: &Trials<'_>,
        ratio: f64,
        carried_out: &impl Fn(IdealPlan) -> Result<(IdealPlan, Sides<Option<Contacts>>), GeneratingError>,
    ) -> Result<CarriedOut<'f, IdealPlan>, GeneratingError> {
        let at = |way: Way, part: f64| {
            trials.count();
            let fit = task.at(ratio, way.aim(part))?;
            let (made, contacts) = task.plan(&fit).and_then(carried_out)?;
            Ok::<_, GeneratingError>(CarriedOut { fit, made, contacts })
        };
        let refusal = match at(Way::Share, 1.0) {
            Ok(begun) => return Ok(begun),
            Err(error) => error,
        };
        let first = |way: Way| {
            way.first().iter().find_map(|&part| at(way, part).ok().map(|begun| (way, part, begun)))
        };
        let (way, mut part, mut begun) = Way::ALL.into_iter().find_map(first).ok_or(refusal)?;
        for _ in 0..PARTS {
            let mut more = way.more(part);
            let (share, near) = way.aim(more);
            let step = Step { share, hold: HOLD, near };
            let Some(mut fit) = begun.fit.next(self.setup, &begun.contacts, step) else { break };
            let next = loop {
                trials.count();
                let carried = task.plan(&fit).and_then(carried_out);
                if let Ok((made, contacts)) = carried {
                    break Some(CarriedOut { fit, made, contacts });
                }
                if more - part < LEAST_STEP * more {
                    break None;
                }
                // A command on the way is a part of the way.
                (fit, more) = (begun.fit.halfway(&fit), 0.5 * (part + more));
            };
            let Some(next) = next else { break };
            (begun, part) = (next, more);
            if part >= 1.0 {
                break;
            }
        }
        Ok(begun)
    }

    /// Corrects a fit and its plan where the tool touches, as long as a round comes nearer; `carried_out` makes the tool of a plan and its
    /// contacts. With the distance to the target after each round, mm, to which limits that are not kept add.
    fn settled<'f, T>(
        &self,
        task: &BestFitTask<'_>,
        trials: &Trials<'_>,
        CarriedOut { mut fit, mut made, mut contacts }: CarriedOut<'f, T>,
        rounds: usize,
        carried_out: impl Fn(IdealPlan) -> Result<(T, Sides<Option<Contacts>>), GeneratingError>,
    ) -> (CarriedOut<'f, T>, Vec<f64>) {
        let judge = |fit: &mut BestFit<'_>, at: &Sides<Option<Contacts>>| {
            fit.judge(self.setup, at) + self.tolerance * self.strain(at)
        };
        let mut off = judge(&mut fit, &contacts);
        let mut record = vec![off];
        for &near in self.nears() {
            let (mut hold, mut failed, mut gently) = (HOLD, 0, 0);
            let last = record.len() + rounds;
            while record.len() < last && off > (near + SETTLED) * self.tolerance && hold <= LARGEST_HOLD {
                let patience = if off <= GOOD * self.tolerance { PATIENCE_WHERE_GOOD } else { FAILURES };
                if failed > patience {
                    break;
                }
                // All that is wanted at once; after failures a part of what is missing.
                let kept = 1.0 - f64::powi(0.5, gently);
                let step = Step { share: 1.0, hold, near: near.max(kept * off / self.tolerance) };
                let Some(mut tried) = fit.next(self.setup, &contacts, step) else { break };
                trials.count();
                let carried = task.plan(&tried).and_then(&carried_out).ok();
                let now = carried.as_ref().map(|(_, at)| judge(&mut tried, at));
                record.extend(now);
                match (carried, now) {
                    (Some((tool, at)), Some(now)) if now < off => {
                        let settles = now > WORTH * off && now <= self.tolerance;
                        failed = if now > HARDLY * off { failed + 1 } else { 0 };
                        (fit, made, contacts, off) = (tried, tool, at, now);
                        (hold, gently) = (HOLD.max(hold / LOOSER), (gently - 1).max(0));
                        if settles {
                            break;
                        }
                    }
                    // Too far for what the contact at the last command tells.
                    _ => (hold, failed, gently) = (hold * TIGHTER, failed + 1, gently + 1),
                }
            }
        }
        (CarriedOut { fit, made, contacts }, record)
    }

    /// Length of the tool beyond the used width that the contacts of a plan need, mm.
    fn margin(&self, plan: &IdealPlan, contacts: &Sides<Option<Contacts>>) -> f64 {
        let of_flank = |flank: Flank| {
            let [from, to] = self.setup.lines[flank].occupation(&plan.motion.shift);
            let at = contacts[flank].iter().flatten();
            at.map(|(_, (_, z))| (from - z).max(z - to)).fold(0.0, f64::max)
        };
        Flank::BOTH.into_iter().map(of_flank).fold(0.0, f64::max) + MARGIN_OF_CONTACTS
    }

    /// Contacts of the ideal worm.
    fn ideal_contacts(
        &self,
        grid: &PlanningGrid,
        ideal: &IdealPlan,
    ) -> Result<Sides<Option<Contacts>>, GeneratingError> {
        let of_flank = |flank: Flank| -> Result<Option<Contacts>, GeneratingError> {
            let Some(worm) = &ideal.worms[flank] else { return Ok(None) };
            let thread = ModifiedThread::new(self.setup.pair.flanks[flank].worm, worm);
            let ground = grid.ground(self.setup, flank, &ideal.motion, &thread)?;
            Ok(Some(ground.into_iter().map(|at| (at, at.tool)).collect()))
        };
        let (left, right) = rayon::join(|| of_flank(Flank::Left), || of_flank(Flank::Right));
        let contacts = Sides { left: left?, right: right? };
        self.unbroken(grid, &contacts)?;
        Ok(contacts)
    }

    /// Refuses contacts near a fold.
    fn unbroken(
        &self,
        grid: &PlanningGrid,
        contacts: &Sides<Option<Contacts>>,
    ) -> Result<(), GeneratingError> {
        for (flank, at) in contacts.iter() {
            let Some(at) = at else { continue };
            let by_ratio = |(_, a): &(usize, &Contact), (_, b): &(usize, &Contact)| {
                a.0.determinant_ratio.total_cmp(&b.0.determinant_ratio)
            };
            if let Some((k, (least, _))) = at.iter().enumerate().min_by(by_ratio)
                && least.determinant_ratio < self.least_determinant
            {
                let (w, z) = (grid.w[flank][k / grid.z.len()], grid.z[k % grid.z.len()]);
                let ratio = least.determinant_ratio;
                return Err(ContactError::Undercut { flank, w, z, ratio }.into());
            }
        }
        Ok(())
    }

    /// Refuses contacts beyond the finished part of the worm.
    fn on_the_worm(&self, contacts: &Sides<Option<Contacts>>) -> Result<(), GeneratingError> {
        for (flank, at) in contacts.iter() {
            let beyond = self.beyond(flank)?;
            if let Some(&(_, (p, q))) = at.iter().flatten().find(|(_, (w, _))| beyond(*w) > 0.0) {
                return Err(ContactError::WormSurfaceMissing { p, q }.into());
            }
        }
        Ok(())
    }

    /// How far a length of roll on the worm lies beyond what is finished of it, mm.
    pub(super) fn beyond(&self, flank: Flank) -> Result<impl Fn(f64) -> f64 + use<>, GeneratingError> {
        let [low, high] = finished_rolls(self.setup, self.setup.dresser()?, flank);
        Ok(move |w: f64| (low + ROOM_AT_ENDS - w).max(w - high + ROOM_AT_ENDS))
    }

    /// How far contacts are beyond the limits of envelope and worm: 0 within them, else what counts as so many tolerances.
    fn strain(&self, contacts: &Sides<Option<Contacts>>) -> f64 {
        let of_flank = |flank: Flank| {
            let (Some(at), Ok(beyond)) = (&contacts[flank], self.beyond(flank)) else { return 0.0 };
            let of_contact = |(at, (w, _)): &Contact| {
                let folds = (self.least_determinant - at.determinant_ratio) / self.least_determinant;
                f64::max(folds, beyond(*w) / STRAINED)
            };
            at.iter().map(of_contact).fold(0.0, f64::max)
        };
        f64::max(of_flank(Flank::Left), of_flank(Flank::Right))
    }

    /// The tool of a plan, reaching `margin` beyond the used width or further, and its contacts.
    fn equipped(
        &self,
        ideal: &IdealPlan,
        policy: ProfilePolicy,
        grid: &PlanningGrid,
        mut margin: f64,
    ) -> Result<(Equipped, Sides<Option<Contacts>>), GeneratingError> {
        loop {
            let (dresser, flanks) = self.tools(ideal, policy, margin)?;
            match self.contacts(&flanks, ideal, grid) {
                Ok(contacts) => {
                    let wanted =
                        |flank: Flank| contacts[flank].as_ref().map(|at| at.iter().map(|c| c.0).collect());
                    let shift = &ideal.motion.shift;
                    let ground = |flank: Flank| wanted(flank).map(Ok);
                    let error = GroundError::of(self.setup, &self.targets, grid, shift, ground, |_, _| None)?;
                    let equipped = Equipped { ideal: ideal.clone(), dresser, flanks, error, margin };
                    return Ok((equipped, contacts));
                }
                Err(GeneratingError::Contact(ContactError::WormSurfaceMissing { .. }))
                    if margin < LARGEST_DRESSING_MARGIN =>
                {
                    margin *= 2.0;
                }
                Err(error) => return Err(error),
            }
        }
    }

    fn contacts(
        &self,
        flanks: &Sides<Option<PlannedTool>>,
        ideal: &IdealPlan,
        grid: &PlanningGrid,
    ) -> Result<Sides<Option<Contacts>>, GeneratingError> {
        let of_flank = |flank: Flank| -> Result<Option<Contacts>, GeneratingError> {
            let Some(tool) = &flanks[flank] else { return Ok(None) };
            let ground = tool.ground(self.setup, flank, grid, &ideal.motion)?;
            let lost = |at: &contact::ContactSolution| ContactError::WormSurfaceMissing {
                p: at.tool.0,
                q: at.tool.1,
            };
            let footed = ground.into_iter().map(|at| Ok((at, tool.foot(&at).ok_or_else(|| lost(&at))?)));
            footed.collect::<Result<Contacts, GeneratingError>>().map(Some)
        };
        let (left, right) = rayon::join(|| of_flank(Flank::Left), || of_flank(Flank::Right));
        Ok(Sides { left: left?, right: right? })
    }

    /// The largest share of a limit that a correcting axis of dressing takes, with the axis and its value.
    pub(super) fn dressing_share(&self, equipped: &Equipped) -> (f64, (usize, f64)) {
        let mut largest = (0.0, (0, 0.0));
        for (flank, tool) in equipped.flanks.iter() {
            let Some(PlannedTool::Dressed(dressed)) = tool else { continue };
            let settled = equipped.dresser.as_ref().map_or([0.0; 4], |dresser| dresser.flanks[flank].settled);
            for node in &dressed.nodes {
                for j in 0..4 {
                    let value = (node.dk[j] + settled[j]).abs();
                    let share = value / self.limits.correction[j];
                    if share > largest.0 {
                        largest = (share, (j, value));
                    }
                }
            }
        }
        largest
    }

    /// What a fitted ratio asks of the axes, as the rule judges ratios.
    fn candidate_of(
        &self,
        equipped: &Equipped,
        grid: &PlanningGrid,
        ratio: f64,
        place: ProfilePlace,
    ) -> Candidate {
        let rule = self.rule(grid);
        let ideal = &equipped.ideal;
        let (dressing_share, worst) = self.dressing_share(equipped);
        let feeds = self.setup.feed_range(&ideal.motion.shift, &rule.which());
        let delta_d = (0..=64)
            .map(|k| ideal.motion.delta_d.value(feeds[0] + (feeds[1] - feeds[0]) * f64::from(k) / 64.0).abs())
            .fold(0.0, f64::max);
        let occupation = ideal.occupation[1] - ideal.occupation[0];
        let refusal = rule
            .check_width(occupation, ratio)
            .and_then(|()| rule.check_axes(dressing_share, worst, delta_d))
            .err();
        Candidate {
            ratio,
            place,
            dressing_share,
            delta_d_share: delta_d / self.limits.delta_d,
            occupation,
            feed_travel: feeds[1] - feeds[0],
            error: equipped.error.max(),
            residuals: FlankResidual::of(self.setup, ideal, &equipped.error),
            determinant: equipped.error.determinant,
            refusal,
        }
    }
}
