//! The solver for four conditions on the four dressing corrections: damped Newton, and continuation where that fails
//! (`docs/mathematics/dressing.md#conditions`). Works in the K chart: the solution is the one connected with the start.

use crate::conditions::path_end::{axis_margin, correction_scale, reason_of_break};
use crate::conditions::rows::Made;
use crate::{Condition, ConditionsAlong, DressedProfile, DresserTool, DressingError, PathReason};
use foundation::geometry::Flank;
use foundation::inverse::{
    ContinuationOptions, NewtonError, NewtonOptions, Path, PathEnd, PathPoint, Watch, follow, newton,
};
use foundation::kinematics::DressingCorrection;
use nalgebra::{Matrix4, Vector4};

/// Solves four conditions for the four corrections.
#[derive(Clone, Copy, Debug)]
pub struct ConditionSolver<'a> {
    tool: &'a DresserTool,
    scale: Vector4<f64>,
    limits: Option<[[f64; 2]; 4]>,
}

/// The start is singular below this ratio of its smallest to its largest singular value
/// (`docs/mathematics/dressing.md#limits-of-a-correction`).
const SINGULAR: f64 = 1e-13;

/// Rows that are missed by less are met, mm or rad: where rows nearly depend on each other, the rounding of one of them, 1e-13
/// mm, moves the corrections by more than Newton's method may stall at.
const MET: f64 = 1e-10;

impl<'a> ConditionSolver<'a> {
    /// For a dresser on a worm of reference radius `reference_radius` (mm; scales the rotation).
    pub fn new(tool: &'a DresserTool, reference_radius: f64) -> Self {
        Self { tool, scale: correction_scale(reference_radius).into(), limits: None }
    }

    /// The same with a smallest and a largest value of each component of DK (rad, rad, mm, mm).
    pub fn with_limits(self, limits: [[f64; 2]; 4]) -> Self {
        Self { limits: Some(limits), ..self }
    }

