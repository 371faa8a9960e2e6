//! The whole plan of generating grinding: ratio, precompensated decomposition, dressing motion, planned flank
//! (`docs/mathematics/planning.md#from-the-ratio-to-the-flank`; everything but the referee).

use super::dressed::{DRESSING_MARGIN, DressedFlank, FinishedArea, dress_flanks, dresser_of_plan};
use super::least_squares::FitNorm;
use super::planning_grid::GroundError;
use super::precompensation::{FREE_ROUNDS, ROUNDS, corrected, precompensate};
use super::ratio::{
    Candidate, FlankResidual, LEAST_DETERMINANT, NoPlan, RatioChoice, RatioReason, Rule, Search,
};
use super::{
    DressingLimits, DressingRows, Effort, EqualSwivel, FeedLaw, FlankTarget, FreeCoefficients,
    GeneratingError, GrindingSetup, IdealPlan, MadeFlank, PlanGauge, PlanningGrid, Prefer, ProfilePlace,
    ProfilePolicy, StrokedFlank, SwivelSide, Tool, equal_swivel,
};
use contact::{ContactError, ContactSolution};
use dressing::DresserTool;
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::{GeneratingMotion, MotionLaw};
use foundation::modification::ToleranceMap;
use foundation::numerics::extremes;

/// What is to be planned.
#[derive(Clone, Debug)]
pub struct PlanTask<'a> {
    /// The bodies.
    pub setup: &'a GrindingSetup,
    /// Target per flank; `None` for a flank that is not ground.
    pub targets: Sides<Option<FlankTarget>>,
    /// Tolerance, mm; of a map the tightest.
    pub tolerance: f64,
    /// The tolerance over the flank, where it is not the same everywhere.
    pub tolerance_map: Option<ToleranceMap>,
    /// Limits of the correcting axes.
    pub limits: DressingLimits,
    /// Diagonal ratio given in the job; 0 = radial; `None` = auto.
    pub ratio: Option<f64>,
    /// A law z_V1 = F(z_V2) in place of a ratio.
    pub law: Option<MotionLaw>,
    /// Places allowed for the profile crowning, in order of preference.
    pub places: Vec<ProfilePlace>,
    /// Whether the dresser is made for this job.
    pub free_dresser: bool,
    /// Whether the command is corrected by the exact flank.
    pub precompensation: bool,
    /// What the best fit of parts outside the class makes small.
    pub norm: FitNorm,
    /// Which of the equal decompositions is made.
    pub gauge: PlanGauge,
    /// What the dressing motion has to meet.
    pub dressing: DressingRows,
    /// Result grid: points over the profile and over the face width.
    pub grid: (usize, usize),
    /// What decides among ratios that keep to half the tolerance.
    pub prefer: Prefer,
    /// Determinant ratio that every contact is to keep.
    pub least_determinant: f64,
    /// How long a better plan is looked for.
    pub effort: Effort,
}

/// The flank of a planned tool.
#[derive(Clone, Debug)]
pub enum PlannedTool {
    /// As its dresser leaves it.
    Dressed(Box<DressedFlank>),
    /// As several strokes leave it.
    Stroked(Box<StrokedFlank>),
    /// As a table.
    Made(MadeFlank),
}

/// One planned flank on the result grid.
#[derive(Clone, Debug)]
pub struct FlankPlan {
    /// The flank of the tool.
    pub tool: PlannedTool,
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
    /// The dresser with its profile, the first of several; `None` for a tool that is not dressed.
    pub dresser: Option<DresserTool>,
    /// Planned flanks.
    pub flanks: Sides<Option<FlankPlan>>,
    /// Largest error on the planning grid per flank by round of precompensation (ideal worm), mm.
    pub ideal_error_by_round: Sides<Vec<f64>>,
    /// The same by outer round (worm as dressed), mm.
    pub dressed_error_by_round: Sides<Vec<f64>>,
    /// Least determinant ratio on the result grid.
    pub determinant: f64,
    /// Largest error of the planned flank inside the cells of the result grid, per flank, normal, mm; 0 where polynomials
    /// tell the whole plan.
    pub between: Sides<f64>,
    /// The refusal of the rules that a best fit took the place of.
    pub instead_of: Option<Box<NoPlan>>,
    /// How near any flank could come, for a plan that misses its target.
    pub least: Option<LeastDeviation>,
}

