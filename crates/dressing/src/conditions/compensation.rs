//! Compensation calculation: the correction that comes nearest to more than four conditions, of one flank or both, while others are
//! met exactly (`docs/mathematics/dressing.md#conditions`).

use crate::conditions::path_end::correction_scale;
use crate::{Condition, DresserTool, DressingError, PathReason};
use foundation::geometry::Flank;
use foundation::inverse::{ConstrainedReport, GaussNewton, Rows, constrained_gauss_newton};
use foundation::kinematics::DressingCorrection;
use nalgebra::{DMatrix, DVector};

/// A condition that is to be met as well as possible.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SoftCondition {
    /// What is wanted.
    pub condition: Condition,
    /// Weight of its residual: pure for modifications (mm), and for other rows what turns their mm or rad into mm of
    /// modification.
    pub weight: f64,
}

/// A compensation calculation.
#[derive(Clone, Debug)]
pub struct Compensation<'a> {
    tool: &'a DresserTool,
    reference_radius: f64,
    soft: Vec<SoftCondition>,
    hard: Vec<Condition>,
    shortest: bool,
}

/// What comes nearest.
#[derive(Clone, Debug, PartialEq)]
pub struct Compensated {
    /// DK.
    pub dk: DressingCorrection,
    /// What is left of each soft condition: value less wanted one, mm or rad.
    pub residuals: Vec<f64>,
    /// Root of the weighted mean of squares of the residuals.
    pub rms: f64,
    /// Singular values of the weighted soft rows in what the hard ones leave free, in scaled unknowns, descending.
    pub singular_values: Vec<f64>,
    /// How many of the four corrections the rows determine.
    pub rank: usize,
}

/// Steps in which the targets are approached where one is too far: shortest share of the way.
const LEAST_SHARE: f64 = 1e-3;
/// Iterations of one approach.
const ITERATIONS: usize = 60;

impl<'a> Compensation<'a> {
    /// For a dresser on a worm of reference radius `reference_radius` (mm; scales the rotation).
    pub fn new(
        tool: &'a DresserTool,
        reference_radius: f64,
        soft: Vec<SoftCondition>,
        hard: Vec<Condition>,
    ) -> Self {
        Self { tool, reference_radius, soft, hard, shortest: false }
    }

    /// Accepts conditions that leave corrections open: of all that come nearest the shortest in scaled unknowns (1/r_S and 1/20
    /// rad, 1 and 5 mm) is taken.
    pub fn shortest(self) -> Self {
        Self { shortest: true, ..self }
    }

    /// The correction sought from `start`.
    ///
    /// # Errors
    /// [`DressingError::InvalidNumber`]; [`DressingError::Underdetermined`] unless the shortest correction is asked for;
    /// [`DressingError::ConditionCount`] for more than four or equal hard conditions; [`DressingError::Singular`] for hard
    /// conditions that depend on each other; [`DressingError::NoZero`] with the share of the way to the targets that was reached;
    /// [`DressingError::TwoFlanksOfCone`]; those of the forward calculation at the start.
    pub fn solve(&self, start: &DressingCorrection) -> Result<Compensated, DressingError> {
        self.check(start)?;
        let scale = correction_scale(self.reference_radius);
        let mut x = DVector::from_fn(4, |j, _| start[j] / scale[j]);
        let mut hints = vec![f64::NAN; self.soft.len() + self.hard.len()];
        let (soft, hard) = self.rows(&x, &mut hints)?;
        self.check_start(&soft, &hard)?;
        // The targets approach the wanted ones from what the start makes, in one step where that works.
        let (mut reached, mut step) = (0.0, 1.0);
        while step >= LEAST_SHARE {
            let next = f64::min(reached + step, 1.0);
            let open = 1.0 - next;
            let report = self.approach(&x, &mut hints.clone(), (&soft.0 * open, &hard.0 * open));
            match report {
                Some(report) if report.converged => {
                    (reached, x) = (next, report.x.clone());
                    if reached >= 1.0 {
                        return self.compensated(&report);
                    }
                    step *= 1.5;
                }
                _ => step *= 0.5,
            }
        }
        let rows = || self.hard.iter().chain(self.soft.iter().map(|soft| &soft.condition));
        let flank = rows().find_map(Condition::flank).unwrap_or(Flank::Left);
        Err(DressingError::NoZero { flank, v: 0.0, fraction: reached, reason: PathReason::GivenUp })
    }

    /// Gauss-Newton with parts of the residuals at the start still left open.
    fn approach(
        &self,
        x: &DVector<f64>,
        hints: &mut [f64],
        (open_soft, open_hard): (DVector<f64>, DVector<f64>),
    ) -> Option<ConstrainedReport> {
        let weights: Vec<f64> = self.soft.iter().map(|soft| soft.weight).collect();
        let options = GaussNewton { iterations: ITERATIONS, ..GaussNewton::default() };
        constrained_gauss_newton(x.clone(), &weights, self.shortest, &options, |x| {
            let (soft, hard) = self.rows(x, hints).ok()?;
            Some(((soft.0 - &open_soft, soft.1), (hard.0 - &open_hard, hard.1)))
        })
    }