    /// The dresser.
    pub fn tool(&self) -> &'a DresserTool {
        self.tool
    }

    /// Reference radius of the worm, mm.
    pub(crate) fn reference_radius(&self) -> f64 {
        1.0 / self.scale[0]
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
        let mut from_afar = f64::NAN;
        condition.row(self.tool, dk, &mut from_afar)
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
        self.rows_near(conditions, dk, &mut [f64::NAN; 4])
    }

    /// The same from the profile parameters found last.
    fn rows_near(
        &self,
        conditions: &[Condition; 4],
        dk: &DressingCorrection,
        hints: &mut [f64; 4],
    ) -> Result<(Vector4<f64>, Matrix4<f64>), DressingError> {
        let made = self.made(conditions, dk, hints)?;
        let residual = Vector4::from_fn(|i, _| made[i].value - conditions[i].wanted());
        Ok((residual, jacobian_of(&made)))
    }

    fn made(
        &self,
        conditions: &[Condition; 4],
        dk: &DressingCorrection,
        hints: &mut [f64; 4],
    ) -> Result<[Made; 4], DressingError> {
        let [a, b, c, d] = hints;
        let at = |i: usize, hint: &mut f64| conditions[i].made(self.tool, dk, hint);
        Ok([at(0, a)?, at(1, b)?, at(2, c)?, at(3, d)?])
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
        Ok(self.singular_values_of(&jacobian))
    }

    fn singular_values_of(&self, jacobian: &Matrix4<f64>) -> [f64; 4] {
        let values = (jacobian * Matrix4::from_diagonal(&self.scale)).singular_values();
        let mut values = [values[0], values[1], values[2], values[3]];
        values.sort_by(|a, b| b.total_cmp(a));
        values
    }

    /// Solves the conditions from `start`; if Newton fails, follows the solution from `start` while the residual there is
    /// scaled down to zero.
    ///
    /// # Errors
    /// [`DressingError::InvalidNumber`], [`DressingError::ConditionCount`], [`DressingError::TwoFlanksOfCone`],
    /// [`DressingError::Singular`],
    /// [`DressingError::NoZero`] with the reached share and what ended the path there, and those of the forward calculation at
    /// the start.
    pub fn solve(
        &self,
        conditions: &[Condition],
        start: &DressingCorrection,
    ) -> Result<DressingCorrection, DressingError> {
        self.check(conditions, start)?;
        let four: &[Condition; 4] =
            conditions.try_into().map_err(|_| DressingError::ConditionCount { count: conditions.len() })?;
        let different = (0..4).filter(|&i| !four[..i].contains(&four[i])).count();
        if different < 4 {
            return Err(DressingError::ConditionCount { count: different });
        }
        let mut hints = [f64::NAN; 4];
        let (residual, jacobian) = self.rows_near(four, start, &mut hints)?;
        let sigma = self.singular_values_of(&jacobian);
        if sigma[3].is_nan() || sigma[3] < SINGULAR * sigma[0] {
            return Err(DressingError::Singular { ratio: sigma[3] / sigma[0] });
        }
        let x = self.scaled(start);
        match self.newton(four, x, hints) {
            Ok(dk) if self.margin(&dk).0 >= 0.0 => Ok(dk),
            Err(NewtonError::Singular { ratio }) => Err(DressingError::Singular { ratio }),
            // Beyond a limit the path tells how far it is to it; the start can be evaluated, so nothing else is left.
            Ok(_) | Err(NewtonError::Stuck { .. } | NewtonError::NoStart) => {
                self.follow(four, x, &residual, hints)
            }
        }
    }

    fn check(&self, conditions: &[Condition], start: &DressingCorrection) -> Result<(), DressingError> {
        let invalid = |field, value, allowed| Err(DressingError::InvalidNumber { field, value, allowed });
        if let Some(&scale) = self.scale.iter().find(|x| !(x.is_finite() && **x > 0.0)) {
            return invalid("reference radius", 1.0 / scale, "> 0 mm");
        }
        if let Some(&x) = start.iter().find(|x| !x.is_finite()) {
            return invalid("correction at the start", x, "finite numbers");
        }
        if let Some([low, _]) =
            self.limits.iter().flatten().find(|[low, high]| low.is_nan() || high.is_nan() || low > high)
        {
            return invalid("axis limit", *low, "the smallest value first, no NaN");
        }
        Condition::check_all(conditions.iter(), self.tool)
    }

    fn scaled(&self, dk: &DressingCorrection) -> Vector4<f64> {
        Vector4::from_fn(|j, _| dk[j] / self.scale[j])
    }

    fn correction(&self, x: &Vector4<f64>) -> DressingCorrection {
        std::array::from_fn(|j| x[j] * self.scale[j])
    }

    /// Distance from the limits and the component concerned.
    fn margin(&self, dk: &DressingCorrection) -> (f64, usize) {
        self.limits.map_or((1.0, 0), |limits| {
            let (margin, j) = axis_margin(dk, &limits, &self.scale.into());
            // A component without limit is far from it, not infinitely far.
            (margin.min(1e9), j)
        })
    }

    fn newton(
        &self,
        conditions: &[Condition; 4],
        x: Vector4<f64>,
        mut hints: [f64; 4],
    ) -> Result<DressingCorrection, NewtonError> {
        self.root(x, |dk| self.rows_near(conditions, dk, &mut hints).ok())
    }

    /// The corrections at which rows vanish, by Newton's method.
    fn root(
        &self,
        x: Vector4<f64>,
        mut rows: impl FnMut(&DressingCorrection) -> Option<(Vector4<f64>, Matrix4<f64>)>,
    ) -> Result<DressingCorrection, NewtonError> {
        let mut nearest = (f64::INFINITY, x);
        let found = newton(x, &NewtonOptions::default(), |x| {
            let (r, j) = rows(&self.correction(x))?;
            let missed = r.amax();
            if missed < nearest.0 {
                nearest = (missed, *x);
            }
            Some((r, j * Matrix4::from_diagonal(&self.scale)))
        });
        match found {
            Ok(report) => Ok(self.correction(&report.x)),
            Err(NewtonError::Stuck { .. }) if nearest.0 < MET => Ok(self.correction(&nearest.1)),
            Err(error) => Err(error),
        }
    }

    /// Solves conditions at the worm position v whose wanted values stand where the dresser touches: places and values follow the correction
    /// in one iteration, whose Jacobian leaves out that they do. `None` where this does not converge or the rows ask for other lengths of
    /// roll at other places.
    pub(crate) fn solve_following(
        &self,
        conditions: &dyn ConditionsAlong,
        v: f64,
        rows: &[Condition; 4],
        start: &DressingCorrection,
    ) -> Option<DressingCorrection> {
        self.check(rows, start).ok()?;
        let mut hints = [f64::NAN; 4];
        let mut begun = false;
        let at = |dk: &DressingCorrection| {
            let made = self.made(rows, dk, &mut hints).ok()?;
            let places = made.each_ref().map(|made| made.b.map_or(0.0, |b| b - v));
            let there = conditions.at(v, &places);
            let jacobian = jacobian_of(&made);
            if !begun {
                let sigma = self.singular_values_of(&jacobian);
                (sigma[3] >= SINGULAR * sigma[0]).then_some(())?;
                begun = true;
            }
            let alike = (0..4).all(|i| there[i].asks_as(&rows[i]) && !there[..i].contains(&there[i]));
            let residual = Vector4::from_fn(|i, _| made[i].value - there[i].wanted());
            alike.then_some((residual, jacobian))
        };
        self.root(self.scaled(start), at).ok().filter(|dk| self.margin(dk).0 >= 0.0)
    }

    /// Follows the solution while the residual at the start is scaled from 1 to 0; the continuation parameter is the share removed.
    fn follow(
        &self,
        conditions: &[Condition; 4],
        start: Vector4<f64>,
        residual: &Vector4<f64>,
        mut hints: [f64; 4],
    ) -> Result<DressingCorrection, DressingError> {
        let scale = Matrix4::from_diagonal(&self.scale);
        let watch = |_: &PathPoint<4>, at: &PathPoint<4>| {
            let (margin, j) = self.margin(&self.correction(&at.x));
            Watch::Margin(margin, PathReason::AxisLimit(j))
        };
        let path: Path<4, PathReason> = follow::<4, 5, PathReason>(
            (start, 0.0),
            1.0,
            Some(1.0),
            &ContinuationOptions::default(),
            |x, share| {
                let (r, j) = self.rows_near(conditions, &self.correction(x), &mut hints).ok()?;
                Some((r - residual * (1.0 - share), j * scale, *residual))
            },
            watch,
        )
        .ok_or(DressingError::Singular { ratio: 0.0 })?;
        let last = path.last();
        let reason = match path.end {
            PathEnd::Target => match self.newton(conditions, last.x, hints) {
                Ok(dk) if self.margin(&dk).0 >= 0.0 => return Ok(dk),
                Ok(dk) => PathReason::AxisLimit(self.margin(&dk).1),
                Err(_) => PathReason::GivenUp,
            },
            PathEnd::Fold => PathReason::Fold,
            PathEnd::Stopped(reason) => reason,
            PathEnd::TooLong => PathReason::GivenUp,
            PathEnd::Broken => self.broken(conditions, &self.correction(&last.x)),
        };
        let flank = conditions.iter().find_map(Condition::flank).unwrap_or(Flank::Left);
        Err(DressingError::NoZero { flank, v: 0.0, fraction: last.parameter, reason })
    }

    /// Why the rows cannot be solved beyond DK.
    fn broken(&self, conditions: &[Condition; 4], dk: &DressingCorrection) -> PathReason {
        let circle = |condition: &Condition| {
            let flank = condition.flank()?;
            let profile = DressedProfile::new(self.tool, flank, *dk);
            let t = match *condition {
                Condition::Point { w, .. } => profile.at_roll(w).ok()?.t,
                Condition::Map { t, .. } => t,
                Condition::Head { .. } | Condition::Fixed { .. } => return None,
            };
            Some((profile, t))
        };
        let circles: Vec<_> = conditions.iter().filter_map(circle).collect();
        reason_of_break(&circles)
    }
}

fn jacobian_of(made: &[Made; 4]) -> Matrix4<f64> {
    Matrix4::from_fn(|i, j| made[i].gradient[j])
}
