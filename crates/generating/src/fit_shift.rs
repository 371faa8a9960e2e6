//! A varying diagonal ratio fitted to any target together with the functions of worm, dresser and motion
//! (`docs/mathematics/planning.md#variable-diagonal-ratio`): the functions follow from every ratio by linear least squares, so only the
//! ratio at a few feeds is sought. Cylindrical bodies. Knows no plan.

use super::least_squares::{
    ArgumentKinks, Arguments, Candidates, FlankCoordinates, FlankFit, LineSlopes, MovingLines, Objective,
    RatioSearch, SplineDecomposition, search_ratio,
};
use super::ratio_nodes::RatioNodes;
use super::{FlankLines, GeneratingError};
use foundation::geometry::{GeometryError, Sides};
use foundation::inverse::RowReduction;
use foundation::kinematics::{InverseLaw, MotionLaw};
use foundation::numerics::{Jet2, extremes};
use rayon::prelude::*;

/// Nodes of the ratio over the feeds, if nothing else is wanted.
pub const DEFAULT_NODES: usize = 6;

/// Constant ratios tried before any varies: from K_0/REACH to K_0 REACH.
const REACH: f64 = 8.0;
/// Number of them.
const CONSTANT: usize = 49;
/// Besides the best constant ratio, the ratio that rises and the one that falls by this factor over the feeds are starts:
/// targets with kinks have more than one minimum.
const TILT: f64 = 1.5;
/// Steps of one start; some ten are needed.
const STEPS: usize = 60;
/// A step changes no ratio by more than this factor (logarithm).
const LONGEST: f64 = 0.5;
/// The fit is settled when no ratio changes by more than this share,
const SETTLED: f64 = 1e-10;
/// or when a step lowers the sum of squares by less than this share of it.
const LEVEL: f64 = 1e-12;
/// Residuals below this share of the target's size are rounding.
const EXACT: f64 = 1e-13;
/// Damping as a share of the largest change a node makes; above the last no step helps.
const DAMPING: [f64; 3] = [1e-9, 1e-3, 1e6];

/// X of R20, w and X_K of a flank whose tool shift follows any law.
#[derive(Clone, Debug, PartialEq)]
pub struct ShiftCoordinates {
    lines: FlankLines,
    shift: MotionLaw,
}

impl ShiftCoordinates {
    /// # Errors
    /// `Geometry` (`CylindricalOnly`), `WormDirectionDegenerate`.
    pub fn new(lines: &FlankLines, shift: MotionLaw) -> Result<Self, GeneratingError> {
        check(lines)?;
        Ok(Self { lines: *lines, shift })
    }
}

/// F_X1 holds for cylinders only.
fn check(lines: &FlankLines) -> Result<(), GeneratingError> {
    if !lines.is_cylindrical() {
        return Err(GeometryError::CylindricalOnly.into());
    }
    lines.check_worm_direction()
}

impl FlankCoordinates for ShiftCoordinates {
    fn jets(&self, w: f64, z: f64) -> [Jet2; 3] {
        let c_k = 1.0 / self.lines.t_k.hypot(1.0);
        let path =
            Jet2 { f: c_k * (self.lines.t_k * w + z), fu: c_k * self.lines.t_k, fv: c_k, ..Jet2::default() };
        let profile = Jet2 { f: w, fu: 1.0, ..Jet2::default() };
        [self.lines.line_coordinate(&self.shift, w, z), profile, path]
    }
}

/// A varying ratio with everything that follows from it.
#[derive(Clone, Debug, PartialEq)]
pub struct ShiftFit {
    /// z_V1 = F(z_V2): C2, on the feeds of the flanks; zero in their middle.
    pub shift: InverseLaw,
    /// The same as parabolas between the nodes: C1, F' a broken line.
    pub parabolas: MotionLaw,
    /// [z_V2, F'] of the nodes, mm.
    pub nodes: Vec<[f64; 2]>,
    /// The decompositions under this shift.
    pub flanks: Sides<Option<SplineDecomposition<ShiftCoordinates>>>,
    /// sqrt(rms_l^2 + rms_r^2), mm.
    pub objective: f64,
    /// The best constant ratio, with its objective and decompositions.
    pub constant: RatioSearch,
    /// Steps taken from the start that led here.
    pub steps: usize,
    /// Whether they ended by themselves.
    pub settled: bool,
}

