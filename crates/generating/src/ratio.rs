//! The diagonal ratio "auto" (`docs/mathematics/planning.md#choice-of-the-ratio`): candidates, their score and why one of them is taken.

use super::dressed::{asks_corrections, dresser_of_plan, sample_corrections};
use super::least_squares::FitNorm;
use super::planning_grid::GroundError;
use super::precompensation::{ROUNDS, precompensate};
use super::{
    DressingLimits, DressingRows, FeedLaw, FlankLines, FlankTarget, GeneratingError, GrindingSetup,
    IdealPlan, IdealWorm, PlanGauge, PlanningGrid, ProfilePlace, ProfilePolicy, SeriesRule, Tool,
    radial_residual,
};
use contact::FOLD_BEGINS;
use foundation::geometry::{Flank, Sides};
use foundation::modification::ToleranceMap;
use foundation::numerics::Polynomial2;
use rayon::prelude::*;

/// What the ideal tool misses of the target on one flank, on the planning grid. Normal, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlankResidual {
    /// Largest |target - ground|.
    pub largest: f64,
    /// Its root mean square.
    pub rms: f64,
    /// Largest part of the target that is best-fitted only; the grid may miss it (a wave between its points).
    pub outside: f64,
}

impl FlankResidual {
    /// Of the flanks that are ground.
    pub(super) fn of(
        setup: &GrindingSetup,
        plan: &IdealPlan,
        error: &GroundError,
    ) -> Sides<Option<FlankResidual>> {
        Sides::from_fn(|flank| {
            Some(FlankResidual {
                largest: error.largest(flank)?,
                rms: error.rms(flank)?,
                outside: plan.outside[flank] * setup.lines[flank].cos_b2,
            })
        })
    }
}

/// One judged ratio.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// K.
    pub ratio: f64,
    /// Place of the profile crowning.
    pub place: ProfilePlace,
    /// max |DK_j|/limit_j.
    pub dressing_share: f64,
    /// max |Delta_d|/limit.
    pub delta_d_share: f64,
    /// Used worm width, mm.
    pub occupation: f64,
    /// Travel of the feed without overrun, mm.
    pub feed_travel: f64,
    /// Largest error of the ideal worm, mm.
    pub error: f64,
    /// What it misses per flank; `None` for a flank that is not ground.
    pub residuals: Sides<Option<FlankResidual>>,
    /// Least determinant ratio of its contacts on the planning grid.
    pub determinant: f64,
    /// Why it is not allowed, if so.
    pub refusal: Option<GeneratingError>,
}

impl Candidate {
    /// S(K).
    pub fn score(&self) -> f64 {
        self.dressing_share.max(self.delta_d_share)
    }
}

/// Which rule settled the ratio.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RatioReason {
    /// Given in the job.
    Given,
    /// The ratio at which both flanks ask for the same swivel of the dresser.
    EqualSwivel,
    /// The radial method suffices.
    RadialSuffices,
    /// K* is the same on both flanks (or one flank is ground).
    LeadCorrection,
    /// Compromise between flanks by golden section of the score.
    Compromise,
    /// Scan over both signs.
    Scan,
    /// The least used width of the worm within half the tolerance and half the limits of the axes.
    LeastWorm,
    /// The least travel of the feed within these.
    LeastTravel,
    /// No ratio is exact enough: the one of least error.
    LeastError,
    /// The ratio that lays the tool's lines onto reliefs or waves of the target.
    LinesOfTarget,
    /// The ratio of the best fit to the whole target.
    BestFit,
    /// A law of the feed, given in the job or made for its areas.
    Law,
}

/// The chosen ratio and how it was found.
#[derive(Clone, Debug)]
pub struct RatioChoice {
    /// K.
    pub ratio: f64,
    /// Place of the profile crowning.
    pub place: ProfilePlace,
    /// Rule.
    pub reason: RatioReason,
    /// K* per flank for that place.
    pub lead_correction: Sides<Option<f64>>,
    /// Ratios per flank that lay the tool's lines onto reliefs and waves of the target.
    pub demanded: Sides<Vec<f64>>,
    /// All candidates judged, in order.
    pub candidates: Vec<Candidate>,
    /// Candidates that failed with an error.
    pub failed: Vec<(f64, GeneratingError)>,
}

