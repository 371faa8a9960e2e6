//! From the ideal worm to the dressed one: dresser profile, corrections DK(v), exact envelope
//! (`docs/mathematics/planning.md#from-the-ratio-to-the-flank`).

use super::moved_profile::{with_head_for, worm_roll_of};
use super::{
    DressingRows, GeneratingError, GrindingSetup, IdealPlan, IdealWorm, ProfilePlace, ProfilePolicy,
    SeriesRule, WormTip,
};
use contact::ThreadFunction;
use dressing::{
    ConditionSolver, DressedProfile, DressedWorm, DresserTool, FlankDresser, NodePlan, NodeSolution,
    PitchPlace, RowAlong, RowMiss, RowsAlong, missed_rows, pitch_rolls, solve_dressing_motion,
    solve_rows_along,
};
use foundation::geometry::{Flank, ProfileOffset, Sides};
use foundation::kinematics::{DressingCorrection, MotionLaw};
use foundation::numerics::{Chebyshev, equidistant, extremes};
use std::sync::Arc;

/// Profile of the dresser that leaves F_P and the reliefs on the gear: g(t) = cos b2 F_P(u(w_1(t))), mm.
#[derive(Debug)]
struct GearProfile {
    worm: IdealWorm,
    plain: FlankDresser,
}

impl ProfileOffset for GearProfile {
    fn jet(&self, t: f64) -> [f64; 3] {
        let l = &self.worm.lines;
        let shrink = -l.cos_b2 / l.cos_b1 * (self.plain.range.length() / self.plain.designed.length());
        let w_1 = worm_roll_of(&self.plain, t);
        // Where an arc ends its circle the offset is not defined; NaN makes the point "no contact" further on.
        let [f, f1, f2] = self.worm.profile_share(l.work_roll(w_1)).unwrap_or([f64::NAN; 3]);
        [l.cos_b2 * f, l.cos_b2 * f1 * shrink, l.cos_b2 * f2 * shrink * shrink]
    }
}

/// Margin of the dressed length beyond the used worm width, mm: the contact shift of a modified worm stays below it.
pub const DRESSING_MARGIN: f64 = 3.0;
/// Most nodes for reliefs and waves on the worm's lines.
pub(super) const MOST_NODES: usize = 257;

/// The last quarter of the coefficients, as an amount on the worm flank, mm: each component times its influence (base radius
/// for the phase; orders of magnitude for crossing angle, distance and offset).
pub(super) fn tail(series: &[Chebyshev; 4], lever: [f64; 4]) -> f64 {
    let quarter = |c: &Chebyshev| {
        let c = c.coefficients();
        c[c.len() - c.len() / 4..].iter().map(|c| c.abs()).sum::<f64>()
    };
    series.iter().zip(lever).map(|(c, lever)| quarter(c) * lever).fold(0.0, f64::max)
}

/// One flank of the worm as dressed.
#[derive(Clone, Debug)]
pub struct DressedFlank {
    /// DK over v: rad, rad, mm, mm.
    pub corrections: [Chebyshev; 4],
    /// Solved nodes.
    pub nodes: Vec<NodeSolution>,
    /// What the nodes leave of each row, mm or rad; empty where all rows are met exactly.
    pub missed: Vec<RowMiss>,
    /// The exact envelope.
    pub worm: DressedWorm,
}

/// A dressing motion over v.
#[derive(Clone)]
struct Motion {
    /// DK over v.
    corrections: [Chebyshev; 4],
    /// Solved nodes.
    nodes: Vec<NodeSolution>,
    /// What they leave of each row; empty where all rows are met exactly.
    missed: Vec<RowMiss>,
}

/// Continuation of the used profile at each end, as a share of it, over which a worm counts as finished.
const FINISHED_PROFILE: f64 = 0.08;

/// The rectangle of the worm flank that a dressing motion finishes: roll (the used profile with a continuation, up to the worm's tip) and worm
/// positions between the contact lines at both ends of the stroke. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FinishedArea {
    /// Lengths of roll on the worm.
    pub w: [f64; 2],
    /// Worm positions.
    pub z: [f64; 2],
    /// Largest modification expected there, normal.
    pub largest: f64,
}