/// The law z_V1 = F(z_V2) with `nodes` ratios of the sign of `ratio`, equidistant over the feeds and straight between, that
/// meets the targets best together with the functions of the settings. Steps of Levenberg and Marquardt with exact derivatives
/// from the best constant ratio between `ratio`/8 and 8 `ratio`, and from ratios that rise and fall around it. Ratios at
/// feeds where they change nothing stay as they were.
///
/// Minimises the squares over the tolerances, as the fits themselves do; with equal tolerances that is
/// sqrt(rms_l^2 + rms_r^2). The settings' norm decides about the functions handed out only.
///
/// # Errors
/// `NoFlank`, `InvalidNumber` for a ratio 0 and fewer than two nodes, `Geometry` (`CylindricalOnly`),
/// `WormDirectionDegenerate`, and those of [`search_ratio`].
pub fn fit_shift(
    flanks: &Sides<Option<FlankFit<'_>>>,
    ratio: f64,
    nodes: usize,
) -> Result<ShiftFit, GeneratingError> {
    fit_from(flanks, ratio, nodes, &[0.0, TILT.ln(), -TILT.ln()])
}

/// [`fit_shift`] from ratios that change by the given logarithms over the feeds.
pub(super) fn fit_from(
    flanks: &Sides<Option<FlankFit<'_>>>,
    ratio: f64,
    nodes: usize,
    tilts: &[f64],
) -> Result<ShiftFit, GeneratingError> {
    let number = |field, value, allowed| GeneratingError::InvalidNumber { field, value, allowed };
    if !(ratio.is_finite() && ratio != 0.0) {
        return Err(number("K_0", ratio, "a finite number other than 0"));
    }
    // Beyond some hundreds the ratio would follow single samples.
    if !(2..=256).contains(&nodes) {
        return Err(number("nodes of the diagonal ratio", nodes as f64, "2 .. 256"));
    }
    let given: Vec<&FlankFit<'_>> = [&flanks.left, &flanks.right].into_iter().flatten().collect();
    given.iter().try_for_each(|fit| check(fit.lines))?;
    let constant = search_ratio(flanks, &around(ratio)?, Objective::Rms)?;
    let points = |fit: &&FlankFit<'_>| {
        let lines = fit.lines;
        fit.samples.points().iter().map(|&[w, z]| lines.path_feed(w, z)).collect::<Vec<f64>>()
    };
    let feeds = extremes(given.iter().flat_map(points));
    let middle = constant.ratio.abs().ln();
    let settled: Vec<Result<Settled, GeneratingError>> = tilts
        .par_iter()
        .map(|tilt| {
            let at = |k: usize| middle + tilt * (k as f64 / (nodes - 1) as f64 - 0.5);
            settle(&given, RatioNodes::new(feeds, ratio.signum(), (0..nodes).map(at).collect()))
        })
        .collect();
    let mut best: Option<Settled> = None;
    for found in settled {
        let found = found?;
        if best.as_ref().is_none_or(|best| found.cost < best.cost) {
            best = Some(found);
        }
    }
    // A list of tilts is never empty; an empty one is a scan of nothing.
    let best =
        best.ok_or(GeneratingError::InvalidScan { least: f64::NAN, most: f64::NAN, count: tilts.len() })?;
    let law = best.nodes.smooth_law().map_err(GeneratingError::Law)?;
    let decomposed = |fit: &Option<FlankFit<'_>>| {
        let one = |fit: &FlankFit<'_>| {
            let coordinates = ShiftCoordinates::new(fit.lines, law.clone())?;
            SplineDecomposition::fit(fit.samples, coordinates, fit.settings)
        };
        fit.as_ref().map(one).transpose()
    };
    let decompositions = Sides { left: decomposed(&flanks.left)?, right: decomposed(&flanks.right)? };
    let qualities = [&decompositions.left, &decompositions.right];
    Ok(ShiftFit {
        objective: Objective::Rms.of(qualities.into_iter().flatten().map(|d| d.report.quality())),
        shift: InverseLaw::new(law, feeds)?,
        parabolas: best.nodes.law()?,
        nodes: best.nodes.nodes(),
        flanks: decompositions,
        constant,
        steps: best.steps,
        settled: best.settled,
    })
}

/// Constant ratios around one, in constant proportion.
pub(super) fn around(ratio: f64) -> Result<Candidates, GeneratingError> {
    let power = |k: usize| 2.0 * k as f64 / (CONSTANT - 1) as f64 - 1.0;
    let ratios: Vec<f64> = (0..CONSTANT).map(|k| ratio * REACH.powf(power(k))).collect();
    Candidates::ratios(&ratios)
}

/// Where the steps from one start ended.
struct Settled {
    nodes: RatioNodes,
    cost: f64,
    steps: usize,
    settled: bool,
}

