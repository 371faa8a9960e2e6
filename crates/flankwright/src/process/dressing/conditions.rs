//! Conditions on a dressing correction and the solver for four of them (spec 30 section 8).

use super::forward::head_gradient;
use super::{DressedProfile, DresserTool, DressingError};
use crate::geometry::Flank;
use crate::inverse::{NewtonError, NewtonOptions, newton};
use crate::kinematics::DressingCorrection;
use nalgebra::{Matrix4, Vector4};

/// One row: what the dressed worm must fulfil.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Condition {
    /// Pitch point: modification f (mm) at length of roll w (mm).
    Point {
        /// Flank.
        flank: Flank,
        /// Length of roll, mm.
        w: f64,
        /// Wanted f_n, mm.
        f: f64,
    },
    /// Radius map: dresser parameter t dresses length of roll w.
    Map {
        /// Flank.
        flank: Flank,
        /// Dresser parameter, mm.
        t: f64,
        /// Length of roll, mm.
        w: f64,
    },
    /// Head height: the head profile at t_H dresses radius r.
    Head {
        /// Parameter of the head profile, mm.
        t: f64,
        /// Radius, mm.
        r: f64,
    },
    /// Missing degree of freedom: correction j (0..3) is fixed.
    Fixed {
        /// Component of DK.
        j: usize,
        /// Its value, rad or mm.
        x: f64,
    },
}

/// Solves four conditions for the four corrections.
#[derive(Clone, Copy, Debug)]
pub struct ConditionSolver<'a> {
    tool: &'a DresserTool,
    scale: Vector4<f64>,
}

impl<'a> ConditionSolver<'a> {
    /// For a dresser on a worm of reference radius `reference_radius` (mm; scales the rotation).
    pub fn new(tool: &'a DresserTool, reference_radius: f64) -> Self {
        Self { tool, scale: Vector4::new(1.0 / reference_radius, 1.0 / 20.0, 1.0, 5.0) }
    }

    /// Sizes of one scaled unknown: r_S^-1 rad, 1/20 rad, 1 mm, 5 mm.
    pub fn scale(&self) -> DressingCorrection {
        self.scale.into()
    }

    /// Residual and gradient of one row at DK.
    ///
    /// # Errors
    /// Those of the forward calculation.
    pub fn row(
        &self,
        condition: &Condition,
        dk: &DressingCorrection,
    ) -> Result<(f64, [f64; 4]), DressingError> {
        match *condition {
            Condition::Point { flank, w, f } => {
                let at = DressedProfile::new(self.tool, flank, *dk).at_roll(w)?;
                Ok((at.f - f, at.df_dk))
            }
            Condition::Map { flank, t, w } => {
                let (value, gradient) = DressedProfile::new(self.tool, flank, *dk).map_gradient(t)?;
                Ok((value - w, gradient))
            }
            Condition::Head { t, r } => {
                let (value, gradient) = head_gradient(self.tool, t, dk)?;
                Ok((value - r, gradient))
            }
            Condition::Fixed { j, x } => {
                let mut gradient = [0.0; 4];
                gradient[j] = 1.0;
                Ok((dk[j] - x, gradient))
            }
        }
    }

    /// Residuals and Jacobian (columns phi_S, gamma, d, v_y) of four rows at DK.
    ///
    /// # Errors
    /// Those of the forward calculation.
    pub fn rows(
        &self,
        conditions: &[Condition; 4],
        dk: &DressingCorrection,
    ) -> Result<(Vector4<f64>, Matrix4<f64>), DressingError> {
        let mut residual = Vector4::zeros();
        let mut jacobian = Matrix4::zeros();
        for (i, condition) in conditions.iter().enumerate() {
            let (value, gradient) = self.row(condition, dk)?;
            residual[i] = value;
            for j in 0..4 {
                jacobian[(i, j)] = gradient[j];
            }
        }
        Ok((residual, jacobian))
    }

