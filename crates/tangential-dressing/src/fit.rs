//! The inverse: which values of given variables grind the wanted flanks best (`docs/mathematics/tangential-dressing.md#fit`). Three methods
//! on the same rows.

use super::TangentialError;
use super::channel::Variable;
use super::forward::{FlankPoint, RollGrid, TangentialFlank};
use super::model::TangentialModel;
use super::settings::TangentialSettings;
use super::target::{FitGrid, Wanted, Weights};
use contact::Measure;
use foundation::geometry::Flank;
use foundation::inverse::{GaussNewton, SvdLoop, SvdLoopError, SvdRound, gauss_newton, svd_loop};
use foundation::numerics::root_mean_square;
use nalgebra::{DMatrix, DVector};

/// How far a fit goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FitLimits {
    /// Singular values of the equilibrated matrix below this share of the largest are left alone: variables that nearly do the same
    /// would run away together.
    pub cut: f64,
    /// Variables whose effect is below this share of the most effective one stay as they are for a round.
    pub live: f64,
    /// Most rounds.
    pub rounds: usize,
}

impl FitLimits {
    /// Those of the source (`docs/mathematics/tangential-dressing.md#fit`).
    pub const SOURCE: Self = Self { cut: 1e-10, live: 1e-7, rounds: 60 };
    /// For all other sets: splines repeat what powers do and have functions with few contacts, and many powers together would leave the
    /// machine for a hundredth of a micrometre.
    pub const STEADY: Self = Self { cut: 1e-5, live: 1e-4, rounds: 60 };
}

/// One pass: flanks that share their motions, what is wanted of them, and how it is measured.
#[derive(Clone)]
pub struct FitTask<'a> {
    /// The bodies.
    pub model: &'a TangentialModel,
    /// Flanks ground together.
    pub pass: &'a [Flank],
    /// What is wanted.
    pub wanted: &'a Wanted<'a>,
    /// Values that stay as they are.
    pub fixed: TangentialSettings,
    /// How deviations are measured; a target and its evaluation must use the same.
    pub measure: Measure,
    /// Where the fit asks.
    pub grid: FitGrid,
    /// How its points count.
    pub weights: Weights,
    /// How far it goes.
    pub limits: FitLimits,
}

/// How to fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FitMethod {
    /// The source's loop: truncated singular values, every step taken.
    Plain,
    /// The same with damping: the residual never grows.
    Damped,
    /// The project's Gauss-Newton.
    GaussNewton,
}

impl FitMethod {
    /// All methods.
    pub const ALL: [FitMethod; 3] = [Self::Plain, Self::Damped, Self::GaussNewton];

    /// As files write it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Plain => "svd",
            Self::Damped => "damped",
            Self::GaussNewton => "gauss-newton",
        }
    }
}

/// What a fit found. mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// The method.
    pub method: FitMethod,
    /// Parts in which the target was stepped up; 1: at once.
    pub steps: usize,
    /// Values of the free variables, in their order.
    pub values: Vec<f64>,
    /// Weighted root mean square on the grid of the fit.
    pub weighted_rms: f64,
    /// Largest |m - f| on it.
    pub largest: f64,
    /// Rounds of the last part; those of Gauss-Newton have no record.
    pub rounds: Vec<SvdRound>,
    /// Rounds of all parts.
    pub rounds_in_all: usize,
    /// Whether nothing changed any more.
    pub converged: bool,
}

impl Fit {
    /// The fit if it converged.
    ///
    /// # Errors
    /// [`TangentialError::NotConverged`] with the best values, where it did not.
    pub fn require_convergence(self) -> Result<Self, TangentialError> {
        if self.converged {
            return Ok(self);
        }
        Err(TangentialError::NotConverged {
            rounds: self.rounds_in_all,
            rms_um: self.weighted_rms * 1e3,
            best: self.values,
        })
    }
}

/// A flank beside what is wanted of it, on a grid. mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    /// The flank.
    pub flank: Flank,
    /// Where.
    pub grid: RollGrid,
    /// What is ground.
    pub points: Vec<FlankPoint>,
    /// m - f.
    pub error: Vec<f64>,
}

impl Judged {
    /// Largest |m - f|.
    pub fn largest(&self) -> f64 {
        self.error.iter().fold(0.0, |m, e| f64::max(m, e.abs()))
    }

    /// Root mean square of m - f.
    pub fn rms(&self) -> f64 {
        root_mean_square(&self.error)
    }

    /// Range of x_D that dresses it: the worm length needed.
    pub fn positions(&self) -> [f64; 2] {
        let each = self.points.iter().map(|p| p.position);
        each.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)])
    }

    /// Least ratio of the determinants: near 0 the envelope folds.
    pub fn least_ratio(&self) -> f64 {
        self.points.iter().map(|p| p.determinant_ratio).fold(f64::INFINITY, f64::min)
    }
}

