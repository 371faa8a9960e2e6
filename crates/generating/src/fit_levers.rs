//! Numbers of the worm's design chosen so that one diagonal ratio, constant or varying, meets the targets of both flanks
//! best (`docs/mathematics/planning.md#variable-diagonal-ratio`, `docs/mathematics/planning.md`): the bodies are built anew for every value
//! by the caller. Knows no plan.
//!
//! Kept for planning over ratio, cone, profile and crossing angle at once: no command reaches it yet.

use super::fit_shift;
use super::fit_shift::{around, fit_from};
use super::least_squares::{FitSettings, FlankFit, Objective, RatioSearch, Samples, search_ratio};
use super::{FlankLines, GeneratingError, Lever, ShiftFit};
use foundation::geometry::{GeometryError, Sides};
use foundation::numerics::golden_section;
use rayon::prelude::*;

/// Values of a lever tried over its range before the best of them is refined.
const TRIED: usize = 9;
/// Evaluations of a golden section: its bracket shrinks to 1e-5 of the lever's range.
const GOLDEN: usize = 22;
/// Rounds over all levers at most,
const ROUNDS: usize = 4;
/// and no further when a round gains less than this share of the objective.
const GAIN: f64 = 1e-2;

/// A lever that may be moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AllowedLever {
    /// Which.
    pub lever: Lever,
    /// Value to start from, rad.
    pub start: f64,
    /// Least and largest value, rad.
    pub range: [f64; 2],
}

/// What one flank is asked for.
#[derive(Clone, Copy, Debug)]
pub struct FlankDemand<'a> {
    /// Its target.
    pub samples: &'a Samples,
    /// Class and splines.
    pub settings: &'a FitSettings,
}

/// The flanks of the bodies with these values of the levers, in the order in which the levers were given.
pub type LeverBodies<'a> = &'a (dyn Fn(&[(Lever, f64)]) -> Result<Sides<FlankLines>, GeneratingError> + Sync);

/// What is given besides the levers.
#[derive(Clone, Copy)]
pub struct LeverSearch<'a> {
    /// Targets of the flanks that are ground.
    pub demands: Sides<Option<FlankDemand<'a>>>,
    /// Bodies of a design.
    pub bodies: LeverBodies<'a>,
    /// K_0, as for [`fit_shift`].
    pub ratio: f64,
    /// Nodes of a varying ratio; `None` keeps it constant. On cones a ratio is constant in any case.
    pub nodes: Option<usize>,
}

/// The design found.
#[derive(Clone, Debug, PartialEq)]
pub struct LeverFit {
    /// Values of the levers, rad.
    pub levers: Vec<(Lever, f64)>,
    /// Flanks of that design.
    pub lines: Sides<FlankLines>,
    /// sqrt(rms_l^2 + rms_r^2) there, mm.
    pub objective: f64,
    /// The same at the start; why there is none.
    pub start: Result<f64, GeneratingError>,
    /// The best constant ratio.
    pub constant: RatioSearch,
    /// The varying ratio, if one was wanted and the bodies are cylinders.
    pub shift: Option<ShiftFit>,
}

impl LeverSearch<'_> {
    /// Moves one lever after the other to the best value of its range, others held: a scan, then golden section between the
    /// neighbours of the best; repeated while it gains. Values for which there are no bodies or no fit are passed over.
    ///
    /// # Errors
    /// `InvalidNumber` for a range that is none or a start outside of it, `Geometry` (`CylindricalOnly`) for a varying ratio
    /// with the cone angle as a lever, and where no value has an objective the error of the start.
    pub fn search(&self, levers: &[AllowedLever]) -> Result<LeverFit, GeneratingError> {
        for allowed in levers {
            let [from, to] = allowed.range;
            let good = from.is_finite() && to.is_finite() && from < to;
            if !(good && (from..=to).contains(&allowed.start)) {
                let value = if good { allowed.start } else { from };
                let field = "lever (rad)";
                return Err(GeneratingError::InvalidNumber {
                    field,
                    value,
                    allowed: "inside an ascending range",
                });
            }
            if self.nodes.is_some() && allowed.lever == Lever::ConeAngle {
                return Err(GeometryError::CylindricalOnly.into());
            }
        }
        let mut values: Vec<(Lever, f64)> = levers.iter().map(|l| (l.lever, l.start)).collect();
        let start = self.objective(&values);
        let mut best = start.clone().unwrap_or(f64::INFINITY);
        for _ in 0..ROUNDS {
            let before = best;
            for (k, allowed) in levers.iter().enumerate() {
                let at = |value: f64| {
                    let mut values = values.clone();
                    values[k].1 = value;
                    self.objective(&values).unwrap_or(f64::INFINITY)
                };
                let (value, objective) = lowest(allowed.range, at);
                if objective < best {
                    values[k].1 = value;
                    best = objective;
                }
            }
            // Alone, a lever is where it should be after one round. Written so that no objective at all ends it too.
            let gains = levers.len() > 1 && before - best > GAIN * before;
            if !(gains || before == f64::INFINITY && best < before && levers.len() > 1) {
                break;
            }
        }
        if best == f64::INFINITY {
            return Err(start.err().unwrap_or(GeneratingError::NoFlank));
        }
        let lines = (self.bodies)(&values)?;
        let fits = self.fits(&lines);
        let constant = search_ratio(&fits, &around(self.ratio)?, Objective::Rms)?;
        let shift = self.nodes.map(|nodes| fit_shift(&fits, self.ratio, nodes)).transpose()?;
        let objective = shift.as_ref().map_or(constant.objective, |shift| shift.objective);
        Ok(LeverFit { levers: values, lines, objective, start, constant, shift })
    }

    fn fits<'l>(&'l self, lines: &'l Sides<FlankLines>) -> Sides<Option<FlankFit<'l>>> {
        Sides::from_fn(|flank| {
            let (demand, lines) = (self.demands[flank]?, &lines[flank]);
            let rack_slope = lines.profile_slope();
            Some(FlankFit { lines, samples: demand.samples, settings: demand.settings, rack_slope })
        })
    }

    fn objective(&self, values: &[(Lever, f64)]) -> Result<f64, GeneratingError> {
        let lines = (self.bodies)(values)?;
        let fits = self.fits(&lines);
        match self.nodes {
            Some(nodes) => fit_from(&fits, self.ratio, nodes, &[0.0]).map(|fit| fit.objective),
            None => search_ratio(&fits, &around(self.ratio)?, Objective::Rms).map(|found| found.objective),
        }
    }
}

/// The lowest place of a function over a range and its value there.
fn lowest([from, to]: [f64; 2], f: impl Fn(f64) -> f64 + Sync) -> (f64, f64) {
    let share = |k: usize| k as f64 / (TRIED - 1) as f64;
    let values: Vec<f64> = (0..TRIED).map(|k| from * (1.0 - share(k)) + to * share(k)).collect();
    let heights: Vec<f64> = values.par_iter().map(|&value| f(value)).collect();
    let lowest = (1..TRIED).fold(0, |best, k| if heights[k] < heights[best] { k } else { best });
    let (a, b) = (values[lowest.saturating_sub(1)], values[(lowest + 1).min(TRIED - 1)]);
    let refined = golden_section(a, b, GOLDEN, &f);
    let height = f(refined);
    if height < heights[lowest] { (refined, height) } else { (values[lowest], heights[lowest]) }
}