impl FinishedArea {
    /// Of a motion of the dresser.
    pub fn new(
        setup: &GrindingSetup,
        tool: &DresserTool,
        flank: Flank,
        corrections: &[Chebyshev; 4],
    ) -> Self {
        let dresser = &tool.flanks[flank];
        let w = finished_rolls(setup, tool, flank);
        let mut largest: f64 = 0.0;
        // A dressed line is bent: its ends alone do not tell how far it lies from its place at rest.
        let mut line = |v: f64| {
            let dk = std::array::from_fn(|j| corrections[j].value(v));
            let profile = DressedProfile::new(tool, flank, dk);
            let mut place = |w: f64| match profile.at_roll(w) {
                Ok(at) => {
                    largest = largest.max(at.f.abs());
                    at.b - v
                }
                Err(_) => dresser.line.value(w) - v,
            };
            extremes(equidistant(w, LINE_POINTS).into_iter().map(&mut place))
        };
        let (from, to) = corrections[0].interval();
        let z = [line(to)[1], line(from)[0]];
        Self { w, z, largest }
    }
}

/// The lengths of roll on the worm over which a dresser finishes it: the used profile with a continuation, up to the worm's tip. mm.
pub fn finished_rolls(setup: &GrindingSetup, tool: &DresserTool, flank: Flank) -> [f64; 2] {
    let dresser = &tool.flanks[flank];
    let margin = FINISHED_PROFILE * dresser.range.length();
    let tip = dresser.worm.length_of_roll(setup.largest_tip_radius).unwrap_or(0.0);
    [dresser.range.w_nf - margin, (dresser.range.w_na + margin).min(tip)]
}

/// Polynomial profile p_0, p_1, ... that the dresser carries: all of it but what the dressing motion makes.
pub fn dresser_profile(worm: &IdealWorm, policy: ProfilePolicy) -> Vec<f64> {
    let mut profile = worm.parts.profile.clone();
    if policy.place == ProfilePlace::Correction {
        // A slope stands here without shift only; the lines have it elsewhere.
        profile.iter_mut().take(3).skip(1).for_each(|p| *p = 0.0);
    }
    profile
}

/// The dresser made for a plan: it carries the profile of the ideal worm, under `correction` without its u^2 part.
///
/// # Errors
/// [`GeneratingError::NotDressed`].
pub fn dresser_of_plan(
    setup: &GrindingSetup,
    plan: &IdealPlan,
    policy: ProfilePolicy,
) -> Result<DresserTool, GeneratingError> {
    let plain = setup.dresser()?;
    let worms = Sides::from_fn(|flank| {
        let mut worm = plan.worms[flank].clone()?;
        worm.parts.profile = dresser_profile(&worm, policy);
        Some(worm)
    });
    let tool = with_profiles(plain, &worms);
    Ok(with_head_for(tool, policy.dressing.rows(), setup.worm_tip_radius)?)
}

/// A dresser that leaves the profile parts of `worms` on the gear.
pub(super) fn with_profiles(plain: &DresserTool, worms: &Sides<Option<IdealWorm>>) -> DresserTool {
    let offsets = Sides::from_fn(|flank| -> Option<Arc<dyn ProfileOffset>> {
        let worm = worms[flank].clone()?;
        let plain = plain.flanks[flank].clone();
        (!worm.has_plain_profile()).then(|| Arc::new(GearProfile { worm, plain }) as Arc<dyn ProfileOffset>)
    });
    plain.with_offsets(&offsets)
}

/// Interval of v in which `tool` dresses the worm width that the plan uses on one flank with a margin at each end, mm.
pub fn dressing_interval(
    setup: &GrindingSetup,
    tool: &DresserTool,
    shift: &MotionLaw,
    flank: Flank,
    margin: f64,
) -> (f64, f64) {
    let z = setup.lines[flank].occupation(shift);
    let b = extremes(pitch_rolls(tool, flank).map(|w| tool.flanks[flank].line.value(w)));
    (b[0] - z[1] - margin, b[1] - z[0] + margin)
}