/// Effect on a point below which a variable moves nothing, mm per mm or rad: rounding, as of the crossed-axes angle of an unmodified
/// flank.
const NO_EFFECT: f64 = 1e-9;

/// Weighted rms at which a flank is what is wanted but for the rounding of the contact, mm.
const EXACT: f64 = 1e-11;

/// The length of a column of such effects.
fn least_effect(places: &Places) -> f64 {
    NO_EFFECT * (places.weights.len() as f64).sqrt()
}

/// Residual, Jacobian: what a method works on.
type Rows = (DVector<f64>, DMatrix<f64>);

impl FitTask<'_> {
    /// The flank `flank` of the pass as `settings` grind it.
    pub fn flank(&self, flank: Flank, settings: &TangentialSettings) -> TangentialFlank<'_> {
        TangentialFlank::new(self.model, flank, self.pass, settings, self.measure)
    }

    /// The flanks of the pass beside what is wanted, on a grid.
    ///
    /// # Errors
    /// Those of [`TangentialFlank::solve`].
    pub fn judge(
        &self,
        settings: &TangentialSettings,
        grid: FitGrid,
    ) -> Result<Vec<Judged>, TangentialError> {
        self.judge_by(settings, grid, |flank, grid| flank.solve(grid))
    }

    /// The same as if worm and dresser went on beyond their tips.
    ///
    /// # Errors
    /// Those of [`TangentialFlank::solve_beyond_tool`].
    pub fn judge_beyond_tool(
        &self,
        settings: &TangentialSettings,
        grid: FitGrid,
    ) -> Result<Vec<Judged>, TangentialError> {
        self.judge_by(settings, grid, |flank, grid| flank.solve_beyond_tool(grid))
    }

    fn judge_by(
        &self,
        settings: &TangentialSettings,
        grid: FitGrid,
        solve: impl Fn(&TangentialFlank<'_>, &RollGrid) -> Result<Vec<FlankPoint>, TangentialError>,
    ) -> Result<Vec<Judged>, TangentialError> {
        let one = |&flank: &Flank| {
            let grid = grid.of(self.model, flank);
            let points = solve(&self.flank(flank, settings), &grid)?;
            let wanted = grid.points().map(|(w, z)| (self.wanted)(flank, w, z));
            let error = points.iter().zip(wanted).map(|(p, f)| p.deviation - f).collect();
            Ok(Judged { flank, grid, points, error })
        };
        self.pass.iter().map(one).collect()
    }

    /// m - f and its derivatives by the free variables at all points of all flanks of the pass.
    ///
    /// # Errors
    /// Those of [`TangentialFlank::linearised`].
    pub(super) fn rows(
        &self,
        places: &Places,
        settings: &TangentialSettings,
        free: &[Variable],
    ) -> Result<Rows, TangentialError> {
        let count = places.weights.len();
        let mut residual = DVector::zeros(count);
        let mut jacobian = DMatrix::zeros(count, free.len());
        let mut first = 0;
        for (flank, grid) in &places.grids {
            let (m, by) = self.flank(*flank, settings).linearised(grid, free)?;
            jacobian.rows_mut(first, m.len()).copy_from(&by);
            for (i, m) in m.into_iter().enumerate() {
                residual[first + i] = m - places.wanted[first + i];
            }
            first += grid.count();
        }
        Ok((residual, jacobian))
    }

    /// Fits the free variables from `start` by one method.
    ///
    /// # Errors
    /// [`TangentialError::NoLiveVariable`], [`TangentialError::InvalidNumber`] for a target that is no number, and what keeps the start
    /// from being evaluated. A loop that does not converge is no error; the fit says so.
    pub fn fit(&self, free: &[Variable], start: &[f64], method: FitMethod) -> Result<Fit, TangentialError> {
        self.fit_at(&Places::of(self, 1.0)?, free, start, method)
    }

    /// The same with what varies along the face stepped up in equal parts: each starts from the one before.
    ///
    /// # Errors
    /// As [`FitTask::fit`].
    pub fn fit_in_steps(
        &self,
        free: &[Variable],
        start: &[f64],
        method: FitMethod,
        steps: usize,
    ) -> Result<Fit, TangentialError> {
        let mut values = start.to_vec();
        let mut rounds_in_all = 0;
        let mut last = None;
        for k in 1..=steps.max(1) {
            let places = Places::of(self, k as f64 / steps.max(1) as f64)?;
            let fit = self.fit_at(&places, free, &values, method)?;
            rounds_in_all += fit.rounds_in_all;
            values.clone_from(&fit.values);
            last = Some(fit);
        }
        let nothing = || TangentialError::NoLiveVariable { count: free.len() };
        last.map(|fit| Fit { steps: steps.max(1), rounds_in_all, ..fit }).ok_or_else(nothing)
    }

    fn fit_at(
        &self,
        places: &Places,
        free: &[Variable],
        start: &[f64],
        method: FitMethod,
    ) -> Result<Fit, TangentialError> {
        let rows = |x: &DVector<f64>| self.rows(places, &self.fixed.with(free, x.as_slice()), free);
        let nothing = || TangentialError::NoLiveVariable { count: free.len() };
        let start = DVector::from_column_slice(start);
        if free.is_empty() {
            return Err(nothing());
        }
        let damping = match method {
            FitMethod::Plain => None,
            FitMethod::Damped => Some(1e-7),
            FitMethod::GaussNewton => return self.gauss_newton(places, free, start),
        };
        let FitLimits { cut, live, rounds } = self.limits;
        let least = least_effect(places);
        let options = SvdLoop { damping, cut, live, least, exact: EXACT, rounds, ..SvdLoop::default() };
        let report = svd_loop(start, &places.weights, &options, rows).map_err(|error| match error {
            SvdLoopError::Start(why) => why,
            SvdLoopError::NoLiveColumn => nothing(),
        })?;
        Ok(Fit {
            method,
            steps: 1,
            values: report.x.as_slice().to_vec(),
            weighted_rms: report.weighted_rms,
            largest: report.residual.amax(),
            rounds_in_all: report.rounds.len(),
            rounds: report.rounds,
            converged: report.converged,
        })
    }

    /// Variables in units in which each moves the flank alike at the start.
    fn gauss_newton(
        &self,
        places: &Places,
        free: &[Variable],
        start: DVector<f64>,
    ) -> Result<Fit, TangentialError> {
        let rows = |x: &DVector<f64>| self.rows(places, &self.fixed.with(free, x.as_slice()), free);
        let (_, jacobian) = rows(&start)?;
        let norms: Vec<f64> = jacobian.column_iter().map(|c| c.norm()).collect();
        let longest = norms.iter().copied().fold(0.0, f64::max);
        if longest <= least_effect(places) {
            return Err(TangentialError::NoLiveVariable { count: free.len() });
        }
        // A variable without effect at the start (a crossed-axes angle) keeps its own unit of a tenth of the most effective one.
        let units = DVector::from_fn(free.len(), |j, _| 1.0 / norms[j].max(0.1 * longest));
        let unscaled = |y: &DVector<f64>| &start + y.component_mul(&units);
        let options = GaussNewton {
            step_tolerance: 1e-9,
            longest_step: 3.0,
            cut: self.limits.cut,
            iterations: self.limits.rounds,
        };
        let rms = |residual: &DVector<f64>| {
            let weighted = residual.iter().zip(&places.weights).map(|(r, w)| (r * w) * (r * w));
            (weighted.sum::<f64>() / places.weights.len() as f64).sqrt()
        };
        // The method does not look back: where it loses its way, the best that it met is what it found.
        let (mut best, mut evaluations) = ((f64::INFINITY, start.clone(), f64::INFINITY), 0);
        let found = gauss_newton(DVector::zeros(free.len()), Some(&places.weights), &options, |y| {
            evaluations += 1;
            let x = unscaled(y);
            let (residual, mut jacobian) = rows(&x).ok()?;
            let now = rms(&residual);
            if now < best.0 {
                best = (now, x, residual.amax());
            }
            for (mut column, unit) in jacobian.column_iter_mut().zip(&units) {
                column *= *unit;
            }
            Some((residual, jacobian))
        });
        let (weighted_rms, values, largest) = best;
        Ok(Fit {
            method: FitMethod::GaussNewton,
            steps: 1,
            values: values.as_slice().to_vec(),
            weighted_rms,
            largest,
            rounds: Vec::new(),
            rounds_in_all: found.as_ref().map_or(evaluations, |found| found.iterations),
            converged: found.is_some_and(|found| found.converged),
        })
    }
}

