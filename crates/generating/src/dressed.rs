//! From the ideal worm to the dressed one: dresser profile, corrections DK(v), exact envelope
//! (`docs/mathematics/planning.md#from-the-ratio-to-the-flank`).

use super::{
    DressingRows, FlankRows, GeneratingError, GrindingSetup, IdealPlan, IdealWorm, ProfilePlace,
    ProfilePolicy, SeriesRule, WormTip,
};
use dressing::{
    Condition, ConditionSolver, DressedProfile, DressedWorm, DresserTool, FlankDresser, NodePlan,
    NodeSolution, map_of_upper_end, pitch_rolls, solve_conditions_along, solve_dressing_motion,
    solve_two_flank_motion, two_flank_rolls,
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

/// Length of roll on the dressed worm that grinds what roll t of the worm that the dresser was designed for grinds: both
/// generate the gear's form circles at the ends of their ranges.
fn worm_roll_of(dresser: &FlankDresser, t: f64) -> f64 {
    dresser.range.w_nf + (t - dresser.designed.w_nf) * (dresser.range.length() / dresser.designed.length())
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
    /// The exact envelope.
    pub worm: DressedWorm,
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

/// The head part of a dresser reaches over this to either side of the middle of the worm's tip, mm.
const HEAD_HALF: f64 = 1.5;

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
    Ok(match policy.dressing {
        DressingRows::Alone(FlankRows { head: true, .. }) => {
            tool.with_head(setup.worm_tip_radius, HEAD_HALF)?
        }
        _ => tool,
    })
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

/// What the pitch points of one flank ask for. What stands on the worm's lines as it is has other values across the slightly
/// bent line in which the dresser touches; only their straight part over the profile is asked of the dresser, because a worm of
/// few threads takes hardly any more (`docs/mathematics/planning.md#who-carries-what`).
struct Wish<'a> {
    worm: &'a IdealWorm,
    /// Ends and middle of the used profile, mm.
    profile: [f64; 3],
    /// Lengths of roll of the pitch points, mm.
    rolls: Vec<f64>,
    /// What is dressed there without corrections, less what these are to make, mm.
    base: Vec<f64>,
}

impl<'a> Wish<'a> {
    fn new(
        tool: &DresserTool,
        plan: &'a IdealPlan,
        flank: Flank,
        policy: ProfilePolicy,
    ) -> Result<Self, GeneratingError> {
        let worm = plan.worms[flank].as_ref().ok_or(GeneratingError::NoFlank)?;
        let uncorrected = DressedProfile::new(tool, flank, [0.0; 4]);
        let base = |&w: &f64| -> Result<f64, GeneratingError> {
            let mut base = uncorrected.at_roll(w)?.f;
            if policy.place == ProfilePlace::Correction {
                let u = worm.lines.work_roll(w) - worm.lines.w_m;
                let p = |i: usize| worm.parts.profile.get(i).copied().unwrap_or(0.0);
                base -= worm.lines.cos_b2 * (p(1) + p(2) * u) * u;
            }
            Ok(base)
        };
        let profile = pitch_rolls(tool, flank);
        let rolls = match policy.dressing {
            DressingRows::BothFlanks => two_flank_rolls(tool)[flank].to_vec(),
            DressingRows::Alone(rows) if rows.points == 3 => profile.to_vec(),
            DressingRows::Alone(rows) => equidistant([profile[0], profile[2]], rows.points),
        };
        let base = rolls.iter().map(base).collect::<Result<Vec<_>, _>>()?;
        Ok(Self { worm, profile, rolls, base })
    }

    /// At the pitch points, with their worm positions b.
    fn values<const N: usize>(&self, b: [f64; N]) -> [f64; N] {
        let along = |from: [f64; 2], to: [f64; 2], w: f64| {
            to[0] + (to[1] - to[0]) * (w - from[0]) / (from[1] - from[0])
        };
        let straight = (!self.worm.carried.is_empty()).then(|| {
            let ends = [self.rolls[0], self.rolls[N - 1]];
            let line = match *b.as_slice() {
                [b_0, b_1, b_2] => [b_0, b_1, b_2],
                _ => self.profile.map(|w| along(ends, [b[0], b[N - 1]], w)),
            };
            straightened(self.worm, self.profile, line)
        });
        std::array::from_fn(|i| {
            let w = self.rolls[i];
            let share = match straight {
                Some(f) => along([self.profile[0], self.profile[2]], [f[0], f[2]], w),
                None => self.worm.dressing_share(w, b[i]),
            };
            self.base[i] + share
        })
    }
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
    let motions =
        if policy.dressing == DressingRows::BothFlanks { vec![which] } else { which.chunks(1).collect() };
    for flanks in motions {
        let interval = common_interval(setup, tool, plan, flanks, DRESSING_MARGIN);
        let (_, nodes) = motion(setup, plan, tool, flanks, policy, NodePlan { interval, nodes: samples })?;
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
) -> Result<([Chebyshev; 4], Vec<NodeSolution>), GeneratingError> {
    let radius = setup.worm_pitch_radius;
    let rows = match policy.dressing {
        DressingRows::BothFlanks => {
            let wishes = Sides::try_from_fn(|flank| Wish::new(tool, plan, flank, policy))?;
            let wanted = |flank: Flank, b: [f64; 2]| wishes[flank].values(b);
            return Ok(solve_two_flank_motion(tool, radius, &nodes, &wanted)?);
        }
        DressingRows::Alone(rows) => rows,
    };
    let flank = *flanks.first().ok_or(GeneratingError::NoFlank)?;
    let wish = Wish::new(tool, plan, flank, policy)?;
    if rows == FlankRows::default() {
        return Ok(solve_dressing_motion(tool, flank, radius, &nodes, &|b| wish.values(b))?);
    }
    let tip = WormTip::new(setup, &plan.motion)?;
    let conditions = |v: f64, b: &[f64; 4]| {
        // At worm position v the head works about z = -v.
        let further = further_rows(tool, flank, rows, tip.radius(-v));
        let point = |i: usize, f: f64| Condition::Point { flank, w: wish.rolls[i], f };
        if rows.points == 4 {
            let f = wish.values(*b);
            return std::array::from_fn(|i| point(i, f[i]));
        }
        let f = wish.values([b[0], b[1], b[2]]);
        [point(0, f[0]), point(1, f[1]), point(2, f[2]), further]
    };
    Ok(solve_conditions_along(&ConditionSolver::new(tool, radius), &nodes, &conditions)?)
}

/// The row beside three pitch points.
fn further_rows(tool: &DresserTool, flank: Flank, rows: FlankRows, tip_radius: f64) -> Condition {
    match rows.fixed.iter().position(|&fixed| fixed) {
        _ if rows.map => map_of_upper_end(&tool.flanks[flank]),
        _ if rows.head => Condition::Head { t: 0.0, r: tip_radius },
        Some(j) => Condition::Fixed { j, x: 0.0 },
        None => map_of_upper_end(&tool.flanks[flank]),
    }
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
    if rows != DressingRows::Alone(FlankRows::default()) {
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
    let of_flank = |flank: Flank, (corrections, nodes): ([Chebyshev; 4], Vec<NodeSolution>)| {
        let worm = DressedWorm::new(tool, flank, &corrections);
        DressedFlank { corrections, nodes, worm }
    };
    if policy.dressing == DressingRows::BothFlanks {
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
) -> Result<([Chebyshev; 4], Vec<NodeSolution>), GeneratingError> {
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
        radial &= worm.is_radial();
        asked |= asks_corrections(worm, policy);
        // Polynomials settle with few nodes; reliefs and waves on the lines take as many as they need.
        if !worm.carried.is_empty() {
            most = MOST_NODES;
        }
        lever[0] = f64::max(lever[0], worm.lines.cos_b1 * setup.pair.worm.flank(flank).base_radius);
    }
    if radial {
        if asked {
            // The same all along the worm.
            return motion(setup, plan, tool, flanks, policy, NodePlan { interval, nodes: 1 });
        }
        let zero = Chebyshev::constant(interval.0, interval.1, 0.0);
        return Ok(([zero.clone(), zero.clone(), zero.clone(), zero], Vec::new()));
    }
    let mut count = nodes;
    loop {
        let solved = motion(setup, plan, tool, flanks, policy, NodePlan { interval, nodes: count })?;
        if 2 * count - 1 > most || tail(&solved.0, lever) < tolerance {
            return Ok(solved);
        }
        count = 2 * count - 1;
    }
}