/// What pitch points of one flank ask for. What stands on the worm's lines as it is has other values across the slightly bent line in
/// which the dresser touches; only their straight part over the profile is asked of the dresser, because a worm of few threads takes
/// hardly any more (`docs/mathematics/planning.md#who-carries-what`).
struct Wish<'a> {
    worm: &'a IdealWorm,
    dresser: &'a FlankDresser,
    /// The dresser without corrections.
    uncorrected: DressedProfile<'a>,
    /// Whether the corrections make a part of the profile.
    corrected: bool,
    /// Ends and middle of the used profile, mm.
    profile: [f64; 3],
    /// Pitch points that stay where they are, mm, and the base there; none where the profile of the dresser is moved.
    known: Vec<(f64, f64)>,
}

impl<'a> Wish<'a> {
    fn new(
        tool: &'a DresserTool,
        plan: &'a IdealPlan,
        flank: Flank,
        policy: ProfilePolicy,
    ) -> Result<Self, GeneratingError> {
        let dresser = &tool.flanks[flank];
        let mut wish = Self {
            worm: plan.worms[flank].as_ref().ok_or(GeneratingError::NoFlank)?,
            dresser,
            uncorrected: DressedProfile::new(tool, flank, [0.0; 4]),
            corrected: policy.place == ProfilePlace::Correction,
            profile: pitch_rolls(tool, flank),
            known: Vec::new(),
        };
        let ([w_nf, _, w_na], mut known) = (wish.profile, Vec::new());
        for row in policy.dressing.rows() {
            let RowAlong::Point { flank: named, at } = row else { continue };
            if named.is_some_and(|named| named != flank) {
                continue;
            }
            for q in [-1.0, 0.0, 1.0] {
                let w = w_nf * (1.0 - at.value(q)) + w_na * at.value(q);
                let base = wish.base_at(w, w)?;
                if at.is_constant() && wish.worm.moved.is_none() {
                    known.push((w, base));
                    break;
                }
            }
        }
        wish.known = known;
        Ok(wish)
    }

    /// What the dresser leaves at w, where it was designed to dress `own`, less what the corrections are to make, mm.
    fn base_at(&self, w: f64, own: f64) -> Result<f64, GeneratingError> {
        let mut base = self.uncorrected.at_roll(own)?.f;
        if self.corrected {
            let u = self.worm.lines.work_roll(w) - self.worm.lines.w_m;
            let p = |i: usize| self.worm.parts.profile.get(i).copied().unwrap_or(0.0);
            base -= self.worm.lines.cos_b2 * (p(1) + p(2) * u) * u;
        }
        Ok(base)
    }

    /// The same at a place of the worm; NaN, which no row can meet, beyond the dresser's profile.
    fn base(&self, w: f64, b: f64) -> f64 {
        let known = self.known.iter().find(|(at, _)| *at == w).map(|(_, base)| *base);
        let own = || self.worm.moved.as_ref().map_or(w, |moved| moved.own_roll(w, b));
        known.unwrap_or_else(|| self.base_at(w, own()).unwrap_or(f64::NAN))
    }

    /// Worm z at the ends and the middle of the profile along the line through pitch points (w, b).
    fn line(&self, points: &[(f64, f64)]) -> [f64; 3] {
        if let [(w_0, b_0), (w_1, b_1), (w_2, b_2)] = *points
            && [w_0, w_1, w_2] == self.profile
        {
            return [b_0, b_1, b_2];
        }
        let by_roll = |a: &&(f64, f64), b: &&(f64, f64)| a.0.total_cmp(&b.0);
        let ends = (points.iter().min_by(by_roll), points.iter().max_by(by_roll));
        match ends {
            (Some(low), Some(high)) if high.0 > low.0 => {
                self.profile.map(|w| low.1 + (high.1 - low.1) * (w - low.0) / (high.0 - low.0))
            }
            // One point: the line as the dresser touches without corrections.
            (Some(&(w_0, b_0)), _) => {
                self.profile.map(|w| b_0 + self.dresser.line.value(w) - self.dresser.line.value(w_0))
            }
            _ => self.profile.map(|w| self.dresser.line.value(w)),
        }
    }

