//! The loop of singular values: linearise, equilibrate the columns, drop or damp small singular values, step, until nothing changes.
//! It keeps a record of its rounds and does not know what the unknowns are.

use nalgebra::{DMatrix, DVector, SVD};

/// How to iterate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SvdLoop {
    /// Singular values of the equilibrated matrix below this share of the largest are dropped.
    pub cut: f64,
    /// Damping mu at the start, of singular values sigma/(sigma^2 + mu^2); `None`: none, and the residual may grow from round to
    /// round.
    pub damping: Option<f64>,
    /// Columns shorter than this share of the longest are left alone for a round.
    pub live: f64,
    /// Columns of which the longest is no longer than this move nothing.
    pub least: f64,
    /// Converged when the weighted root mean square changes by less than this share.
    pub change: f64,
    /// A weighted root mean square that is as good as none: below it only rounding changes.
    pub exact: f64,
    /// Most rounds.
    pub rounds: usize,
}

impl Default for SvdLoop {
    fn default() -> Self {
        Self { cut: 1e-10, damping: None, live: 1e-7, least: 0.0, change: 1e-6, exact: 0.0, rounds: 60 }
    }
}

/// Tries to shorten a step.
const RETRIES: usize = 7;
/// Growth of the damping with each of them.
const HARDER: f64 = 30.0;
/// Relative damping below which it is as good as none.
const LEAST_DAMPING: f64 = 1e-12;

/// One round: the state before its step.
#[derive(Clone, Debug, PartialEq)]
pub struct SvdRound {
    /// Weighted root mean square.
    pub weighted_rms: f64,
    /// Largest unweighted residual.
    pub largest: f64,
    /// Singular values kept.
    pub rank: usize,
    /// Singular values of the equilibrated matrix, descending.
    pub singular_values: Vec<f64>,
    /// Damping of the step taken.
    pub damping: f64,
    /// Share of the step taken.
    pub share: f64,
}

/// How the loop went.
#[derive(Clone, Debug, PartialEq)]
pub struct SvdReport {
    /// Best unknowns met.
    pub x: DVector<f64>,
    /// Unweighted residual there.
    pub residual: DVector<f64>,
    /// Weighted root mean square there.
    pub weighted_rms: f64,
    /// All rounds.
    pub rounds: Vec<SvdRound>,
    /// Whether nothing changed any more.
    pub converged: bool,
}

/// Why there is no report.
#[derive(Clone, Debug, PartialEq)]
pub enum SvdLoopError<E> {
    /// The rows cannot be evaluated at the start.
    Start(E),
    /// No column moves any row.
    NoLiveColumn,
}

/// Minimises |W R(x)| from `x`. `rows` returns residual and Jacobian, or why there are none: the step is then shortened.
///
/// # Errors
/// [`SvdLoopError`].
pub fn svd_loop<E>(
    mut x: DVector<f64>,
    weights: &[f64],
    options: &SvdLoop,
    mut rows: impl FnMut(&DVector<f64>) -> Result<(DVector<f64>, DMatrix<f64>), E>,
) -> Result<SvdReport, SvdLoopError<E>> {
    let rms = |residual: &DVector<f64>| {
        let sum: f64 = residual.iter().zip(weights).map(|(r, w)| (w * r) * (w * r)).sum();
        (sum / residual.len().max(1) as f64).sqrt()
    };
    let (mut residual, mut jacobian) = rows(&x).map_err(SvdLoopError::Start)?;
    let mut now = rms(&residual);
    let mut best = (x.clone(), residual.clone(), now);
    let mut rounds = Vec::new();
    let mut converged = false;
    let mut damping = options.damping.unwrap_or(0.0);
    for _ in 0..options.rounds {
        let solver = Step::new(&jacobian, &residual, weights, options).ok_or(SvdLoopError::NoLiveColumn)?;
        let mut share = 1.0;
        let mut taken = None;
        for _ in 0..=RETRIES {
            let next = &x - solver.step(damping) * share;
            match rows(&next) {
                Ok((r, j)) if options.damping.is_none() || rms(&r) <= now * (1.0 + options.change) => {
                    taken = Some((next, r, j));
                    break;
                }
                _ if options.damping.is_some() => damping = damping.max(LEAST_DAMPING) * HARDER,
                _ => share *= 0.5,
            }
        }
        rounds.push(SvdRound {
            weighted_rms: now,
            largest: residual.amax(),
            rank: solver.rank,
            singular_values: solver.singular_values(),
            damping,
            share: if taken.is_some() { share } else { 0.0 },
        });
        let Some((next, r, j)) = taken else {
            // No step however short makes it better: that is the end where growth is refused, and stuck where it is not.
            converged = options.damping.is_some();
            break;
        };
        let before = now;
        (x, residual, jacobian) = (next, r, j);
        now = rms(&residual);
        if now < best.2 {
            best = (x.clone(), residual.clone(), now);
        }
        damping *= if options.damping.is_some() { 0.1 } else { 1.0 };
        if (before - now).abs() <= options.change * before || now <= options.exact {
            converged = true;
            break;
        }
    }
    let (x, residual, weighted_rms) = best;
    Ok(SvdReport { x, residual, weighted_rms, rounds, converged })
}

