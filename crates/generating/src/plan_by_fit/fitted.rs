//! The best fit at one ratio, from its first command to a plan.

use super::super::best_fit::{BestFitTask, Folds, Within};
use super::super::dressed::DRESSING_MARGIN;
use super::super::plan::{PlanTask, Records};
use super::super::ratio::{CORRECTION_AXES, RatioChoice, RatioReason};
use super::super::{FeedLaw, GeneratingError, IdealPlan, ProfilePolicy, SeriesRule};
use super::rounds::CarriedOut;
use super::trials::{Dressed, Failed, FittedPlan, Trials};
use contact::ContactError;
use foundation::geometry::{Flank, Sides};

/// Rounds of correction with the ideal worm, and with the worm as dressed.
const ROUNDS: usize = 12;
const DRESSED_ROUNDS: usize = 4;
/// Nodes of DK(v) to begin with: as fine as the splines.
const FIRST_NODES: usize = 97;
/// Share of the tolerance that the last quarter of the series of DK may hold.
const SERIES: f64 = 1e-3;
/// Share of the limit aimed at by a fit that follows one beyond it.
const NARROWER: f64 = 0.9;
/// The same where no dressing motion is found.
const WELL_NARROWER: f64 = 0.3;
/// Share of the bend that is left to a fit whose envelope folds though it is looked at closely.
const LESS_BENT: f64 = 0.4;
/// Share of the least determinant ratio below which a command folds between the points of a grid: between them the second order tells it.
const FOLDED: f64 = 0.5;
/// An ideal worm that leaves more than this share of the tolerance is not dressed as long as there is another to be tried.
const UNDRESSED: f64 = 1.2;
/// Nor is one whose contacts are so far beyond the finished part of the worm, in what counts as a tolerance: rounds with the worm as dressed bring
/// back less.
const FAR_BEYOND: f64 = 0.5;

/// Limits for a fit that follows one beyond them: the first order says too little of large modifications, and places of a grid of those between.
/// `None` where no limit is to blame.
pub(super) fn narrower(error: &GeneratingError, mut within: Within) -> Option<Within> {
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
    /// Why the ideal worm of a fit promises no plan; `off` is what it leaves, limits that are not kept included, mm.
    pub(super) fn unpromising(
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
    pub(super) fn fitted_at(
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
        let ideally = |plan: IdealPlan| self.ideally_carried_out(trials, plan);
        let folds = &mut Sides::<Folds>::default();
        let begun = self.begun(task, trials, ratio, (&ideally, folds))?;
        let (ideal, ideal_record) = self.settled(task, trials, begun, ROUNDS, (ideally, folds));
        let off = ideal_record.iter().copied().fold(f64::INFINITY, f64::min);
        if which_dressed == Dressed::Promising
            && let Some(failed) = self.unpromising(task, ratio, &ideal, off)
        {
            return Err(failed);
        }
        let margin = self.margin(&ideal.made, &ideal.contacts).max(DRESSING_MARGIN);
        let dressed = |plan: IdealPlan| self.dressed_carried_out(&plan, policy, trials, margin);
        let begun = self.first_dressed(task, trials, ideal, (&dressed, folds))?;
        let (dressed, dressed_record) = self.settled(task, trials, begun, DRESSED_ROUNDS, (dressed, folds));
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
}
