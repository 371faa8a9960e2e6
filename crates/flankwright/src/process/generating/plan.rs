//! The whole plan of generating grinding: ratio, precompensated decomposition, dressing motion, planned flank
//! (spec 28 section 4; everything but the referee).

use super::dressed::{DRESSING_MARGIN, DressedFlank, dress_flank, dresser_of_plan, finished_area};
use super::precompensation::{GroundError, ROUNDS, corrected, precompensate};
use super::ratio::{Candidate, RatioChoice, RatioReason, Rule};
use super::{
    DressingLimits, FlankTarget, GeneratingError, GrindingSetup, IdealPlan, PlanningGrid, ProfilePlace,
    ProfilePolicy,
};
use crate::contact::{ContactError, ContactSolution};
use crate::geometry::{Flank, Sides};
use crate::numerics::Polynomial2;
use crate::process::dressing::DresserTool;

/// What is to be planned.
#[derive(Clone, Debug)]
pub struct PlanTask<'a> {
    /// The bodies.
    pub setup: &'a GrindingSetup,
    /// Target per flank; `None` for a flank that is not ground.
    pub targets: Sides<Option<FlankTarget>>,
    /// Tolerance, mm.
    pub tolerance: f64,
    /// Limits of the correcting axes.
    pub limits: DressingLimits,
    /// Diagonal ratio given in the job; 0 = radial; `None` = auto.
    pub ratio: Option<f64>,
    /// Places allowed for the profile crowning, in order of preference.
    pub places: Vec<ProfilePlace>,
    /// Whether the dresser is made for this job.
    pub free_dresser: bool,
    /// Whether the command is corrected by the exact flank.
    pub precompensation: bool,
    /// Result grid: points over the profile and over the face width.
    pub grid: (usize, usize),
}

/// One planned flank on the result grid.
#[derive(Clone, Debug)]
pub struct FlankPlan {
    /// The worm flank as dressed.
    pub dressed: DressedFlank,
    /// Lengths of roll, mm.
    pub w: Vec<f64>,
    /// Axial positions, mm.
    pub z: Vec<f64>,
    /// Target, normal, mm, row-major `[w][z]`.
    pub target: Vec<f64>,
    /// Planned flank (exact contact with the worm as dressed), normal, mm.
    pub planned: Vec<ContactSolution>,
}

/// A finished plan.
#[derive(Clone, Debug)]
pub struct GrindingPlan {
    /// Ratio and why.
    pub choice: RatioChoice,
    /// Profile policy used.
    pub policy: ProfilePolicy,
    /// Worm functions and motion.
    pub ideal: IdealPlan,
    /// The dresser with its profile.
    pub tool: DresserTool,
    /// Planned flanks.
    pub flanks: Sides<Option<FlankPlan>>,
    /// Largest error on the planning grid per flank by round of precompensation (ideal worm), mm.
    pub ideal_error_by_round: Sides<Vec<f64>>,
    /// The same by outer round (worm as dressed), mm.
    pub dressed_error_by_round: Sides<Vec<f64>>,
    /// Least determinant ratio on the result grid.
    pub determinant: f64,
}

/// Largest margin dressed beyond the occupation, mm.
const LARGEST_DRESSING_MARGIN: f64 = 48.0;
/// Distance of the contacts from the ends of the finished worm, mm: room for the search of whoever checks the plan.
const CONTACT_MARGIN: f64 = 1.5;
/// Outer rounds with the worm as dressed.
const OUTER_ROUNDS: usize = 3;

struct Dressed {
    ideal: IdealPlan,
    tool: DresserTool,
    flanks: Sides<Option<DressedFlank>>,
    error: GroundError,
    /// Length dressed beyond the occupation, mm.
    margin: f64,
}

