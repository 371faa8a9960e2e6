//! From the ideal worm to the dressed one: dresser profile, corrections DK(v), exact envelope (spec 28 section 4, steps 6, 7).

use super::{GeneratingError, GrindingSetup, IdealPlan, IdealWorm, ProfilePlace, ProfilePolicy};
use crate::geometry::{Flank, ProfileOffset, Sides};
use crate::kinematics::{DressingCorrection, MotionLaw};
use crate::numerics::{Chebyshev, extremes};
use crate::process::dressing::{
    DressedProfile, DressedWorm, DresserTool, NodePlan, NodeSolution, pitch_rolls, solve_dressing_motion,
    solve_node,
};
use std::sync::Arc;

/// Profile of the dresser that leaves F_P and the reliefs on the gear: g(t) = cos b2 F_P(u(w_1 = t)), mm.
#[derive(Debug)]
struct GearProfile(IdealWorm);

impl ProfileOffset for GearProfile {
    fn jet(&self, t: f64) -> [f64; 3] {
        let l = &self.0.lines;
        let shrink = -l.cos_b2 / l.cos_b1;
        // Where an arc ends its circle the offset is not defined; NaN makes the point "no contact" further on.
        let [f, f1, f2] = self.0.profile_share(l.work_roll(t)).unwrap_or([f64::NAN; 3]);
        [l.cos_b2 * f, l.cos_b2 * f1 * shrink, l.cos_b2 * f2 * shrink * shrink]
    }
}

/// Margin of the dressed length beyond the occupation, mm: the contact shift of a modified worm stays below it.
pub const DRESSING_MARGIN: f64 = 3.0;
/// Chebyshev nodes of DK(v).
pub const DRESSING_NODES: usize = 17;

/// Most nodes for reliefs and waves on the worm's lines.
const MOST_NODES: usize = 257;
/// Share of the modification, mm, that the last quarter of a series may hold before the nodes are doubled.
const SERIES_TOLERANCE: f64 = 2e-7;