/// A lower bound of what the flanks of the class of best fits leave of a target over all diagonal ratios that the worm is wide enough for
/// (`docs/mathematics/best-fit.md#a-miss`). Normal, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeastDeviation {
    /// Ratio at which least is left.
    pub ratio: f64,
    /// What is left there at least within the limits of axes and envelope, to first order.
    pub first_order: f64,
    /// How far the planned flank lies from the class: the higher order that the bound neglects.
    pub beyond_class: f64,
    /// What is left at the same ratio without the limits of the axes.
    pub without_axes: f64,
    /// What is left at the same ratio without that of the envelope.
    pub without_envelope: f64,
}

impl LeastDeviation {
    /// The bound less what it neglects.
    pub fn bound(&self) -> f64 {
        (self.first_order - self.beyond_class).max(0.0)
    }
}

/// Determinant ratio that every contact keeps where nothing else is asked for.
pub const DEFAULT_LEAST_DETERMINANT: f64 = 0.1;
/// Largest margin dressed beyond the used worm width, mm.
pub(super) const LARGEST_DRESSING_MARGIN: f64 = 48.0;
/// Distance of the contacts from the ends of the finished worm, mm: room for the search of a check of the plan.
const CONTACT_MARGIN: f64 = 1.5;
/// Tolerances that half the range of a target may be for a fit to be worth its time.
const TOO_MUCH: f64 = 100.0;
/// Share of the tolerance within which a plan with edges is taken as it is.
const WELL_WITHIN: f64 = 0.4;
/// Share of the tolerance within which a cheaper ratio is taken.
const HALF: f64 = 0.5;
/// Outer rounds with the worm as dressed.
const OUTER_ROUNDS: usize = 3;

/// The dresser, the tool's flanks and the errors that they leave.
type Equipment = (Option<DresserTool>, Sides<Option<PlannedTool>>, GroundError);

/// A plan with its tool.
pub(super) struct Equipped {
    pub ideal: IdealPlan,
    pub dresser: Option<DresserTool>,
    pub flanks: Sides<Option<PlannedTool>>,
    pub error: GroundError,
    /// Length of the tool beyond the used width, mm.
    pub margin: f64,
}

/// Largest errors per flank by round of precompensation, mm.
pub(super) struct Records {
    /// With the ideal tool.
    pub ideal: Sides<Vec<f64>>,
    /// With the tool as dressed.
    pub dressed: Sides<Vec<f64>>,
}

/// Points of the planning grid over profile and face width: for polynomials (`docs/mathematics/planning.md#choice-of-the-ratio`), and where
/// reliefs and waves stand on the tool's lines.
const PLANNING_GRIDS: [[usize; 2]; 2] = [[9, 9], [17, 41]];

/// What the best constant misses of some values.
fn half_range(values: impl IntoIterator<Item = f64>) -> f64 {
    let [low, high] = extremes(values);
    0.5 * (high - low)
}