/// The points of a fit with what is wanted there.
pub(super) struct Places {
    pub grids: Vec<(Flank, RollGrid)>,
    pub wanted: Vec<f64>,
    pub weights: Vec<f64>,
}

impl Places {
    /// With the share `share` of what varies along the face; the profile in the middle of the face is wanted in full.
    pub fn of(task: &FitTask<'_>, share: f64) -> Result<Self, TangentialError> {
        let mut places = Self { grids: Vec::new(), wanted: Vec::new(), weights: Vec::new() };
        let [from, to] = task.model.input().faces;
        let middle = 0.5 * (from + to);
        for &flank in task.pass {
            let grid = task.grid.of(task.model, flank);
            for (w, z) in grid.points() {
                let (there, profile) = ((task.wanted)(flank, w, z), (task.wanted)(flank, w, middle));
                let wanted = profile + share * (there - profile);
                if !wanted.is_finite() {
                    return Err(TangentialError::InvalidNumber {
                        field: "target",
                        value: wanted,
                        allowed: "a finite number at every point of the flank",
                    });
                }
                places.wanted.push(if share == 1.0 { there } else { wanted });
                places.weights.push(task.weights.at(task.model, flank, w, z));
            }
            places.grids.push((flank, grid));
        }
        Ok(places)
    }
}