/// How far a ratio is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Search {
    /// The ratios that the target names: those of its lines, 0 and K*.
    Named,
    /// And a scan over both signs.
    Scan,
}

/// Why there is no plan, with what was judged on the way.
#[derive(Clone, Debug)]
pub struct NoPlan {
    /// The error.
    pub error: GeneratingError,
    /// Candidates that were judged, in order.
    pub candidates: Vec<Candidate>,
    /// Ratios that could not be judged.
    pub failed: Vec<(f64, GeneratingError)>,
}

impl From<GeneratingError> for Box<NoPlan> {
    fn from(error: GeneratingError) -> Self {
        Box::new(NoPlan { error, candidates: Vec::new(), failed: Vec::new() })
    }
}

/// K*: the ratio at which the worm needs no part linear in w, for target polynomial `a` with `p_2` in the profile.
/// `None` when any direction does it (pure profile target) or none.
pub fn lead_correction_ratio(lines: &FlankLines, a: &Polynomial2, p_2: f64) -> Option<f64> {
    let m = lines.profile_slope();
    let a_20 = a.coefficient(2, 0) - p_2;
    let (a_11, a_02) = (a.coefficient(1, 1) - 2.0 * m * p_2, a.coefficient(0, 2) - m * m * p_2);
    let n = 2.0 * a_02 * lines.t_k - a_11;
    // t* - t_K = -2 Q/N; N = 0 asks for profile lines, K* = 0.
    let q = a_20 - a_11 * lines.t_k + a_02 * lines.t_k * lines.t_k;
    let ratio = if n == 0.0 && q != 0.0 { 0.0 } else { lines.ratio_of_direction(lines.t_k - 2.0 * q / n) };
    ratio.is_finite().then_some(ratio)
}

/// Number of nodes at which a candidate's corrections are sampled.
const SCORE_NODES: usize = 5;
/// Precompensation rounds of a candidate.
const SCORE_ROUNDS: usize = 2;
/// Evaluations of the golden section.
const GOLDEN: usize = 9;
/// Ratios per sign in the scan.
const SCAN: usize = 24;
/// Least determinant ratio that the rule allows; a task may ask for more.
pub const LEAST_DETERMINANT: f64 = FOLD_BEGINS;

/// What the rule needs to know.
pub(super) struct Rule<'a> {
    pub setup: &'a GrindingSetup,
    pub targets: &'a Sides<Option<FlankTarget>>,
    pub grid: &'a PlanningGrid,
    pub limits: DressingLimits,
    /// mm.
    pub tolerance: f64,
    pub free_dresser: bool,
    pub norm: FitNorm,
    pub gauge: PlanGauge,
    pub dressing: DressingRows,
    /// Asked for by the task.
    pub least_determinant: f64,
    /// Where less than the tightest tolerance is asked for.
    pub tolerance_map: Option<&'a ToleranceMap>,
    /// Which ratios are tried.
    pub search: Search,
}

/// Names of the corrections of the dressing motion, in their order.
pub(super) const CORRECTION_AXES: [&str; 4] = ["d_phi_S", "d_gamma", "d_d", "d_v_yA"];
/// Share of the tolerance by which a part of the target may miss the tool's lines before it is best-fitted instead.
pub(super) const LINE_SHARE: f64 = 0.1;