    /// At pitch points (w, b).
    fn values(&self, points: &[(f64, f64)], into: &mut [f64]) {
        if self.worm.given.is_some() {
            for (value, &(w, b)) in into.iter_mut().zip(points) {
                *value = self.worm.jet(w, b).map_or(f64::NAN, |jet| jet.f);
            }
            return;
        }
        let straight =
            (!self.worm.carried.is_empty()).then(|| straightened(self.worm, self.profile, self.line(points)));
        for (value, &(w, b)) in into.iter_mut().zip(points) {
            let share = match straight {
                Some(f) => {
                    let [from, _, to] = self.profile;
                    f[0] + (f[2] - f[0]) * (w - from) / (to - from)
                }
                None => self.worm.dressing_share(w, b),
            };
            *value = self.base(w, b) + share;
        }
    }
}

/// What the pitch points among the rows ask for; NaN for the other rows.
fn wanted(wishes: &Sides<Option<Wish<'_>>>, places: &[Option<PitchPlace>]) -> Vec<f64> {
    let mut f = vec![f64::NAN; places.len()];
    for (flank, wish) in wishes.iter() {
        let Some(wish) = wish else { continue };
        let on_flank = |(row, place): (usize, &Option<PitchPlace>)| {
            place.filter(|place| place.flank == flank).map(|place| (row, (place.w, place.b)))
        };
        let (rows, points): (Vec<usize>, Vec<(f64, f64)>) =
            places.iter().enumerate().filter_map(on_flank).unzip();
        let mut values = vec![f64::NAN; points.len()];
        wish.values(&points, &mut values);
        for (row, value) in rows.iter().zip(values) {
            f[*row] = value;
        }
    }
    f
}

/// Points along the dressed line at which its modification is looked at.
const LINE_POINTS: usize = 13;
/// Weight of the points of a dressed line that grind nothing of the evaluated flank: just enough to tell the line.
const BESIDE: f64 = 0.02;
/// Length over which the weight falls beyond the ends of the flank, mm: keeps the corrections smooth over v.
const FALL: f64 = 0.3;

/// The straight line over the profile nearest to what the ideal worm carries along the dressed line through worm positions `b` at
/// `rolls`; what grinds the evaluated flank counts.
fn straightened(worm: &IdealWorm, rolls: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    let [from, middle, to] = rolls;
    let half = 0.5 * (to - from);
    let (slope, bend) = (0.5 * (b[2] - b[0]), 0.5 * (b[0] + b[2]) - b[1]);
    // Weighted sums of 1, x, x^2 and f, x f with x in [-1, 1].
    let mut sums = [0.0; 5];
    for k in 0..LINE_POINTS {
        let x = 2.0 * k as f64 / (LINE_POINTS - 1) as f64 - 1.0;
        let (w_1, z_1) = (middle + half * x, b[1] + slope * x + bend * x * x);
        let weight = BESIDE + (1.0 - BESIDE) * worm.share_of_flank(w_1, z_1, FALL);
        let f = worm.dressing_share(w_1, z_1);
        for (sum, term) in sums.iter_mut().zip([1.0, x, x * x, f, x * f]) {
            *sum += weight * term;
        }
    }
    let [n, x, xx, f, xf] = sums;
    let inclination = (n * xf - x * f) / (n * xx - x * x);
    let constant = (f - inclination * x) / n;
    [constant - inclination, constant, constant + inclination]
}

/// DK against the nominal kinematics at a few positions over the used worm width of the flanks that are ground: enough for the score of
/// a candidate.
///
/// # Errors
/// Those of the dressing rows.
pub fn sample_corrections(
    setup: &GrindingSetup,
    plan: &IdealPlan,
    tool: &DresserTool,
    which: &[Flank],
    policy: ProfilePolicy,
    samples: usize,
) -> Result<Vec<DressingCorrection>, GeneratingError> {
    let mut dks = Vec::new();
    // One motion serves both flanks, else each has its own.
    let motions = if policy.dressing.of_both_flanks() { vec![which] } else { which.chunks(1).collect() };
    for flanks in motions {
        let interval = common_interval(setup, tool, plan, flanks, DRESSING_MARGIN);
        let Motion { nodes, .. } =
            motion(setup, plan, tool, flanks, policy, NodePlan { interval, nodes: samples })?;
        let settled = flanks.first().map_or([0.0; 4], |&flank| tool.flanks[flank].settled);
        dks.extend(nodes.iter().map(|node| std::array::from_fn(|j| node.dk[j] + settled[j])));
    }
    Ok(dks)
}