    /// Singular values of the rows in scaled unknowns (phi/r_S, gamma/20, d, 5 v), descending.
    ///
    /// # Errors
    /// Those of the forward calculation.
    pub fn singular_values(
        &self,
        conditions: &[Condition; 4],
        dk: &DressingCorrection,
    ) -> Result<[f64; 4], DressingError> {
        let (_, jacobian) = self.rows(conditions, dk)?;
        let mut values: Vec<f64> =
            (jacobian * Matrix4::from_diagonal(&self.scale)).singular_values().iter().copied().collect();
        values.sort_by(|a, b| b.total_cmp(a));
        Ok([values[0], values[1], values[2], values[3]])
    }

    /// Solves the conditions from `start`; if Newton fails, follows the solution from `start` while the residual there is
    /// scaled down to zero.
    ///
    /// # Errors
    /// [`DressingError::ConditionCount`], [`DressingError::Singular`], [`DressingError::NoZero`] with the reached
    /// share, and those of the forward calculation at the start.
    pub fn solve(
        &self,
        conditions: &[Condition],
        start: &DressingCorrection,
    ) -> Result<DressingCorrection, DressingError> {
        let four: &[Condition; 4] =
            conditions.try_into().map_err(|_| DressingError::ConditionCount { count: conditions.len() })?;
        for i in 0..4 {
            for j in 0..i {
                if four[i] == four[j] {
                    return Err(DressingError::ConditionCount { count: 3 });
                }
            }
        }
        let options = NewtonOptions::default();
        match self.newton_to(four, start, &Vector4::zeros(), &options) {
            Ok(dk) => Ok(dk),
            Err(NewtonError::NoStart) => {
                Err(self.rows(four, start).err().unwrap_or(DressingError::PoleOfChart))
            }
            Err(NewtonError::Singular { ratio }) => Err(DressingError::Singular { ratio }),
            Err(NewtonError::Stuck { .. }) => self.follow(four, start, &options),
        }
    }

    fn newton_to(
        &self,
        conditions: &[Condition; 4],
        start: &DressingCorrection,
        offset: &Vector4<f64>,
        options: &NewtonOptions,
    ) -> Result<DressingCorrection, NewtonError> {
        let dk = |x: &Vector4<f64>| -> DressingCorrection { std::array::from_fn(|j| x[j] * self.scale[j]) };
        let x0 = Vector4::from_fn(|j, _| start[j] / self.scale[j]);
        let report = newton(x0, options, |x| {
            let (r, j) = self.rows(conditions, &dk(x)).ok()?;
            Some((r - offset, j * Matrix4::from_diagonal(&self.scale)))
        })?;
        Ok(dk(&report.x))
    }

    /// Follows the solution while the residual at the start is scaled from 1 to 0.
    fn follow(
        &self,
        conditions: &[Condition; 4],
        start: &DressingCorrection,
        options: &NewtonOptions,
    ) -> Result<DressingCorrection, DressingError> {
        let (at_start, _) = self.rows(conditions, start)?;
        let (mut reached, mut step, mut dk) = (0.0, 0.1, *start);
        while step > 1e-4 {
            let next = f64::min(reached + step, 1.0);
            match self.newton_to(conditions, &dk, &(at_start * (1.0 - next)), options) {
                // A jump to another branch is no continuation of this one.
                Ok(found) if self.distance(&found, &dk) < 20.0 * step.sqrt() => {
                    (reached, dk) = (next, found);
                    if reached >= 1.0 {
                        return Ok(dk);
                    }
                    step *= 1.4;
                }
                _ => step *= 0.5,
            }
        }
        let flank = conditions
            .iter()
            .find_map(|c| match c {
                Condition::Point { flank, .. } | Condition::Map { flank, .. } => Some(*flank),
                _ => None,
            })
            .unwrap_or(Flank::Left);
        let reason = if self.rows(conditions, &dk).is_ok() { "fold" } else { "contact lost" };
        Err(DressingError::NoZero { flank, v: 0.0, fraction: reached, reason })
    }

    fn distance(&self, a: &DressingCorrection, b: &DressingCorrection) -> f64 {
        (0..4).map(|j| ((a[j] - b[j]) / self.scale[j]).powi(2)).sum::<f64>().sqrt()
    }
}