/// The equilibrated matrix of a round, decomposed.
struct Step {
    svd: SVD<f64, nalgebra::Dyn, nalgebra::Dyn>,
    right: DVector<f64>,
    norms: Vec<f64>,
    rank: usize,
    limit: f64,
}

impl Step {
    fn new(
        jacobian: &DMatrix<f64>,
        residual: &DVector<f64>,
        weights: &[f64],
        options: &SvdLoop,
    ) -> Option<Self> {
        let mut a = jacobian.clone();
        let mut right = residual.clone();
        for (i, &w) in weights.iter().enumerate() {
            a.row_mut(i).scale_mut(w);
            right[i] *= w;
        }
        let mut norms: Vec<f64> = a.column_iter().map(|c| c.norm()).collect();
        let longest = norms.iter().copied().fold(0.0, f64::max);
        // Written so that NaN is no live column.
        if !(longest > options.least && longest.is_finite() && right.iter().all(|x| x.is_finite())) {
            return None;
        }
        for (mut column, norm) in a.column_iter_mut().zip(&mut norms) {
            if *norm < options.live * longest {
                column.fill(0.0);
                *norm = f64::INFINITY;
            } else {
                column /= *norm;
            }
        }
        let svd = a.svd(true, true);
        let limit = options.cut * svd.singular_values.max();
        let rank = svd.singular_values.iter().filter(|&&s| s > limit).count();
        Some(Self { svd, right, norms, rank, limit })
    }

    fn singular_values(&self) -> Vec<f64> {
        let mut all: Vec<f64> = self.svd.singular_values.iter().copied().collect();
        all.sort_by(|a, b| b.total_cmp(a));
        all
    }

    /// What is taken off the unknowns.
    fn step(&self, damping: f64) -> DVector<f64> {
        let (Some(u), Some(v_t)) = (&self.svd.u, &self.svd.v_t) else {
            return DVector::zeros(self.norms.len());
        };
        let mut along = u.tr_mul(&self.right);
        for (part, &sigma) in along.iter_mut().zip(&self.svd.singular_values) {
            *part *= if sigma > self.limit { sigma / (sigma * sigma + damping * damping) } else { 0.0 };
        }
        let mut step = v_t.tr_mul(&along);
        for (x, norm) in step.iter_mut().zip(&self.norms) {
            *x /= norm;
        }
        step
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// a exp(b t) through points of 2 exp(-0.7 t); c does nothing.
    fn rows(x: &DVector<f64>) -> Result<(DVector<f64>, DMatrix<f64>), &'static str> {
        if x[1] > 1.5 {
            return Err("too steep");
        }
        let t = |i: usize| i as f64 * 0.5;
        let e = |i: usize| (x[1] * t(i)).exp();
        let r = DVector::from_fn(6, |i, _| x[0] * e(i) - 2.0 * (-0.7 * t(i)).exp());
        let j = DMatrix::from_fn(6, 3, |i, k| [e(i), x[0] * t(i) * e(i), 0.0][k]);
        Ok((r, j))
    }

    #[test]
    fn plain_and_damped_find_the_same_and_leave_dead_columns() {
        for damping in [None, Some(1e-7)] {
            let options = SvdLoop { damping, ..SvdLoop::default() };
            let start = DVector::from_vec(vec![1.0, 1.4, 5.0]);
            let report = svd_loop(start, &[1.0; 6], &options, rows).unwrap();
            assert!(report.converged && report.rounds[0].rank == 2);
            assert!((report.x[0] - 2.0).abs() < 1e-9 && (report.x[1] + 0.7).abs() < 1e-9);
            assert_eq!(report.x[2], 5.0);
        }
    }

    #[test]
    fn an_exact_fit_is_an_end() {
        let start = DVector::from_vec(vec![1.0, 1.4, 5.0]);
        let options = SvdLoop { exact: 1e-9, ..SvdLoop::default() };
        let report = svd_loop(start, &[1.0; 6], &options, rows).unwrap();
        assert!(report.converged && report.weighted_rms <= 1e-9 && report.rounds.len() < 20);
    }

    #[test]
    fn what_cannot_be_evaluated_or_moved_is_said() {
        let at = |b: f64| DVector::from_vec(vec![1.0, b, 0.0]);
        let options = SvdLoop::default();
        assert_eq!(
            svd_loop(at(2.0), &[1.0; 6], &options, rows).unwrap_err(),
            SvdLoopError::Start("too steep")
        );
        let dead = |x: &DVector<f64>| rows(x).map(|(r, j)| (r, j * 0.0));
        assert_eq!(svd_loop(at(0.0), &[1.0; 6], &options, dead).unwrap_err(), SvdLoopError::NoLiveColumn);
        let blind = SvdLoop { least: 10.0, ..options };
        assert_eq!(svd_loop(at(0.0), &[1.0; 6], &blind, rows).unwrap_err(), SvdLoopError::NoLiveColumn);
        let nan = |x: &DVector<f64>| rows(x).map(|(r, j)| (r * f64::NAN, j));
        assert_eq!(svd_loop(at(0.0), &[1.0; 6], &options, nan).unwrap_err(), SvdLoopError::NoLiveColumn);
    }
}