    /// Soft and hard rows in scaled unknowns.
    fn rows(&self, x: &DVector<f64>, hints: &mut [f64]) -> Result<(Rows, Rows), DressingError> {
        let scale = correction_scale(self.reference_radius);
        let dk: DressingCorrection = std::array::from_fn(|j| x[j] * scale[j]);
        let (soft_hints, hard_hints) = hints.split_at_mut(self.soft.len());
        let rows = |conditions: &mut dyn Iterator<Item = &Condition>,
                    hints: &mut [f64]|
         -> Result<Rows, DressingError> {
            let mut rows = (DVector::zeros(hints.len()), DMatrix::zeros(hints.len(), 4));
            for (i, (condition, hint)) in conditions.zip(hints).enumerate() {
                let (value, gradient) = condition.row(self.tool, &dk, hint)?;
                rows.0[i] = value;
                for j in 0..4 {
                    rows.1[(i, j)] = gradient[j] * scale[j];
                }
            }
            Ok(rows)
        };
        let soft = rows(&mut self.soft.iter().map(|soft| &soft.condition), soft_hints)?;
        Ok((soft, rows(&mut self.hard.iter(), hard_hints)?))
    }

    fn check(&self, start: &DressingCorrection) -> Result<(), DressingError> {
        let invalid = |field, value, allowed| Err(DressingError::InvalidNumber { field, value, allowed });
        if !(self.reference_radius.is_finite() && self.reference_radius > 0.0) {
            return invalid("reference radius", self.reference_radius, "> 0 mm");
        }
        if let Some(&x) = start.iter().find(|x| !x.is_finite()) {
            return invalid("correction at the start", x, "finite numbers");
        }
        if let Some(soft) = self.soft.iter().find(|soft| !(soft.weight.is_finite() && soft.weight > 0.0)) {
            return invalid("weight", soft.weight, "finite numbers > 0");
        }
        let rows = || self.hard.iter().chain(self.soft.iter().map(|soft| &soft.condition));
        Condition::check_all(rows(), self.tool)?;
        let different = (0..self.hard.len()).filter(|&i| !self.hard[..i].contains(&self.hard[i])).count();
        if different < self.hard.len() || different > 4 {
            return Err(DressingError::ConditionCount { count: different });
        }
        let rows = self.soft.len() + self.hard.len();
        if rows < 4 && !self.shortest {
            return Err(DressingError::Underdetermined { rows, rank: rows });
        }
        Ok(())
    }

    /// Whether the rows determine the correction at the start.
    fn check_start(&self, soft: &Rows, hard: &Rows) -> Result<(), DressingError> {
        let cut = GaussNewton::default().cut;
        let sigma = |a: &DMatrix<f64>| {
            let mut sigma: Vec<f64> = a.clone().singular_values().iter().copied().collect();
            sigma.sort_by(|a, b| b.total_cmp(a));
            sigma
        };
        let rank = |sigma: &[f64]| sigma.iter().filter(|&&s| s > cut * sigma[0]).count();
        if !self.hard.is_empty() {
            let sigma = sigma(&hard.1);
            if rank(&sigma) < self.hard.len() {
                return Err(DressingError::Singular { ratio: sigma[self.hard.len() - 1] / sigma[0] });
            }
        }
        if !self.shortest {
            let rows = self.soft.len() + self.hard.len();
            let all = DMatrix::from_fn(rows, 4, |i, j| match i.checked_sub(self.hard.len()) {
                None => hard.1[(i, j)],
                Some(i) => soft.1[(i, j)] * self.soft[i].weight,
            });
            let rank = rank(&sigma(&all));
            if rank < 4 {
                return Err(DressingError::Underdetermined { rows, rank });
            }
        }
        Ok(())
    }

    fn compensated(&self, report: &ConstrainedReport) -> Result<Compensated, DressingError> {
        let scale = correction_scale(self.reference_radius);
        let rank = report.hard_rank.rank + report.soft_rank.rank;
        if rank < 4 && !self.shortest {
            let rows = self.soft.len() + self.hard.len();
            return Err(DressingError::Underdetermined { rows, rank });
        }
        let residuals: Vec<f64> = report.soft.iter().copied().collect();
        let squares = |of: &dyn Fn(usize) -> f64| (0..residuals.len()).map(|i| of(i).powi(2)).sum::<f64>();
        let weights = squares(&|i| self.soft[i].weight);
        let rms = if weights > 0.0 {
            (squares(&|i| self.soft[i].weight * residuals[i]) / weights).sqrt()
        } else {
            0.0
        };
        Ok(Compensated {
            dk: std::array::from_fn(|j| report.x[j] * scale[j]),
            rms,
            residuals,
            singular_values: report.soft_rank.singular_values.clone(),
            rank,
        })
    }
}