impl Rule<'_> {
    /// Flanks that are ground.
    pub fn which(&self) -> Vec<Flank> {
        self.targets.iter().filter(|(_, t)| t.is_some()).map(|(f, _)| f).collect()
    }

    /// K* of the flanks that are ground, for a place of the profile crowning.
    pub fn lead_corrections(&self, place: ProfilePlace) -> Sides<Option<f64>> {
        Sides::from_fn(|flank| {
            let a = &self.targets[flank].as_ref()?.polynomial;
            let p_2 = if place == ProfilePlace::Diagonal { 0.0 } else { a.coefficient(2, 0) };
            lead_correction_ratio(&self.setup.lines[flank], a, p_2)
        })
    }

    /// Ratios that lay the tool's lines onto the directed parts of the target, per flank, each once.
    pub fn demanded(&self) -> Sides<Vec<f64>> {
        Sides::from_fn(|flank| {
            let mut ratios: Vec<f64> = Vec::new();
            for term in self.targets[flank].iter().flat_map(|t| &t.rest) {
                let Some(t) = term.line_direction() else { continue };
                let ratio = self.setup.lines[flank].ratio_of_direction(t);
                let known = ratios.iter().any(|k| (k - ratio).abs() <= 1e-9 * ratio.abs());
                if ratio.is_finite() && !known {
                    ratios.push(ratio);
                }
            }
            ratios
        })
    }

    /// Worm width needed for a used width: 1.5 modules and 3 mm at each end.
    pub fn width_needed(&self, occupation: f64) -> f64 {
        occupation + 2.0 * self.setup.run_in()
    }

    pub fn check_width(&self, occupation: f64, ratio: f64) -> Result<(), GeneratingError> {
        let needed = self.width_needed(occupation);
        match self.setup.input.worm_width {
            Some(width) if needed > width => Err(GeneratingError::WormTooShort { needed, width, ratio }),
            _ => Ok(()),
        }
    }

    /// The policy for a place of the profile crowning.
    pub fn policy(&self, place: ProfilePlace) -> ProfilePolicy {
        let line_tolerance = LINE_SHARE * self.tolerance;
        let gauge = match self.gauge {
            PlanGauge::Given(free) => Sides::both(Some(free)),
            PlanGauge::Centred | PlanGauge::EqualSwivel => Sides { left: None, right: None },
        };
        ProfilePolicy {
            series: SeriesRule::default(),
            place,
            free_dresser: self.free_dresser,
            line_tolerance,
            norm: self.norm,
            dressing: self.dressing,
            gauge,
        }
    }

    /// Judges a ratio; `Err` only if it cannot be evaluated, or where named ratios are sought and its ideal tool misses the target.
    pub fn judge(&self, ratio: f64, place: ProfilePlace) -> Result<Candidate, GeneratingError> {
        let policy = self.policy(place);
        let feed = FeedLaw::Ratio(ratio);
        let correct = |rounds| precompensate(self.setup, self.targets, self.grid, &feed, policy, rounds);
        let (mut plan, mut error, _) = correct(SCORE_ROUNDS)?;
        let weights = self.grid.weights(self.tolerance_map);
        if error.weighed_max(&weights) > self.tolerance / 2.0 {
            (plan, error, _) = correct(ROUNDS)?;
        }
        let off = error.weighed_max(&weights);
        let sound = || {
            let limit = LEAST_DETERMINANT.max(self.least_determinant);
            if error.determinant < limit {
                let ratio = error.determinant;
                return Err(GeneratingError::EnvelopeBroken { flank: self.which()[0], ratio, limit });
            }
            if off > self.tolerance / 2.0 {
                let (error_um, allowed_um) = (off * 1e3, self.tolerance * 500.0);
                return Err(GeneratingError::ModelError { ratio, error_um, allowed_um });
            }
            Ok(())
        };
        if self.search == Search::Named {
            // What the axes would be asked for takes most of the time, and another way is at hand.
            sound()?;
        }
        let mut dressing_share: f64 = 0.0;
        let mut worst = (0, 0.0);
        let makes_profile =
            |worm: &Option<IdealWorm>| worm.as_ref().is_some_and(|worm| asks_corrections(worm, policy));
        let corrected = ratio != 0.0 || plan.worms.iter().any(|(_, worm)| makes_profile(worm));
        let corrections = match &self.setup.tool {
            Tool::Dressed(_) if corrected => {
                let tool = dresser_of_plan(self.setup, &plan, policy)?;
                sample_corrections(self.setup, &plan, &tool, &self.which(), policy, SCORE_NODES)?
            }
            Tool::Dressed(plain) => {
                self.which().into_iter().map(|flank| plain.flanks[flank].settled).collect()
            }
            Tool::Made | Tool::Given(_) => Vec::new(),
        };
        for dk in corrections {
            for j in 0..4 {
                let share = dk[j].abs() / self.limits.correction[j];
                if share > dressing_share {
                    (dressing_share, worst) = (share, (j, dk[j].abs()));
                }
            }
        }
        let feeds = self.setup.feed_range(&plan.motion.shift, &self.which());
        let delta_d = (0..=16)
            .map(|k| plan.motion.delta_d.value(feeds[0] + (feeds[1] - feeds[0]) * f64::from(k) / 16.0).abs())
            .fold(0.0, f64::max);
        let delta_d_share = delta_d / self.limits.delta_d;
        let occupation = plan.occupation[1] - plan.occupation[0];
        let refusal = self
            .check_width(occupation, ratio)
            .and_then(|()| self.check_axes(dressing_share, worst, delta_d))
            .and_then(|()| sound())
            .err();
        Ok(Candidate {
            ratio,
            place,
            dressing_share,
            delta_d_share,
            occupation,
            feed_travel: feeds[1] - feeds[0],
            error: error.max(),
            residuals: FlankResidual::of(self.setup, &plan, &error),
            determinant: error.determinant,
            refusal,
        })
    }

    /// Judges a ratio with each place of the profile crowning: the better place if one is allowed, else the one of least
    /// error; `Err` only if none can be evaluated.
    pub fn judge_places(&self, ratio: f64, places: &[ProfilePlace]) -> Result<Candidate, GeneratingError> {
        let mut judged = Vec::new();
        let mut failure = None;
        for &place in places {
            match self.judge(ratio, place) {
                Ok(candidate) => judged.push(candidate),
                Err(error) => {
                    failure.get_or_insert(error);
                }
            }
        }
        let (allowed, refused): (Vec<_>, Vec<_>) = judged.into_iter().partition(|c| c.refusal.is_none());
        better(allowed, Candidate::score, |c| c.occupation)
            .or_else(|| refused.into_iter().min_by(|a, b| a.error.total_cmp(&b.error)))
            .ok_or_else(|| failure.unwrap_or(GeneratingError::NoFlank))
    }

    /// The factor between neighbours of the scan: geometric steps from 0.1 to twice the ratio for rho_2 = 0, without a worm
    /// width up to K* (`docs/mathematics/planning.md#choice-of-the-ratio`).
    fn scan_step(&self, stars: &Sides<Option<f64>>) -> f64 {
        let which = self.which();
        let level = |flank: Flank| self.setup.lines[flank].ratio_of_direction(0.0).abs();
        let reach = which.iter().map(|&f| level(f)).filter(|k| k.is_finite()).fold(0.0, f64::max);
        // A spur gear has no ratio for rho_2 = 0; the K that a worm of unit pitch would want serves as the scale.
        let mut top = if reach > 0.0 { 2.0 * reach } else { 4.0 };
        if self.setup.input.worm_width.is_none() {
            let stars = which.iter().filter_map(|&f| stars[f]).map(f64::abs).fold(0.0, f64::max);
            top = top.max(stars);
        }
        (top / 0.1).powf(1.0 / (SCAN - 1) as f64)
    }

    /// Ratios worth a study, ascending: those of the scan, 0, K* and what directed parts of the target demand.
    pub fn worth_studying(&self, places: &[ProfilePlace]) -> Vec<f64> {
        let mut ratios = vec![0.0];
        for &place in places {
            let stars = self.lead_corrections(place);
            let step = self.scan_step(&stars);
            ratios.extend((0..SCAN).flat_map(|k| {
                let size = scan_size(step, k);
                [-size, size]
            }));
            ratios.extend(self.which().into_iter().filter_map(|flank| stars[flank]));
        }
        ratios.extend(self.demanded().iter().flat_map(|(_, demanded)| demanded.iter().copied()));
        ratios.sort_by(f64::total_cmp);
        // The K* of both flanks of a symmetric job differ by rounding only.
        ratios.dedup_by(|b, a| (*b - *a).abs() <= 1e-9 * a.abs());
        ratios
    }

    pub(super) fn check_axes(
        &self,
        share: f64,
        (j, value): (usize, f64),
        delta_d: f64,
    ) -> Result<(), GeneratingError> {
        if share > 1.0 {
            let angle = j < 2;
            let convert = |x: f64| if angle { x.to_degrees() } else { x };
            return Err(GeneratingError::AxisLimit {
                axis: CORRECTION_AXES[j],
                value: convert(value),
                limit: convert(self.limits.correction[j]),
                unit: if angle { "deg" } else { "mm" },
            });
        }
        if delta_d > self.limits.delta_d {
            return Err(GeneratingError::AxisLimit {
                axis: "Delta_d",
                value: delta_d,
                limit: self.limits.delta_d,
                unit: "mm",
            });
        }
        Ok(())
    }

    /// Largest mixed residual of the class `radial` over the field, normal, mm.
    fn radial_residual(&self) -> f64 {
        let mut largest: f64 = 0.0;
        for flank in self.which() {
            let Some(target) = &self.targets[flank] else { continue };
            let lines = &self.setup.lines[flank];
            let [r11, r21, r12] = radial_residual(&target.polynomial, lines.t_k);
            let (hu, hy) = (0.5 * (lines.roll[1] - lines.roll[0]), 0.5 * (lines.face[1] - lines.face[0]));
            let here = (r11 * hu * hy).abs() + (r21 * hu * hu * hy).abs() + (r12 * hu * hy * hy).abs();
            let outside = if target.rest.is_empty() { 0.0 } else { target.outside };
            largest = largest.max((here + outside) * lines.cos_b2);
        }
        largest
    }

    /// Chooses K for the given places of the profile crowning.
    ///
    /// # Errors
    /// When no candidate is allowed: the refusal of the best one, with all that were tried.
    pub fn choose(&self, places: &[ProfilePlace]) -> Result<RatioChoice, Box<NoPlan>> {
        let mut choices = Vec::new();
        let mut refusal: Option<Box<NoPlan>> = None;
        for &place in places {
            match (self.choose_for(place), &mut refusal) {
                (Ok(choice), _) => choices.push(choice),
                (Err(further), Some(known)) => {
                    known.candidates.extend(further.candidates);
                    known.failed.extend(further.failed);
                }
                (Err(first), none) => *none = Some(first),
            }
        }
        let score = |c: &RatioChoice| best_of(&c.candidates).map_or(0.0, |b| b.score());
        let occupation = |c: &RatioChoice| best_of(&c.candidates).map_or(0.0, |b| b.occupation);
        better(choices, score, occupation)
            .ok_or_else(|| refusal.unwrap_or_else(|| GeneratingError::NoFlank.into()))
    }

    fn choose_for(&self, place: ProfilePlace) -> Result<RatioChoice, Box<NoPlan>> {
        let which = self.which();
        let stars = self.lead_corrections(place);
        let level = |flank: Flank| self.setup.lines[flank].ratio_of_direction(0.0);
        let mut choice = RatioChoice {
            ratio: 0.0,
            place,
            reason: RatioReason::RadialSuffices,
            lead_correction: stars,
            demanded: self.demanded(),
            candidates: Vec::new(),
            failed: Vec::new(),
        };
        let pure_profile_elsewhere = place == ProfilePlace::Diagonal
            && which.iter().any(|&f| {
                self.targets[f].as_ref().is_some_and(|t| t.polynomial.coefficient(2, 0).abs() > 0.0)
            });
        // Directed parts of the target name their ratios themselves.
        let demanded: Vec<f64> = choice.demanded.iter().flat_map(|(_, ratios)| ratios.clone()).collect();
        for &ratio in &demanded {
            self.try_ratio(ratio, &mut choice);
        }
        if let Some(best) = best_of(&choice.candidates).map(|c| c.ratio) {
            (choice.ratio, choice.reason) = (best, RatioReason::LinesOfTarget);
            return Ok(choice);
        }
        let radial = !pure_profile_elsewhere && self.radial_residual() < 0.1 * self.tolerance;
        if radial && self.try_ratio(0.0, &mut choice).is_finite() {
            return Ok(choice);
        }
        let found: Vec<f64> = which.iter().filter_map(|&f| stars[f]).collect();
        let same = found.len() == which.len()
            && found.iter().all(|k| (k - found[0]).abs() <= 1e-9 * found[0].abs())
            && found.first().is_some_and(|k| *k != 0.0);
        if same {
            self.try_ratio(found[0], &mut choice);
            if best_of(&choice.candidates).is_some_and(|c| c.ratio == found[0]) {
                choice.ratio = found[0];
                choice.reason = RatioReason::LeadCorrection;
                return Ok(choice);
            }
        } else if self.search == Search::Scan {
            let bounds: Vec<f64> = found
                .iter()
                .copied()
                .chain(which.iter().map(|&f| level(f)))
                .filter(|k| k.is_finite())
                .collect();
            let widest =
                1.6 * which.iter().map(|&f| level(f).abs()).filter(|k| k.is_finite()).fold(0.0, f64::max);
            for sign in [1.0, -1.0] {
                let mine: Vec<f64> =
                    bounds.iter().filter(|k| *k * sign > 0.0).map(|k| k.abs().min(widest)).collect();
                let (low, high) =
                    mine.iter().fold((f64::INFINITY, 0.0f64), |(l, h), &k| (l.min(k), h.max(k)));
                if mine.len() < 2 || high - low < 1e-9 * high {
                    continue;
                }
                foundation::numerics::golden_section(sign * low, sign * high, GOLDEN, |k| {
                    self.try_ratio(k, &mut choice)
                });
            }
            if let Some(best) = best_of(&choice.candidates).filter(|c| c.ratio != 0.0) {
                (choice.ratio, choice.reason) = (best.ratio, RatioReason::Compromise);
                return Ok(choice);
            }
        }
        let found = match self.search {
            Search::Named => Err(refusal_of(&choice)),
            Search::Scan => self.scan(&mut choice),
        };
        match found {
            Ok(()) => Ok(choice),
            Err(error) => {
                let RatioChoice { candidates, failed, .. } = choice;
                Err(Box::new(NoPlan { error, candidates, failed }))
            }
        }
    }

    fn scan(&self, choice: &mut RatioChoice) -> Result<(), GeneratingError> {
        let step = self.scan_step(&choice.lead_correction);
        let scanned = |k: usize| if k < SCAN { -scan_size(step, k) } else { scan_size(step, k - SCAN) };
        let judge = |ratio: f64| (ratio, self.judge(ratio, choice.place));
        let judged: Vec<_> = (0..2 * SCAN).into_par_iter().map(scanned).map(judge).collect();
        for (ratio, judged) in judged {
            record(ratio, judged, choice);
        }
        if let Some(best) = best_of(&choice.candidates).map(|c| c.ratio) {
            foundation::numerics::golden_section(best / step, best * step, GOLDEN, |k| {
                self.try_ratio(k, choice)
            });
        }
        let inexact = choice
            .candidates
            .iter()
            .filter(|c| matches!(c.refusal, Some(GeneratingError::ModelError { .. })))
            .min_by(|a, b| a.error.total_cmp(&b.error));
        match best_of(&choice.candidates).or(inexact) {
            Some(best) => {
                // A ratio that is only not exact enough is made all the same: the target is then missed with figures.
                let exact = best.refusal.is_none();
                choice.reason = if exact { RatioReason::Scan } else { RatioReason::LeastError };
                choice.ratio = best.ratio;
                Ok(())
            }
            None => Err(refusal_of(choice)),
        }
    }

    /// Judges a ratio and records it; the score, infinite if it is not allowed.
    fn try_ratio(&self, ratio: f64, choice: &mut RatioChoice) -> f64 {
        record(ratio, self.judge(ratio, choice.place), choice)
    }
}