/// Interval of v that dresses the used worm width of all of `flanks`.
fn common_interval(
    setup: &GrindingSetup,
    tool: &DresserTool,
    plan: &IdealPlan,
    flanks: &[Flank],
    margin: f64,
) -> (f64, f64) {
    let of_flank = |&flank: &Flank| dressing_interval(setup, tool, &plan.motion.shift, flank, margin);
    let [from, to] = extremes(flanks.iter().map(of_flank).flat_map(|(from, to)| [from, to]));
    (from, to)
}

/// DK(v) of one flank, or of both with one motion.
fn motion(
    setup: &GrindingSetup,
    plan: &IdealPlan,
    tool: &DresserTool,
    flanks: &[Flank],
    policy: ProfilePolicy,
    nodes: NodePlan,
) -> Result<Motion, GeneratingError> {
    let flank = *flanks.first().ok_or(GeneratingError::NoFlank)?;
    let wishes = Sides::try_from_fn(|flank| {
        flanks.contains(&flank).then(|| Wish::new(tool, plan, flank, policy)).transpose()
    })?;
    let tip = WormTip::new(setup, &plan.motion)?;
    let conditions = RowsAlong {
        tool,
        flank,
        rows: *policy.dressing.set(),
        used: Sides::from_fn(|flank| setup.lines[flank].occupation(&plan.motion.shift)),
        wanted: &|places| wanted(&wishes, places),
        tip: &|z| tip.radius(z),
    };
    let solver = ConditionSolver::new(tool, setup.worm_pitch_radius);
    let (corrections, nodes) = solve_rows_along(&solver, &nodes, &conditions)?;
    let weighed = conditions.rows.is_weighed();
    let missed = if weighed { missed_rows(&nodes, &conditions)? } else { Vec::new() };
    Ok(Motion { corrections, nodes, missed })
}

/// Size of the modification by which the answer of the dressing axes is looked at, normal, mm: that of ordinary modifications.
const PROBE: f64 = 5e-3;

/// How the dressing corrections answer to F_C and to F_L of the lines (transverse, mm, u = -1 .. 1 over the profile of the gear), each per
/// mm: the larger of both senses at a modification of a few micrometres. For three pitch points without further rows; `None` for others and
/// where there is no answer.
pub(super) fn dressing_response(
    setup: &GrindingSetup,
    flank: Flank,
    rows: DressingRows,
) -> Option<[[f64; 2]; 4]> {
    if rows != DressingRows::default() {
        return None;
    }
    let tool = setup.dresser().ok()?;
    let lines = &setup.lines[flank];
    let half = 0.5 * (lines.roll[1] - lines.roll[0]);
    let u = pitch_rolls(tool, flank).map(|w| (lines.work_roll(w) - lines.w_m) / half);
    let nodes = NodePlan { interval: (-1.0, 1.0), nodes: 1 };
    let answer = |f: [f64; 3]| -> Option<[f64; 4]> {
        let wanted = |_: [f64; 3]| f;
        let (_, solved) =
            solve_dressing_motion(tool, flank, setup.worm_pitch_radius, &nodes, &wanted).ok()?;
        Some(solved.first()?.dk)
    };
    let none = answer([0.0; 3])?;
    let largest = |shape: [f64; 3]| -> Option<[f64; 4]> {
        let mut largest = [0.0f64; 4];
        for sign in [1.0, -1.0] {
            let dk = answer(shape.map(|f| sign * PROBE * f))?;
            for j in 0..4 {
                // One sign for all: which of two functions adds to the other is kept.
                let by = -lines.cos_b2 * sign * (dk[j] - none[j]) / PROBE;
                if by.abs() > largest[j].abs() {
                    largest[j] = by;
                }
            }
        }
        Some(largest)
    };
    let (constant, linear) = (largest([1.0; 3])?, largest(u)?);
    Some(std::array::from_fn(|j| [constant[j], linear[j]]))
}