impl PlanTask<'_> {
    fn rule<'a>(&'a self, grid: &'a PlanningGrid) -> Rule<'a> {
        Rule {
            setup: self.setup,
            targets: &self.targets,
            grid,
            limits: self.limits,
            tolerance: self.tolerance,
            free_dresser: self.free_dresser,
        }
    }

    /// Chooses the diagonal ratio by the rule, or judges the given one.
    ///
    /// # Errors
    /// When nothing is allowed: the reason of the best candidate. A given ratio is refused only if it cannot be evaluated or
    /// needs more worm than there is.
    pub fn choose(&self, grid: &PlanningGrid) -> Result<RatioChoice, GeneratingError> {
        let rule = self.rule(grid);
        let Some(ratio) = self.ratio else { return rule.choose(&self.places) };
        let place = *self.places.first().ok_or(GeneratingError::NoFlank)?;
        let [from, to] = self.setup.occupation(ratio, &rule.which());
        rule.check_width(to - from, ratio)?;
        let candidate = if ratio == 0.0 {
            let (plan, error, _) =
                precompensate(self.setup, &self.targets, grid, 0.0, self.policy(place), 0)?;
            let occupation = plan.occupation[1] - plan.occupation[0];
            Candidate {
                ratio,
                place,
                dressing_share: 0.0,
                delta_d_share: 0.0,
                occupation,
                error: error.max(),
                refusal: None,
            }
        } else {
            rule.judge(ratio, place)?
        };
        Ok(RatioChoice {
            ratio,
            place,
            reason: RatioReason::Given,
            lead_correction: rule.lead_corrections(place),
            candidates: vec![candidate],
            failed: Vec::new(),
        })
    }

    fn policy(&self, place: ProfilePlace) -> ProfilePolicy {
        ProfilePolicy { place, free_dresser: self.free_dresser }
    }

    /// Plans.
    ///
    /// # Errors
    /// See [`GeneratingError`]; [`GeneratingError::is_bad_input`] tells impossible input from an unreachable target.
    pub fn plan(&self) -> Result<GrindingPlan, GeneratingError> {
        let grid = PlanningGrid::new(self.setup, 9, 9);
        let choice = self.choose(&grid)?;
        let policy = self.policy(choice.place);
        let rounds = if self.precompensation { ROUNDS } else { 0 };
        let (ideal, ideal_error, ideal_record) =
            precompensate(self.setup, &self.targets, &grid, choice.ratio, policy, rounds)?;
        let mut best = self.dress(ideal, policy, &grid)?;
        let mut dressed_record = Sides::from_fn(|f| best.error.largest(f).into_iter().collect::<Vec<_>>());
        if self.precompensation {
            for _ in 0..OUTER_ROUNDS {
                if best.error.max() - ideal_error.max() <= f64::min(0.1 * self.tolerance, 1e-5) {
                    break;
                }
                let command: Sides<Option<Polynomial2>> =
                    corrected(self.setup, &grid, &best.ideal.commanded, &best.error, choice.ratio != 0.0);
                let next = IdealPlan::new(self.setup, &self.targets, command, choice.ratio, policy)
                    .and_then(|ideal| self.dress(ideal, policy, &grid));
                let Ok(next) = next else { break };
                for flank in Flank::BOTH {
                    dressed_record[flank].extend(next.error.largest(flank));
                }
                if next.error.max() >= best.error.max() {
                    break;
                }
                best = next;
            }
        }
        let result_grid = PlanningGrid::new(self.setup, self.grid.0, self.grid.1);
        let flanks = loop {
            let flank_plan = |flank: Flank| self.flank_plan(flank, &best, &result_grid);
            let (left, right) = rayon::join(|| flank_plan(Flank::Left), || flank_plan(Flank::Right));
            let flanks = Sides { left: left?, right: right? };
            if best.margin >= LARGEST_DRESSING_MARGIN || self.within_finished_area(&best, &flanks) {
                break flanks;
            }
            let margin = 2.0 * best.margin;
            let (tool, dressed, error) = self.dress_with(&best.ideal, policy, &grid, margin)?;
            best = Dressed { ideal: best.ideal, tool, flanks: dressed, error, margin };
        };
        let determinant = flanks
            .iter()
            .filter_map(|(_, f)| f.as_ref())
            .flat_map(|f| f.planned.iter().map(|p| p.determinant_ratio))
            .fold(f64::INFINITY, f64::min);
        Ok(GrindingPlan {
            choice,
            policy,
            ideal: best.ideal,
            tool: best.tool,
            flanks,
            ideal_error_by_round: ideal_record,
            dressed_error_by_round: dressed_record,
            determinant,
        })
    }

    /// Dresses the worm for an ideal plan; where the contact shift of a large modification leaves the dressed length, more
    /// of the worm is dressed.
    fn dress(
        &self,
        ideal: IdealPlan,
        policy: ProfilePolicy,
        grid: &PlanningGrid,
    ) -> Result<Dressed, GeneratingError> {
        let mut margin = DRESSING_MARGIN;
        loop {
            match self.dress_with(&ideal, policy, grid, margin) {
                Ok((tool, flanks, error)) => return Ok(Dressed { ideal, tool, flanks, error, margin }),
                Err(GeneratingError::Contact(ContactError::WormSurfaceMissing { .. }))
                    if margin < LARGEST_DRESSING_MARGIN =>
                {
                    margin *= 2.0;
                }
                Err(error) => return Err(error),
            }
        }
    }

    fn dress_with(
        &self,
        ideal: &IdealPlan,
        policy: ProfilePolicy,
        grid: &PlanningGrid,
        margin: f64,
    ) -> Result<(DresserTool, Sides<Option<DressedFlank>>, GroundError), GeneratingError> {
        let tool = dresser_of_plan(self.setup, ideal, policy);
        let dress = |flank: Flank| match &ideal.worms[flank] {
            Some(_) => dress_flank(self.setup, ideal, &tool, flank, policy, margin).map(Some),
            None => Ok(None),
        };
        let (left, right) = rayon::join(|| dress(Flank::Left), || dress(Flank::Right));
        let flanks = Sides { left: left?, right: right? };
        let error = GroundError::of(self.setup, &self.targets, grid, |flank| {
            flanks[flank].as_ref().map(|dressed| grid.ground(self.setup, flank, &ideal.motion, &dressed.worm))
        })?;
        Ok((tool, flanks, error))
    }

    /// Whether every contact on the worm lies inside the finished area with [`CONTACT_MARGIN`] to spare.
    fn within_finished_area(&self, best: &Dressed, flanks: &Sides<Option<FlankPlan>>) -> bool {
        flanks.iter().filter_map(|(flank, plan)| plan.as_ref().map(|plan| (flank, plan))).all(
            |(flank, plan)| {
                let (_, [from, to]) = finished_area(self.setup, &best.tool, flank, &plan.dressed.corrections);
                plan.planned.iter().all(|at| {
                    plan.dressed
                        .worm
                        .envelope_point(at.tool.0, at.tool.1)
                        .is_some_and(|foot| foot.b > from + CONTACT_MARGIN && foot.b < to - CONTACT_MARGIN)
                })
            },
        )
    }

    fn flank_plan(
        &self,
        flank: Flank,
        best: &Dressed,
        grid: &PlanningGrid,
    ) -> Result<Option<FlankPlan>, GeneratingError> {
        let (Some(dressed), Some(target)) = (&best.flanks[flank], &self.targets[flank]) else {
            return Ok(None);
        };
        let planned = grid.ground(self.setup, flank, &best.ideal.motion, &dressed.worm)?;
        let wanted = grid.target(flank, target, self.setup.lines[flank].cos_b2)?;
        Ok(Some(FlankPlan {
            dressed: dressed.clone(),
            w: grid.w[flank].clone(),
            z: grid.z.clone(),
            target: wanted,
            planned,
        }))
    }
}
