//! Which variables to free: forward selection and backward elimination to a small set that meets the tolerance
//! (`docs/mathematics/tangential-dressing.md#fit`).
//!
//! Forward: the candidate whose column, freed of what the chosen ones can do, explains most of the residual; the best few are fitted and
//! judged. Backward: whatever can be left out is. The set found is small, not proven least.

use super::TangentialError;
use super::channel::{Channel, Variable};
use super::fit::{Fit, FitLimits, FitMethod, FitTask, Places};
use super::settings::TangentialSettings;
use super::target::FitGrid;
use nalgebra::{DMatrix, DVector};

/// What may be chosen and when to stop.
#[derive(Clone, Debug)]
pub struct SelectionTask {
    /// Variables to choose from.
    pub candidates: Vec<Variable>,
    /// Largest |m - f| allowed, mm.
    pub tolerance: f64,
    /// Most variables.
    pub most: usize,
    /// Where a set is judged.
    pub judged_on: FitGrid,
}

/// One step of a selection.
#[derive(Clone, Debug, PartialEq)]
pub struct SelectionStep {
    /// The variable concerned.
    pub variable: Variable,
    /// Whether it was taken in or left out.
    pub taken: bool,
    /// Largest |m - f| after the step, mm: at the points of the fit, where the tolerance is met there also between them.
    pub largest: f64,
    /// Variables after the step.
    pub count: usize,
}

/// The set found.
#[derive(Clone, Debug, PartialEq)]
pub struct Selection {
    /// The variables.
    pub variables: Vec<Variable>,
    /// Their values.
    pub values: Vec<f64>,
    /// Largest |m - f|, mm.
    pub largest: f64,
    /// Whether it meets the tolerance.
    pub met: bool,
    /// How it came about.
    pub steps: Vec<SelectionStep>,
}

/// Candidates of which a fit is compared in each forward step.
const TRIED: usize = 3;
/// Rounds that an attempt may take.
const ROUNDS_OF_ATTEMPT: usize = 12;
/// Columns shorter than this share of themselves after the chosen ones are taken out say nothing new.
const NOTHING_NEW: f64 = 1e-6;

impl SelectionTask {
    /// The candidates of `docs/mathematics/tangential-dressing.md`: profile to the seventh power, motions to the fifth, without what
    /// `excluded` channels do. Own profiles of the dresser's sides are offered where both flanks share a pass.
    pub fn standard_candidates(two_flanks: bool, excluded: &[Channel]) -> Vec<Variable> {
        let sides = [
            Channel::Profile(Some(foundation::geometry::Flank::Left)),
            Channel::Profile(Some(foundation::geometry::Flank::Right)),
        ];
        let mut offers: Vec<(Channel, std::ops::RangeInclusive<u32>)> = vec![
            (Channel::Profile(None), 1..=7),
            (Channel::CentreDistance, 0..=4),
            (Channel::AxialOffset, 1..=5),
            (Channel::WorkTurn, 1..=5),
            (Channel::DressingDistance, 1..=4),
            (Channel::DressingAngle, 1..=3),
            (Channel::TangentialShift, 2..=3),
        ];
        if two_flanks {
            // One motion has to serve both: higher powers, the swivel and the law of the shift count as well.
            offers.extend(sides.map(|side| (side, 1..=6)));
            offers.extend([
                (Channel::AxialOffset, 0..=0),
                (Channel::AxialOffset, 6..=7),
                (Channel::DressingDistance, 5..=6),
                (Channel::DressingAngle, 4..=4),
                (Channel::CrossedAxesAngle, 0..=1),
                (Channel::ToolShift, 1..=3),
            ]);
        }
        let offers = offers.into_iter().filter(|(channel, _)| !excluded.contains(&whole(*channel)));
        offers.flat_map(|(channel, powers)| powers.map(move |k| Variable::power(channel, k))).collect()
    }