/// Levenberg-Marquardt from one start.
fn settle(flanks: &[&FlankFit<'_>], start: RatioNodes) -> Result<Settled, GeneratingError> {
    let size: f64 = flanks.iter().map(|fit| mean_square(fit)).sum();
    let mut nodes = start;
    let mut here = Fitted::new(flanks, &nodes)?;
    let mut damping = DAMPING[1];
    let mut steps = 0;
    let settled = loop {
        if here.cost <= EXACT * EXACT * size {
            break true;
        }
        if steps == STEPS {
            break false;
        }
        let Some(mut problem) = here.problem(flanks, &nodes)? else { break false };
        let scale = problem.largest_column();
        let mut damped = || loop {
            let mut problem = problem.clone();
            (0..nodes.logs().len()).for_each(|k| problem.push(&[(k, damping * scale)], 0.0));
            let (change, _) = problem.shortest(f64::EPSILON)?;
            let length = change.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
            // Nothing of what the nodes do is seen.
            if length <= SETTLED || damping > DAMPING[2] {
                return None;
            }
            let share = (LONGEST / length).min(1.0);
            let next = nodes.with(nodes.logs().iter().zip(&change).map(|(log, d)| log + share * d).collect());
            // Ratios for which nothing can be fitted are no step.
            match Fitted::new(flanks, &next) {
                Ok(there) if there.cost < here.cost => {
                    damping = (damping * 0.1).max(DAMPING[0]);
                    return Some((next, there));
                }
                _ => damping *= 10.0,
            }
        };
        let Some((next, there)) = damped() else { break true };
        let level = here.cost - there.cost <= LEVEL * here.cost;
        (nodes, here) = (next, there);
        steps += 1;
        if level {
            break true;
        }
    };
    Ok(Settled { nodes, cost: here.cost, steps, settled })
}

/// Mean square of the target over its tolerances.
fn mean_square(fit: &FlankFit<'_>) -> f64 {
    let (values, tolerances) = (fit.samples.values(), fit.samples.tolerances());
    let sum: f64 = values.iter().zip(tolerances).map(|(f, tolerance)| (f / tolerance).powi(2)).sum();
    sum / values.len().max(1) as f64
}

/// The fits of all flanks under one shift.
struct Fitted {
    flanks: Vec<MovingLines>,
    /// Sum of the mean squares over the tolerances.
    cost: f64,
}

impl Fitted {
    fn new(flanks: &[&FlankFit<'_>], nodes: &RatioNodes) -> Result<Self, GeneratingError> {
        let law = nodes.law()?;
        let one = |fit: &&FlankFit<'_>| {
            let coordinates = ShiftCoordinates { lines: *fit.lines, shift: law.clone() };
            let points = fit.samples.points();
            let arguments: Vec<Arguments> =
                points.iter().map(|&[w, z]| coordinates.arguments(w, z)).collect();
            let kinks = ArgumentKinks::new(fit.settings, &coordinates);
            MovingLines::new(fit.samples, arguments, fit.settings, &kinks)
        };
        let fits: Vec<Result<MovingLines, GeneratingError>> = flanks.par_iter().map(one).collect();
        let flanks = fits.into_iter().collect::<Result<Vec<MovingLines>, GeneratingError>>()?;
        let cost = flanks.iter().map(|fit| fit.quality().weighted_rms.powi(2)).sum();
        Ok(Self { flanks, cost })
    }

    /// The linear problem of the nodes' logarithms, all flanks together. `None` if a number is not finite.
    fn problem(
        &self,
        flanks: &[&FlankFit<'_>],
        nodes: &RatioNodes,
    ) -> Result<Option<RowReduction>, GeneratingError> {
        let parameters = nodes.logs().len();
        let one = |(moving, fit): (&MovingLines, &&FlankFit<'_>)| {
            let lines = fit.lines;
            let slopes = |[w, z]: [f64; 2]| {
                let by_node = nodes.slopes(lines.path_feed(w, z));
                by_node.into_iter().map(|slope| -lines.cos_rho_1() * slope)
            };
            let kinks = fit.settings.kinks.lines.iter();
            let slopes = LineSlopes {
                parameters,
                samples: fit.samples.points().iter().flat_map(|&point| slopes(point)).collect(),
                kinks: kinks.map(|&point| slopes(point).collect()).collect(),
            };
            moving.problem(fit.samples, &slopes)
        };
        let problems: Vec<_> = self.flanks.par_iter().zip(flanks).map(one).collect();
        let mut all = RowReduction::new(parameters, flanks.len() * (parameters + 1));
        for problem in problems {
            let Some(mut problem) = problem? else { return Ok(None) };
            all.append(&mut problem);
        }
        Ok(Some(all))
    }
}