impl PlanTask<'_> {
    pub(super) fn rule<'a>(&'a self, grid: &'a PlanningGrid) -> Rule<'a> {
        Rule {
            setup: self.setup,
            targets: &self.targets,
            grid,
            limits: self.limits,
            tolerance: self.tolerance,
            free_dresser: self.free_dresser,
            norm: self.norm,
            gauge: self.gauge,
            dressing: self.dressing,
            least_determinant: self.least_determinant,
            tolerance_map: self.tolerance_map.as_ref(),
            search: Search::Scan,
        }
    }

    /// Whether polynomials tell the whole plan.
    pub(super) fn is_smooth(&self) -> bool {
        let bare = |t: &Option<FlankTarget>| t.as_ref().is_none_or(|t| t.rest.is_empty());
        self.law.is_none()
            && self.targets.iter().all(|(_, t)| bare(t))
            && matches!(self.setup.tool, Tool::Dressed(_))
            && self.setup.strokes.is_none()
    }

    /// The grid on which the plan is judged.
    pub fn planning_grid(&self) -> PlanningGrid {
        let [nw, nz] = PLANNING_GRIDS[usize::from(!self.is_smooth())];
        PlanningGrid::new(self.setup, nw, nz)
    }

    /// Chooses the diagonal ratio by the rule, or judges the given one.
    ///
    /// # Errors
    /// When nothing is allowed: the reason of the best candidate. A given ratio is refused only if it cannot be evaluated or
    /// needs more worm than there is.
    pub fn choose(&self, grid: &PlanningGrid) -> Result<RatioChoice, GeneratingError> {
        self.choose_or_tried(grid, Search::Scan).map_err(|refused| refused.error)
    }

    /// As [`PlanTask::choose`]; a refusal brings along what was tried.
    fn choose_or_tried(&self, grid: &PlanningGrid, search: Search) -> Result<RatioChoice, Box<NoPlan>> {
        let rule = Rule { search, ..self.rule(grid) };
        let first = *self.places.first().ok_or(GeneratingError::NoFlank)?;
        // Without shift no motion makes a profile but that of dressing.
        let place = if self.corrects_profile_without_shift() { ProfilePlace::Correction } else { first };
        let (feed, rounds) = match (&self.law, self.ratio) {
            (Some(law), _) => (FeedLaw::Law(law.clone()), ROUNDS),
            (None, Some(ratio)) => (FeedLaw::Ratio(ratio), 0),
            (None, None) if self.gauge == PlanGauge::EqualSwivel => match self.swivel_ratio(place)? {
                EqualSwivel::Ratio(ratio) => (FeedLaw::Ratio(ratio), 0),
                EqualSwivel::Every => return rule.choose(&self.places),
            },
            (None, None) => return rule.choose(&self.places),
        };
        let which = rule.which();
        let shift = feed.law(self.setup, &which);
        let [from, to] = self.setup.occupation(&shift, &which);
        // The mean slope stands for a law.
        let [first, last] = self.setup.feed_range(&shift, &which);
        let mean = (shift.value(last) - shift.value(first)) / (last - first);
        let ratio = feed.ratio().unwrap_or(mean);
        rule.check_width(to - from, ratio)?;
        let candidate = match feed {
            FeedLaw::Ratio(ratio) if ratio != 0.0 => rule.judge(ratio, place)?,
            _ => {
                let policy = rule.policy(place);
                let (plan, error, _) = precompensate(self.setup, &self.targets, grid, &feed, policy, rounds)?;
                let occupation = plan.occupation[1] - plan.occupation[0];
                Candidate {
                    ratio,
                    place,
                    dressing_share: 0.0,
                    delta_d_share: 0.0,
                    occupation,
                    feed_travel: last - first,
                    error: error.max(),
                    residuals: FlankResidual::of(self.setup, &plan, &error),
                    determinant: error.determinant,
                    refusal: None,
                }
            }
        };
        Ok(RatioChoice {
            ratio,
            place,
            reason: match (&self.law, self.ratio) {
                (Some(_), _) => RatioReason::Law,
                (None, Some(_)) => RatioReason::Given,
                (None, None) => RatioReason::EqualSwivel,
            },
            lead_correction: rule.lead_corrections(place),
            demanded: rule.demanded(),
            candidates: vec![candidate],
            failed: Vec::new(),
        })
    }

    /// Whether the dressing motion is to make the profile of a gear that is ground without shift: on its own it often has no room to.
    fn corrects_profile_without_shift(&self) -> bool {
        self.ratio == Some(0.0) && self.law.is_none() && self.places == [ProfilePlace::Correction]
    }

    /// Both flanks as the question of equal swivel has them.
    fn swivel_sides(&self, place: ProfilePlace) -> Result<Sides<SwivelSide>, GeneratingError> {
        Sides::try_from_fn(|flank| {
            let target = self.targets[flank].as_ref().ok_or(GeneratingError::NoFlank)?;
            SwivelSide::of_target(self.setup, flank, &target.polynomial, place == ProfilePlace::Diagonal)
        })
    }

    fn swivel_ratio(&self, place: ProfilePlace) -> Result<EqualSwivel, GeneratingError> {
        equal_swivel(&self.swivel_sides(place)?)
    }

    /// Constants at which neither flank asks for a swivel in the middle of the tool.
    fn swivel_constants(
        &self,
        ratio: f64,
        place: ProfilePlace,
    ) -> Result<Sides<Option<FreeCoefficients>>, GeneratingError> {
        let sides = self.swivel_sides(place)?;
        let origin = FeedLaw::Ratio(ratio).law(self.setup, &Flank::BOTH).value(0.0);
        Ok(sides.map(|_, side| {
            let lines = &side.lines;
            let t = lines.work_direction(ratio);
            let middle = (t * lines.w_m + lines.z_m) / t.hypot(1.0);
            let [k_10, k_11] = side.linear_part(ratio, origin, 0.0, 0.0);
            Some(FreeCoefficients { k_10: k_10 + k_11 * middle, k_20: None, k_k0: 0.0 })
        }))
    }

    /// Judges one constant ratio by the same rule, with the better of the allowed places of the profile crowning.
    ///
    /// # Errors
    /// Only if the ratio cannot be evaluated; what forbids it stands in [`Candidate::refusal`].
    pub fn judge(&self, grid: &PlanningGrid, ratio: f64) -> Result<Candidate, GeneratingError> {
        self.rule(grid).judge_places(ratio, &self.places)
    }

    /// Ratios worth a study, ascending: the scan of the rule over both signs (`docs/mathematics/planning.md#choice-of-the-ratio`), 0, the
    /// lead-correction ratios K* and those that directed parts of the target demand.
    pub fn worth_studying(&self, grid: &PlanningGrid) -> Vec<f64> {
        self.rule(grid).worth_studying(&self.places)
    }

    /// Ratios that lay the tool's lines onto the directed parts of the target, per flank.
    pub fn demanded(&self, grid: &PlanningGrid) -> Sides<Vec<f64>> {
        self.rule(grid).demanded()
    }

    /// Plans.
    ///
    /// # Errors
    /// See [`GeneratingError`]; [`GeneratingError::is_bad_input`] tells impossible input from an unreachable target.
    pub fn plan(&self) -> Result<GrindingPlan, GeneratingError> {
        self.plan_or_tried().map_err(|refused| refused.error)
    }

    /// By closed decomposition and the rules of the ratio; a refusal brings along the candidates that were judged.
    ///
    /// # Errors
    /// [`NoPlan`].
    pub fn plan_by_rules(&self) -> Result<GrindingPlan, Box<NoPlan>> {
        self.ruled(Search::Scan)
    }

    fn ruled(&self, search: Search) -> Result<GrindingPlan, Box<NoPlan>> {
        let grid = self.planning_grid();
        let choice = self.choose_or_tried(&grid, search)?;
        let (candidates, failed) = (choice.candidates.clone(), choice.failed.clone());
        if search == Search::Named
            && let Some(error) = self.hardly_sound(&choice)
            && !self.asks_too_much()
        {
            return Err(Box::new(NoPlan { error, candidates, failed }));
        }
        if let Some(plan) = self.cheaper(&grid, &choice) {
            return Ok(plan);
        }
        let planned = match self.plan_with(&grid, choice.clone()) {
            // More than the dressing motion can make: the target is missed by its profile.
            Err(_) if self.corrects_profile_without_shift() => {
                self.plan_with(&grid, RatioChoice { place: ProfilePlace::Diagonal, ..choice })
            }
            planned => planned,
        };
        planned.map_err(|error| Box::new(NoPlan { error, candidates, failed }))
    }

    /// The plan of a ratio that costs less than the chosen one, where there is one that keeps to half the tolerance.
    fn cheaper(&self, grid: &PlanningGrid, choice: &RatioChoice) -> Option<GrindingPlan> {
        if !self.precompensation {
            return None;
        }
        let cheaper = self.rule(grid).cheaper(self.prefer, choice)?;
        let keeps = |plan: &GrindingPlan| {
            self.deviation(plan) <= HALF * self.tolerance
                && plan.determinant >= self.least_determinant.max(LEAST_DETERMINANT)
                && self.keeps_to_the_worm(plan)
        };
        self.plan_with(grid, cheaper).ok().filter(keeps)
    }

    /// As [`PlanTask::plan`]; a refusal brings along the candidates that were judged. A plan that misses its target says how near any flank
    /// could come, where best fits know the bodies.
    ///
    /// # Errors
    /// [`NoPlan`].
    pub fn plan_or_tried(&self) -> Result<GrindingPlan, Box<NoPlan>> {
        if let Some(wanted) = &self.setup.wanted_worm {
            return self.plan_worm(wanted);
        }
        let mut plan = self.nearest_plan()?;
        if self.effort != Effort::Trial && self.may_be_fitted() && self.strain_of(&plan) > self.tolerance {
            plan.least = self.least_deviation(&plan);
        }
        Ok(plan)
    }

    /// By the rules ([`PlanTask::plan_by_rules`]), and where
    /// they miss the tolerance or find no plan, by one best fit of worm, dresser and motion to the whole target
    /// (`docs/mathematics/best-fit.md`), if that comes nearer.
    ///
    /// # Errors
    /// [`NoPlan`].
    fn nearest_plan(&self) -> Result<GrindingPlan, Box<NoPlan>> {
        if !self.may_be_fitted() {
            return self.plan_by_rules();
        }
        // A scan by the rules takes longer than a fit and seldom finds what serves a target with edges.
        let scans_later = self.ratio.is_none() && !self.is_smooth();
        let mut ruled = self.ruled(if scans_later { Search::Named } else { Search::Scan });
        if ruled.as_ref().is_ok_and(|plan| self.is_sound(plan)) || ruled.is_err() && self.asks_too_much() {
            return ruled;
        }
        let fitted = self.plan_by_fit(&ruled);
        if let (Effort::Further(_), Some(fitted)) = (self.effort, &fitted) {
            let instead_of = ruled.err();
            return Ok(GrindingPlan { instead_of, ..fitted.clone() });
        }
        if scans_later && self.effort != Effort::Trial {
            let enough = if self.prefer == Prefer::Accuracy { self.settled_at() } else { HALF };
            match fitted {
                Some(fitted) if self.strain_of(&fitted) <= enough * self.tolerance => return Ok(fitted),
                _ => ruled = self.plan_by_rules(),
            }
        }
        match (fitted, ruled) {
            (Some(fitted), Ok(ruled)) if self.strain_of(&fitted) < self.strain_of(&ruled) => Ok(fitted),
            (Some(fitted), Err(refused)) => Ok(GrindingPlan { instead_of: Some(refused), ..fitted }),
            (_, ruled) => ruled,
        }
    }

    /// Whether the target is so large against its tolerance that no fit comes near where the rules find nothing.
    fn asks_too_much(&self) -> bool {
        let grid = self.planning_grid();
        let of_flank = |flank: Flank| {
            let target = self.targets[flank].as_ref()?;
            grid.target(flank, target, self.setup.lines[flank].cos_b2).ok().map(half_range)
        };
        Flank::BOTH.into_iter().filter_map(of_flank).any(|half| half > TOO_MUCH * self.tolerance)
    }

    /// Share of the tolerance and least determinant ratio of a plan by the rules that needs no other: far enough from a fold and from the
    /// tolerance that points between those of a grid do not tell another tale.
    fn sound(&self) -> (f64, f64) {
        match self.prefer {
            Prefer::Accuracy => (self.settled_at(), LEAST_DETERMINANT),
            Prefer::Worm | Prefer::Time if self.is_smooth() => (1.0, 0.0),
            Prefer::Worm | Prefer::Time => (WELL_WITHIN, LEAST_DETERMINANT),
        }
    }

    /// Whether a plan by the rules needs no other.
    fn is_sound(&self, plan: &GrindingPlan) -> bool {
        let (share, least) = self.sound();
        self.deviation(plan) <= share * self.tolerance
            && plan.determinant >= self.least_determinant.max(least)
    }

    /// Why a ratio will hardly become a sound plan, as its ideal tool tells.
    fn hardly_sound(&self, choice: &RatioChoice) -> Option<GeneratingError> {
        let chosen = choice.candidates.iter().find(|c| c.ratio == choice.ratio && c.place == choice.place)?;
        let (share, least) = self.sound();
        let allowed = share * self.tolerance;
        (chosen.error > allowed || chosen.determinant < least).then_some(GeneratingError::ModelError {
            ratio: chosen.ratio,
            error_um: chosen.error * 1e3,
            allowed_um: allowed * 1e3,
        })
    }

    /// What speaks against a plan: its deviation, mm, and more than any deviation a contact beyond the least determinant ratio.
    pub(super) fn strain_of(&self, plan: &GrindingPlan) -> f64 {
        if plan.determinant < self.least_determinant { f64::INFINITY } else { self.deviation(plan) }
    }

    /// What an unmodified flank in the best place would miss of the target of a plan, normal, mm.
    pub(super) fn unmodified(&self, plan: &GrindingPlan) -> f64 {
        let of_flank = |flank: Flank| Some(half_range(plan.flanks[flank].as_ref()?.target.iter().copied()));
        Flank::BOTH.into_iter().filter_map(of_flank).fold(0.0, f64::max)
    }

    /// Largest distance of a plan to the target on its result grid and between, what is only best-fitted included, normal, mm. With a map of
    /// the tolerance on its grid, each distance by what the tolerance there is over the tightest.
    pub(super) fn deviation(&self, plan: &GrindingPlan) -> f64 {
        let of_flank = |flank: Flank| {
            let made = plan.flanks[flank].as_ref()?;
            let distances = made.planned.iter().zip(&made.target).map(|(at, target)| (at.f_n - target).abs());
            if let Some(map) = &self.tolerance_map {
                let places = made.w.iter().flat_map(|&w| made.z.iter().map(move |&z| (w, z)));
                let weighed = distances.zip(places).map(|(off, (w, z))| off / map.value(w, z));
                return Some(weighed.fold(0.0, f64::max) * self.tolerance);
            }
            let off = distances;
            let outside = plan.ideal.outside[flank] * self.setup.lines[flank].cos_b2;
            Some(off.fold(plan.between[flank].max(outside), f64::max))
        };
        Flank::BOTH.into_iter().filter_map(of_flank).fold(0.0, f64::max)
    }

    fn plan_with(&self, grid: &PlanningGrid, choice: RatioChoice) -> Result<GrindingPlan, GeneratingError> {
        let mut policy = self.rule(grid).policy(choice.place);
        if self.gauge == PlanGauge::EqualSwivel {
            policy.gauge = self.swivel_constants(choice.ratio, choice.place)?;
        }
        let feed = match &self.law {
            Some(law) => FeedLaw::Law(law.clone()),
            None => FeedLaw::Ratio(choice.ratio),
        };
        let rounds = match (self.precompensation, self.is_smooth()) {
            (false, _) => 0,
            (true, true) => ROUNDS,
            (true, false) => FREE_ROUNDS,
        };
        let (ideal, ideal_error, ideal_record) =
            precompensate(self.setup, &self.targets, grid, &feed, policy, rounds)?;
        let mut best = self.equip(ideal, policy, grid)?;
        let mut dressed_record = Sides::from_fn(|f| best.error.largest(f).into_iter().collect::<Vec<_>>());
        if self.precompensation {
            for _ in 0..OUTER_ROUNDS {
                if best.error.max() - ideal_error.max() <= f64::min(0.1 * self.tolerance, 1e-5) {
                    break;
                }
                let command = corrected(self.setup, grid, &best.ideal, &best.error);
                let next = best
                    .ideal
                    .commanding(self.setup, &self.targets, command, policy)
                    .and_then(|ideal| self.equip(ideal, policy, grid));
                let Ok(next) = next else { break };
                for flank in Flank::BOTH {
                    dressed_record[flank].extend(next.error.largest(flank));
                }
                // What the worm as dressed leaves may ask far more of the axes than the command that was judged.
                let chosen = self.ratio.is_none() && self.law.is_none();
                let beyond = chosen && self.dressing_share(&next).0 > 1.0;
                if next.error.max() >= best.error.max() || beyond {
                    break;
                }
                best = next;
            }
        }
        let records = Records { ideal: ideal_record, dressed: dressed_record };
        self.finish(best, choice, policy, grid, records)
    }

    /// The plan of a tool that is settled: enough of it for every contact, and the flank on the result grid.
    pub(super) fn finish(
        &self,
        mut best: Equipped,
        choice: RatioChoice,
        policy: ProfilePolicy,
        grid: &PlanningGrid,
        records: Records,
    ) -> Result<GrindingPlan, GeneratingError> {
        let result_grid = PlanningGrid::new(self.setup, self.grid.0, self.grid.1);
        let flanks = loop {
            let flank_plan = |flank: Flank| self.flank_plan(flank, &best, &result_grid);
            let (left, right) = rayon::join(|| flank_plan(Flank::Left), || flank_plan(Flank::Right));
            let flanks = Sides { left: left?, right: right? };
            if best.margin >= LARGEST_DRESSING_MARGIN || self.within_finished_area(&best, &flanks) {
                break flanks;
            }
            let margin = 2.0 * best.margin;
            let (dresser, tools, error) = self.equip_with(&best.ideal, policy, grid, margin)?;
            best = Equipped { ideal: best.ideal, dresser, flanks: tools, error, margin };
        };
        let fitted = choice.reason == RatioReason::BestFit;
        let between = if self.is_smooth() && !fitted {
            Sides::both(0.0)
        } else {
            let shift = &best.ideal.motion.shift;
            let errors = [result_grid.between(), result_grid.along_traces()].map(|inner| {
                let ground = |flank: Flank| {
                    let tool = best.flanks[flank].as_ref()?;
                    Some(tool.ground(self.setup, flank, &inner, &best.ideal.motion))
                };
                GroundError::of(self.setup, &self.targets, &inner, shift, ground, |_, _| None)
            });
            let [cells, traces] = errors;
            let (cells, traces) = (cells?, traces?);
            let of = |error: &GroundError, flank: Flank| error.largest(flank).unwrap_or(0.0);
            Sides::from_fn(|flank| f64::max(of(&cells, flank), of(&traces, flank)))
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
            dresser: best.dresser,
            flanks,
            ideal_error_by_round: records.ideal,
            dressed_error_by_round: records.dressed,
            determinant,
            between,
            instead_of: None,
            least: None,
        })
    }

    /// Makes the tool for an ideal plan; where the contact shift of a large modification leaves its length, more of it is made.
    pub(super) fn equip(
        &self,
        ideal: IdealPlan,
        policy: ProfilePolicy,
        grid: &PlanningGrid,
    ) -> Result<Equipped, GeneratingError> {
        let mut margin = DRESSING_MARGIN;
        loop {
            match self.equip_with(&ideal, policy, grid, margin) {
                Ok((dresser, flanks, error)) => {
                    return Ok(Equipped { ideal, dresser, flanks, error, margin });
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

    fn equip_with(
        &self,
        ideal: &IdealPlan,
        policy: ProfilePolicy,
        grid: &PlanningGrid,
        margin: f64,
    ) -> Result<Equipment, GeneratingError> {
        let (dresser, flanks) = self.tools(ideal, policy, margin)?;
        let ground = |flank: Flank| {
            flanks[flank].as_ref().map(|tool| tool.ground(self.setup, flank, grid, &ideal.motion))
        };
        let foot = |flank: Flank, at: &ContactSolution| flanks[flank].as_ref()?.foot(at);
        let error = GroundError::of(self.setup, &self.targets, grid, &ideal.motion.shift, ground, foot)?;
        Ok((dresser, flanks, error))
    }

    /// The dresser of a plan and the flanks of the tool that it leaves.
    pub(super) fn tools(
        &self,
        ideal: &IdealPlan,
        policy: ProfilePolicy,
        margin: f64,
    ) -> Result<(Option<DresserTool>, Sides<Option<PlannedTool>>), GeneratingError> {
        let dresser = match (&self.setup.tool, &self.setup.strokes) {
            (Tool::Dressed(_), Some(layout)) => layout.dressers.first().cloned(),
            (Tool::Dressed(_), None) => Some(dresser_of_plan(self.setup, ideal, policy)?),
            (Tool::Made | Tool::Given(_), _) => None,
        };
        let flanks = match (&dresser, &self.setup.strokes) {
            (Some(_), Some(layout)) => {
                let dress = |flank: Flank| {
                    let worm = ideal.worms[flank].as_ref();
                    worm.map(|_| StrokedFlank::solve(self.setup, layout, ideal, flank, margin)).transpose()
                };
                let (left, right) = rayon::join(|| dress(Flank::Left), || dress(Flank::Right));
                let tool = |stroked: StrokedFlank| PlannedTool::Stroked(Box::new(stroked));
                Sides { left: left?.map(tool), right: right?.map(tool) }
            }
            (Some(dresser), None) => {
                let Sides { left, right } = dress_flanks(self.setup, ideal, dresser, policy, margin)?;
                let tool = |dressed: DressedFlank| PlannedTool::Dressed(Box::new(dressed));
                Sides { left: left.map(tool), right: right.map(tool) }
            }
            (None, _) => {
                let make = |flank: Flank| {
                    let worm = ideal.worms[flank].as_ref();
                    worm.map(|_| MadeFlank::of_plan(self.setup, ideal, flank, margin)).transpose()
                };
                let (left, right) = rayon::join(|| make(Flank::Left), || make(Flank::Right));
                Sides { left: left?.map(PlannedTool::Made), right: right?.map(PlannedTool::Made) }
            }
        };
        Ok((dresser, flanks))
    }

    /// Whether a tool that is dressed in one stroke is touched on its finished part only.
    fn keeps_to_the_worm(&self, plan: &GrindingPlan) -> bool {
        plan.flanks.iter().filter_map(|(flank, plan)| Some((flank, plan.as_ref()?))).all(|(flank, plan)| {
            let (PlannedTool::Dressed(_), Ok(beyond)) = (&plan.tool, self.beyond(flank)) else { return true };
            plan.planned.iter().all(|at| plan.tool.foot(at).is_some_and(|(w, _)| beyond(w) <= 0.0))
        })
    }

    /// Whether every contact on the tool lies inside the finished area with [`CONTACT_MARGIN`] to spare.
    fn within_finished_area(&self, best: &Equipped, flanks: &Sides<Option<FlankPlan>>) -> bool {
        flanks.iter().filter_map(|(flank, plan)| plan.as_ref().map(|plan| (flank, plan))).all(
            |(flank, plan)| {
                let [from, to] = plan.tool.length(self.setup, best.dresser.as_ref(), flank);
                plan.planned.iter().all(|at| {
                    plan.tool
                        .foot(at)
                        .is_some_and(|(_, z)| z > from + CONTACT_MARGIN && z < to - CONTACT_MARGIN)
                })
            },
        )
    }

    fn flank_plan(
        &self,
        flank: Flank,
        best: &Equipped,
        grid: &PlanningGrid,
    ) -> Result<Option<FlankPlan>, GeneratingError> {
        let (Some(tool), Some(target)) = (&best.flanks[flank], &self.targets[flank]) else {
            return Ok(None);
        };
        let planned = tool.ground(self.setup, flank, grid, &best.ideal.motion)?;
        let wanted = grid.target(flank, target, self.setup.lines[flank].cos_b2)?;
        Ok(Some(FlankPlan {
            tool: tool.clone(),
            w: grid.w[flank].clone(),
            z: grid.z.clone(),
            target: wanted,
            planned,
        }))
    }
}

impl PlannedTool {
    /// The exact flank that this tool leaves, by grid point.
    ///
    /// # Errors
    /// Those of the exact contact.
    pub fn ground(
        &self,
        setup: &GrindingSetup,
        flank: Flank,
        grid: &PlanningGrid,
        motion: &GeneratingMotion,
    ) -> Result<Vec<ContactSolution>, GeneratingError> {
        match self {
            Self::Dressed(dressed) => grid.ground(setup, flank, motion, &dressed.worm),
            Self::Stroked(stroked) => stroked.ground(setup, flank, grid, motion),
            Self::Made(made) => grid.ground(setup, flank, motion, &made.surface(setup, flank)),
        }
    }

    /// The point (w_1, z_1) of the unmodified flank under a contact, mm.
    pub(super) fn foot(&self, at: &ContactSolution) -> Option<(f64, f64)> {
        let (p, q) = at.tool;
        match self {
            Self::Dressed(dressed) => dressed.worm.envelope_point(p, q).map(|foot| (foot.w, foot.b)),
            Self::Stroked(_) | Self::Made(_) => Some((p, q)),
        }
    }

    /// From where to where on the tool the flank is finished, z_1, mm.
    fn length(&self, setup: &GrindingSetup, dresser: Option<&DresserTool>, flank: Flank) -> [f64; 2] {
        match (self, dresser) {
            (Self::Dressed(dressed), Some(dresser)) => {
                FinishedArea::new(setup, dresser, flank, &dressed.corrections).z
            }
            (Self::Dressed(_), None) => [0.0; 2],
            (Self::Stroked(stroked), _) => stroked.area.1,
            (Self::Made(made), _) => made.spline.domain()[1],
        }
    }
}