/// Records a judged ratio; the score, infinite if it is not allowed.
fn record(ratio: f64, judged: Result<Candidate, GeneratingError>, choice: &mut RatioChoice) -> f64 {
    match judged {
        Ok(candidate) => {
            let score = if candidate.refusal.is_none() { candidate.score() } else { f64::INFINITY };
            choice.candidates.push(candidate);
            score
        }
        Err(error) => {
            choice.failed.push((ratio, error));
            f64::INFINITY
        }
    }
}

/// Why the best of the candidates is not allowed, or why there is none.
fn refusal_of(choice: &RatioChoice) -> GeneratingError {
    let least = choice.candidates.iter().min_by(|a, b| a.score().total_cmp(&b.score()));
    let refusal = least.and_then(|c| c.refusal.clone());
    refusal.or_else(|| choice.failed.first().map(|f| f.1.clone())).unwrap_or(GeneratingError::NoFlank)
}

/// |K| of the k-th step of the scan.
fn scan_size(step: f64, k: usize) -> f64 {
    0.1 * step.powi(k as i32)
}

/// The best score; within 5 percent of it the shorter used worm width decides (`docs/mathematics/planning.md#choice-of-the-ratio`).
fn better<T>(of: Vec<T>, score: impl Fn(&T) -> f64, occupation: impl Fn(&T) -> f64) -> Option<T> {
    let least = of.iter().map(&score).fold(f64::INFINITY, f64::min);
    of.into_iter().filter(|c| score(c) <= 1.05 * least).min_by(|a, b| occupation(a).total_cmp(&occupation(b)))
}

/// The allowed candidate of least score.
pub(super) fn best_of(candidates: &[Candidate]) -> Option<&Candidate> {
    candidates.iter().filter(|c| c.refusal.is_none()).min_by(|a, b| a.score().total_cmp(&b.score()))
}
