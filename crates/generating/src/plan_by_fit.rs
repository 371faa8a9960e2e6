//! Plans by a best fit to the whole target (`docs/mathematics/best-fit.md`), for targets that the closed decomposition misses or refuses.
//! No command asks for it yet: settings cannot carry a fitted profile of the dresser, so that `simulate` would not run what was planned.
//! The example `drawings` measures it.

use super::best_fit::{BestFit, BestFitTask, Contacts};
use super::dressed::DRESSING_MARGIN;
use super::plan::{Equipped, LARGEST_DRESSING_MARGIN, PlanTask, Records};
use super::planning_grid::GroundError;
use super::ratio::{Candidate, FlankResidual, NoPlan, RatioChoice, RatioReason};
use super::{
    DressingRows, GeneratingError, GrindingPlan, IdealPlan, PlanGauge, PlannedTool, PlanningGrid,
    ProfilePlace, ProfilePolicy, Tool,
};
use contact::{ContactError, ModifiedThread};
use foundation::geometry::{Flank, Sides};

/// Points over profile and face width of the fit.
const FIT_GRID: [usize; 2] = [21, 41];
/// Ratios that are carried out, at most.
const CARRIED_OUT: usize = 4;
/// Rounds of correction with the ideal worm, and with the worm as dressed.
const ROUNDS: usize = 5;
const DRESSED_ROUNDS: usize = 4;
/// A round ends the correction when planned flank and contact agree to this share of the tolerance.
const SETTLED: f64 = 0.01;
/// A plan below this share of the tolerance needs no further ratio.
const GOOD: f64 = 0.6;

impl PlanTask<'_> {
    /// Whether the best fit knows the bodies and rules of this task.
    pub(super) fn may_be_fitted(&self) -> bool {
        matches!(self.setup.tool, Tool::Dressed(_))
            && self.setup.strokes.is_none()
            && self.law.is_none()
            && self.gauge == PlanGauge::Centred
            && matches!(self.dressing, DressingRows::Alone(_))
            && self.precompensation
            && Flank::BOTH.into_iter().all(|flank| self.setup.lines[flank].is_cylindrical())
            && self.setup.pair.worm.is_cylindrical()
            && self.setup.pair.work.is_cylindrical()
            && !(self.free_dresser && self.places.first() != Some(&ProfilePlace::Dresser))
    }

    /// The best plan by fits at some ratios; `None` where none can be carried out. `ruled` is what the rules came to.
    pub(super) fn plan_by_fit(&self, ruled: &Result<GrindingPlan, Box<NoPlan>>) -> Option<GrindingPlan> {
        let grid = PlanningGrid::new(self.setup, FIT_GRID[0], FIT_GRID[1]);
        let task =
            BestFitTask::new(self.setup, &self.targets, &grid, self.free_dresser, self.tolerance).ok()?;
        let ratios = match self.ratio {
            Some(ratio) => vec![ratio],
            None => task.ratios().into_iter().map(|expected| expected.ratio).collect(),
        };
        let mut best: Option<GrindingPlan> = None;
        for ratio in ratios.into_iter().take(CARRIED_OUT) {
            let Ok(plan) = self.fitted_at(&task, &grid, ratio, ruled) else { continue };
            let better = best.as_ref().is_none_or(|known| self.deviation(&plan) < self.deviation(known));
            if better {
                best = Some(plan);
            }
            if best.as_ref().is_some_and(|known| self.deviation(known) <= GOOD * self.tolerance) {
                break;
            }
        }
        best
    }

    /// The best fit at one ratio, carried out.
    fn fitted_at(
        &self,
        task: &BestFitTask<'_>,
        grid: &PlanningGrid,
        ratio: f64,
        ruled: &Result<GrindingPlan, Box<NoPlan>>,
    ) -> Result<GrindingPlan, GeneratingError> {
        let place = *self.places.first().ok_or(GeneratingError::NoFlank)?;
        let policy = self.rule(grid).policy(place);
        let fit = task.at(ratio)?;
        let first = task.plan(&fit)?;
        let ideally = |plan: IdealPlan| self.ideal_contacts(grid, &plan).map(|contacts| (plan, contacts));
        let (fit, ideal, record) = self.settled(task, (fit, first), ROUNDS, ideally)?;
        let dressed = |plan: IdealPlan| self.equipped(&plan, policy, grid);
        let (_, equipped, dressed_record) = self.settled(task, (fit, ideal), DRESSED_ROUNDS, dressed)?;
        let candidate = self.candidate_of(&equipped, grid, ratio, place);
        if let (None, Some(refusal)) = (self.ratio, &candidate.refusal) {
            return Err(refusal.clone());
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
        let records = Records { ideal: Sides::both(record), dressed: Sides::both(dressed_record) };
        self.finish(equipped, choice, policy, grid, records)
    }

    /// Corrects a fit and its plan where the tool touches, as long as a round brings planned flank and contact nearer: the fit, what
    /// `carried_out` makes of its plan, and the distance after each round, mm.
    fn settled<'f, T>(
        &self,
        task: &BestFitTask<'_>,
        (mut fit, first): (BestFit<'f>, IdealPlan),
        rounds: usize,
        carried_out: impl Fn(IdealPlan) -> Result<(T, Sides<Option<Contacts>>), GeneratingError>,
    ) -> Result<(BestFit<'f>, T, Vec<f64>), GeneratingError> {
        let (mut made, mut contacts) = carried_out(first)?;
        let mut off = fit.off(self.setup, &contacts);
        let mut record = vec![off];
        for _ in 0..rounds {
            if off <= SETTLED * self.tolerance {
                break;
            }
            let mut next = fit.clone();
            if !next.correct(self.setup, &contacts) {
                break;
            }
            let Ok((tool, at)) = task.plan(&next).and_then(&carried_out) else { break };
            let now = next.off(self.setup, &at);
            record.push(now);
            if now >= off {
                break;
            }
            (fit, made, contacts, off) = (next, tool, at, now);
        }
        Ok((fit, made, record))
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
        Ok(Sides { left: left?, right: right? })
    }

    /// The tool of a plan and its contacts.
    fn equipped(
        &self,
        ideal: &IdealPlan,
        policy: ProfilePolicy,
        grid: &PlanningGrid,
    ) -> Result<(Equipped, Sides<Option<Contacts>>), GeneratingError> {
        let mut margin = DRESSING_MARGIN;
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
        let mut dressing_share: f64 = 0.0;
        let mut worst = (0, 0.0);
        for (flank, tool) in equipped.flanks.iter() {
            let Some(PlannedTool::Dressed(dressed)) = tool else { continue };
            let settled = equipped.dresser.as_ref().map_or([0.0; 4], |dresser| dresser.flanks[flank].settled);
            for node in &dressed.nodes {
                for j in 0..4 {
                    let value = (node.dk[j] + settled[j]).abs();
                    let share = value / self.limits.correction[j];
                    if share > dressing_share {
                        (dressing_share, worst) = (share, (j, value));
                    }
                }
            }
        }
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
            error: equipped.error.max(),
            residuals: FlankResidual::of(self.setup, ideal, &equipped.error),
            determinant: equipped.error.determinant,
            refusal,
        }
    }
}