    /// Constants with which a dresser that exists settles on a worm that it was not made for, without what `excluded` channels do.
    pub fn settling_candidates(excluded: &[Channel]) -> Vec<Variable> {
        let constants = [
            (Channel::DressingDistance, 0),
            (Channel::DressingAngle, 0),
            (Channel::AxialOffset, 0),
            (Channel::TangentialShift, 0),
            (Channel::TangentialShift, 1),
        ];
        let offers = constants.into_iter().filter(|(channel, _)| !excluded.contains(channel));
        offers.map(|(channel, k)| Variable::power(channel, k)).collect()
    }
}

/// The sides of the dresser go with its profile.
fn whole(channel: Channel) -> Channel {
    match channel {
        Channel::Profile(_) => Channel::Profile(None),
        other => other,
    }
}

/// A fitted and judged set.
#[derive(Clone)]
struct Tried {
    chosen: Vec<usize>,
    values: Vec<f64>,
    /// Weighted root mean square and largest error at the points of the fit.
    rms: f64,
    largest: f64,
}

impl FitTask<'_> {
    /// Chooses variables and fits them.
    ///
    /// # Errors
    /// [`TangentialError::NoLiveVariable`] without candidates; what keeps the unmodified flank or the target from being evaluated. A
    /// tolerance that is not met is no error; the selection says so.
    pub fn select(&self, selection: &SelectionTask) -> Result<Selection, TangentialError> {
        let pool = &selection.candidates;
        if pool.is_empty() {
            return Err(TangentialError::NoLiveVariable { count: 0 });
        }
        let places = Places::of(self, 1.0)?;
        let variables =
            |chosen: &[usize]| -> Vec<Variable> { chosen.iter().map(|&k| pool[k].clone()).collect() };
        // Attempts need not be polished: the set that is found can be.
        let rounds = self.limits.rounds.min(ROUNDS_OF_ATTEMPT);
        let quick = Self { limits: FitLimits { rounds, ..self.limits }, ..self.clone() };
        // A fit that makes nothing better is stuck in a narrow valley: damping gets it out.
        let attempt = |chosen: Vec<usize>, start: &[f64], before: f64| -> Option<Tried> {
            let free = variables(&chosen);
            let better = |fit: &Fit| fit.converged || fit.weighted_rms < before;
            let fit = quick.fit(&free, start, FitMethod::Plain).ok().filter(better);
            let fit = fit.or_else(|| quick.fit(&free, start, FitMethod::Damped).ok())?;
            // Nor is a set any good that needs worm or dresser beyond their tips.
            self.judge(&self.fixed.with(&free, &fit.values), self.grid).ok()?;
            Some(Tried { chosen, values: fit.values, rms: fit.weighted_rms, largest: fit.largest })
        };
        // Between the points of the fit.
        let judged = |tried: &Tried| -> Option<f64> {
            let settings = self.fixed.with(&variables(&tried.chosen), &tried.values);
            let judged = self.judge(&settings, selection.judged_on).ok()?;
            Some(judged.iter().map(|j| j.largest()).fold(0.0, f64::max))
        };
        let settings = self.fixed.clone();
        let untouched = self.judge(&settings, selection.judged_on)?;
        let start = untouched.iter().map(|j| j.largest()).fold(0.0, f64::max);
        let mut now = Tried { chosen: Vec::new(), values: Vec::new(), rms: f64::INFINITY, largest: start };
        let mut best = (start, now.clone());
        let mut steps = Vec::new();
        let step = |tried: &Tried, k: usize, taken, largest| SelectionStep {
            variable: pool[k].clone(),
            taken,
            largest,
            count: tried.chosen.len(),
        };
        while best.0 > selection.tolerance && now.chosen.len() < selection.most.min(pool.len()) {
            let settings = self.fixed.with(&variables(&now.chosen), &now.values);
            let ranked = self.ranked(&places, &settings, pool, &now.chosen)?;
            let tried = ranked.into_iter().filter_map(|k| {
                let chosen = [now.chosen.as_slice(), &[k]].concat();
                attempt(chosen, &[now.values.as_slice(), &[0.0]].concat(), now.rms).map(|t| (k, t))
            });
            let tried = tried.take(TRIED);
            let Some((k, next)) = tried.min_by(|a, b| a.1.rms.total_cmp(&b.1.rms)) else { break };
            now = next;
            // Where the points of the fit miss the tolerance, those between them do.
            let largest = if now.largest <= selection.tolerance { judged(&now) } else { Some(now.largest) };
            let Some(largest) = largest else { break };
            steps.push(step(&now, k, true, largest));
            if largest < best.0 {
                best = (largest, now.clone());
            }
        }
        // A variable too many may make the largest error worse while it makes the mean better.
        let (mut largest, mut now) = best;
        let met = largest <= selection.tolerance;
        while met && now.chosen.len() > 1 {
            let mut tried: Vec<(usize, Tried)> = (0..now.chosen.len())
                .filter_map(|out| {
                    let (mut chosen, mut values) = (now.chosen.clone(), now.values.clone());
                    let k = chosen.remove(out);
                    values.remove(out);
                    attempt(chosen, &values, f64::INFINITY)
                        .filter(|t| t.largest <= selection.tolerance)
                        .map(|t| (k, t))
                })
                .collect();
            tried.sort_by(|a, b| a.1.largest.total_cmp(&b.1.largest));
            let good = tried
                .into_iter()
                .find_map(|(k, t)| judged(&t).filter(|&l| l <= selection.tolerance).map(|l| (k, t, l)));
            let Some((k, next, l)) = good else { break };
            steps.push(step(&next, k, false, l));
            (now, largest) = (next, l);
        }
        if !met {
            largest = judged(&now).unwrap_or(largest);
        }
        Ok(Selection { variables: variables(&now.chosen), values: now.values, largest, met, steps })
    }

    /// Candidates by how much of the residual they explain beyond the chosen ones, best first.
    fn ranked(
        &self,
        places: &Places,
        settings: &TangentialSettings,
        pool: &[Variable],
        chosen: &[usize],
    ) -> Result<Vec<usize>, TangentialError> {
        let (mut residual, mut jacobian) = self.rows(places, settings, pool)?;
        for (i, &w) in places.weights.iter().enumerate() {
            residual[i] *= w;
            jacobian.row_mut(i).scale_mut(w);
        }
        let norms: Vec<f64> = jacobian.column_iter().map(|c| c.norm()).collect();
        // An orthonormal basis of the chosen columns; two passes keep it orthogonal to rounding.
        let mut basis: Vec<DVector<f64>> = Vec::new();
        for &k in chosen {
            if let Some(unit) = beyond(&basis, &jacobian, k, norms[k]) {
                basis.push(unit);
            }
        }
        for unit in &basis {
            let along = unit.dot(&residual);
            residual.axpy(-along, unit, 1.0);
        }
        let mut gains: Vec<(usize, f64)> = (0..pool.len())
            .filter(|k| !chosen.contains(k))
            .filter_map(|k| Some((k, beyond(&basis, &jacobian, k, norms[k])?.dot(&residual).abs())))
            .collect();
        gains.sort_by(|a, b| b.1.total_cmp(&a.1));
        Ok(gains.into_iter().map(|(k, _)| k).collect())
    }
}

/// The unit vector of a column beyond a basis; `None` if it has nothing of its own.
fn beyond(basis: &[DVector<f64>], columns: &DMatrix<f64>, k: usize, norm: f64) -> Option<DVector<f64>> {
    let mut column: DVector<f64> = columns.column(k).into_owned();
    for _ in 0..2 {
        for unit in basis {
            let along = unit.dot(&column);
            column.axpy(-along, unit, 1.0);
        }
    }
    let left = column.norm();
    (left > NOTHING_NEW * norm && left > 0.0).then(|| column / left)
}