/// The last quarter of the coefficients, as an amount on the worm flank, mm: each component times its influence (base radius
/// for the phase; orders of magnitude for crossing angle, distance and offset).
fn tail(series: &[Chebyshev; 4], lever: [f64; 4]) -> f64 {
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

/// The rectangle of the worm flank that a dressing motion finishes: roll (the used profile with a continuation, up to the
/// worm's tip) and worm positions between the contact lines at both ends of the stroke. mm.
pub fn finished_area(
    setup: &GrindingSetup,
    tool: &DresserTool,
    flank: Flank,
    corrections: &[Chebyshev; 4],
) -> ([f64; 2], [f64; 2]) {
    let dresser = &tool.flanks[flank];
    let margin = FINISHED_PROFILE * dresser.range.length();
    let tip = dresser.worm.length_of_roll(setup.largest_tip_radius).unwrap_or(0.0);
    let w = [dresser.range.w_nf - margin, (dresser.range.w_na + margin).min(tip)];
    let ends = |v: f64| {
        let dk = std::array::from_fn(|j| corrections[j].value(v));
        let profile = DressedProfile::new(tool, flank, dk);
        w.map(|w| profile.at_roll(w).map_or(dresser.line.value(w), |at| at.b) - v)
    };
    let (from, to) = corrections[0].interval();
    let (lowest, highest) = (ends(to), ends(from));
    (w, [lowest[0].max(lowest[1]), highest[0].min(highest[1])])
}

/// Polynomial profile p_0, p_1, ... that the dresser carries: all of it but what the dressing motion makes.
pub fn dresser_profile(worm: &IdealWorm, policy: ProfilePolicy) -> Vec<f64> {
    let mut profile = worm.parts.profile.clone();
    if let (ProfilePlace::Correction, Some(p_2)) = (policy.place, profile.get_mut(2)) {
        *p_2 = 0.0;
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
    let offsets = Sides::from_fn(|flank| -> Option<Arc<dyn ProfileOffset>> {
        let mut worm = plan.worms[flank].clone()?;
        worm.parts.profile = dresser_profile(&worm, policy);
        let empty = worm.reliefs.is_empty() && worm.parts.profile.iter().all(|&p| p == 0.0);
        (!empty).then(|| Arc::new(GearProfile(worm)) as Arc<dyn ProfileOffset>)
    });
    Ok(setup.dresser()?.with_offsets(&offsets))
}

/// Interval of v in which `tool` dresses the plan's occupation of one flank with a margin at each end, mm.
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

/// Rows of the dressing motion: wanted modification at the pitch points with worm positions b. What stands on the worm's lines
/// as it is has other values across the slightly bent line in which the dresser touches; only their straight part over the
/// profile is asked of the dresser, because a worm of few threads takes hardly any more (spec 28 section 1).
fn wanted_rows<'a>(
    tool: &DresserTool,
    plan: &'a IdealPlan,
    flank: Flank,
    policy: ProfilePolicy,
) -> Result<impl Fn([f64; 3]) -> [f64; 3] + 'a, GeneratingError> {
    let worm = plan.worms[flank].as_ref().ok_or(GeneratingError::NoFlank)?;
    let rolls = pitch_rolls(tool, flank);
    let uncorrected = DressedProfile::new(tool, flank, [0.0; 4]);
    let mut base = [0.0; 3];
    for i in 0..3 {
        base[i] = uncorrected.at_roll(rolls[i])?.f;
        if policy.place == ProfilePlace::Correction {
            let u = worm.lines.work_roll(rolls[i]) - worm.lines.w_m;
            base[i] -= worm.lines.cos_b2 * worm.parts.profile.get(2).copied().unwrap_or(0.0) * u * u;
        }
    }
    let straight = !worm.carried.is_empty();
    Ok(move |b: [f64; 3]| {
        let f = if straight {
            straightened(worm, rolls, b)
        } else {
            std::array::from_fn(|i| worm.dressing_share(rolls[i], b[i]))
        };
        std::array::from_fn(|i| base[i] + f[i])
    })
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

/// DK at a few positions over the occupation: enough for the score of a candidate.
///
/// # Errors
/// Those of the dressing rows.
pub fn sample_corrections(
    setup: &GrindingSetup,
    plan: &IdealPlan,
    tool: &DresserTool,
    flank: Flank,
    policy: ProfilePolicy,
    samples: usize,
) -> Result<Vec<DressingCorrection>, GeneratingError> {
    let wanted = wanted_rows(tool, plan, flank, policy)?;
    let (from, to) = dressing_interval(setup, tool, &plan.motion.shift, flank, DRESSING_MARGIN);
    let nodes = Chebyshev::nodes(from, to, samples);
    let mut dks = vec![[0.0; 4]; samples];
    let middle = samples / 2;
    let order = (middle..samples).map(|k| (k, k.checked_sub(1).filter(|_| k > middle)));
    for (k, neighbour) in order.chain((0..middle).rev().map(|k| (k, Some(k + 1)))) {
        let start = neighbour.map_or([0.0; 4], |n| dks[n]);
        dks[k] = solve_node(tool, flank, setup.worm_pitch_radius, nodes[k], &start, &wanted)?;
    }
    Ok(dks)
}

/// Dresses one flank of the worm for a plan.
///
/// # Errors
/// Those of the dressing rows, with the worm position.
pub fn dress_flank(
    setup: &GrindingSetup,
    plan: &IdealPlan,
    tool: &DresserTool,
    flank: Flank,
    policy: ProfilePolicy,
    margin: f64,
) -> Result<DressedFlank, GeneratingError> {
    let interval = dressing_interval(setup, tool, &plan.motion.shift, flank, margin);
    let worm = plan.worms[flank].as_ref().ok_or(GeneratingError::NoFlank)?;
    let (first, last) = tool.flanks[flank].profile.interval();
    for w in [first, last] {
        // An arc ends where its circle ends; the dresser would have no profile there.
        let w_2 = worm.lines.work_roll(w);
        for relief in &worm.reliefs {
            relief.jet(w_2, worm.lines.z_m)?;
        }
    }
    let (corrections, nodes) = if worm.is_radial() {
        let zero = Chebyshev::constant(interval.0, interval.1, 0.0);
        ([zero.clone(), zero.clone(), zero.clone(), zero], Vec::new())
    } else {
        let wanted = wanted_rows(tool, plan, flank, policy)?;
        // Polynomials settle with few nodes; reliefs and waves on the lines take as many as they need.
        let most = if worm.carried.is_empty() { DRESSING_NODES } else { MOST_NODES };
        let lever = [worm.lines.cos_b1 * setup.pair.worm.flank(flank).base_radius, 10.0, 1.0, 0.1];
        let mut count = DRESSING_NODES;
        loop {
            let nodes = NodePlan { interval, nodes: count };
            let solved = solve_dressing_motion(tool, flank, setup.worm_pitch_radius, &nodes, &wanted)?;
            if 2 * count - 1 > most || tail(&solved.0, lever) < SERIES_TOLERANCE {
                break solved;
            }
            count = 2 * count - 1;
        }
    };
    let worm = DressedWorm::new(tool, flank, &corrections);
    Ok(DressedFlank { corrections, nodes, worm })
}