/// Dresses the worm for a plan: each flank that is ground with a motion of its own, or both with one (`policy.dressing`).
///
/// # Errors
/// Those of the dressing rows, with the worm position.
pub fn dress_flanks(
    setup: &GrindingSetup,
    plan: &IdealPlan,
    tool: &DresserTool,
    policy: ProfilePolicy,
    margin: f64,
) -> Result<Sides<Option<DressedFlank>>, GeneratingError> {
    let dress = |flanks: &[Flank]| dress(setup, plan, tool, flanks, policy, margin);
    let of_flank = |flank: Flank, Motion { corrections, nodes, missed }: Motion| {
        let worm = DressedWorm::new(tool, flank, &corrections);
        DressedFlank { corrections, nodes, missed, worm }
    };
    if policy.dressing.of_both_flanks() {
        let both = dress(&Flank::BOTH)?;
        return Ok(Sides::from_fn(|flank| Some(of_flank(flank, both.clone()))));
    }
    let alone = |flank: Flank| {
        let ground = plan.worms[flank].is_some();
        ground.then(|| dress(&[flank]).map(|solved| of_flank(flank, solved))).transpose()
    };
    let (left, right) = rayon::join(|| alone(Flank::Left), || alone(Flank::Right));
    Ok(Sides { left: left?, right: right? })
}

/// Whether the dressing motion makes a part of the profile.
pub(super) fn asks_corrections(worm: &IdealWorm, policy: ProfilePolicy) -> bool {
    policy.place == ProfilePlace::Correction && dresser_profile(worm, policy) != worm.parts.profile
}

/// DK(v) over the used worm width with as many nodes as it takes.
fn dress(
    setup: &GrindingSetup,
    plan: &IdealPlan,
    tool: &DresserTool,
    flanks: &[Flank],
    policy: ProfilePolicy,
    margin: f64,
) -> Result<Motion, GeneratingError> {
    let interval = common_interval(setup, tool, plan, flanks, margin);
    let SeriesRule { nodes, tolerance } = policy.series;
    let (mut radial, mut asked) = (true, false);
    let (mut most, mut lever) = (nodes, [0.0, 10.0, 1.0, 0.1]);
    for &flank in flanks {
        let worm = plan.worms[flank].as_ref().ok_or(GeneratingError::NoFlank)?;
        let (first, last) = tool.flanks[flank].profile.interval();
        for t in [first, last] {
            // An arc ends where its circle ends; the dresser would have no profile there.
            let w_2 = worm.lines.work_roll(worm_roll_of(&tool.flanks[flank], t));
            for relief in &worm.reliefs {
                relief.jet(w_2, worm.lines.z_m)?;
            }
        }
        radial &= worm.is_radial() && worm.given.is_none();
        asked |= asks_corrections(worm, policy);
        // Polynomials settle with few nodes; reliefs and waves on the lines take as many as they need.
        if !worm.carried.is_empty() || worm.given.is_some() {
            most = MOST_NODES;
        }
        lever[0] = f64::max(lever[0], worm.lines.cos_b1 * setup.pair.worm.flank(flank).base_radius);
    }
    let rows = policy.dressing.rows();
    asked |= !rows.iter().all(RowAlong::is_met_uncorrected);
    if radial && !(asked && rows.iter().any(RowAlong::varies)) {
        if asked {
            // The same all along the worm.
            return motion(setup, plan, tool, flanks, policy, NodePlan { interval, nodes: 1 });
        }
        let zero = Chebyshev::constant(interval.0, interval.1, 0.0);
        let corrections = [zero.clone(), zero.clone(), zero.clone(), zero];
        return Ok(Motion { corrections, nodes: Vec::new(), missed: Vec::new() });
    }
    let mut count = nodes;
    loop {
        let solved = motion(setup, plan, tool, flanks, policy, NodePlan { interval, nodes: count })?;
        if 2 * count - 1 > most || tail(&solved.corrections, lever) < tolerance {
            return Ok(solved);
        }
        count = 2 * count - 1;
    }
}
