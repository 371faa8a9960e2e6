//! What is decomposed: values of a flank at points, each with the tolerance that decides its weight.

use super::super::GeneratingError;
use foundation::modification::{EvaluationError, Modification};
use foundation::numerics::equidistant;

/// Points in w and z of the default grid (`docs/mathematics/planning.md#producibility`).
pub const DEFAULT_GRID: [usize; 2] = [25, 31];

/// Finite values f_t [mm] at points (w, z) [mm] with positive tolerances [mm].
#[derive(Clone, Debug, PartialEq)]
pub struct Samples {
    points: Vec<[f64; 2]>,
    values: Vec<f64>,
    tolerances: Vec<f64>,
}

impl Samples {
    /// The modification on an equidistant grid over its evaluation field, w slow; tolerances 1 mm.
    ///
    /// # Errors
    /// `TooFewPoints` below 2 x 2 points, `AmountNotFinite`, and the errors of the evaluation.
    pub fn of_modification(
        modification: &Modification,
        [nw, nz]: [usize; 2],
    ) -> Result<Self, GeneratingError> {
        if nw < 2 || nz < 2 {
            return Err(GeneratingError::TooFewPoints { points: nw.saturating_mul(nz), needed: 4 });
        }
        let field = modification.field();
        let (rolls, faces) = (equidistant(field.roll(), nw), equidistant(field.face(), nz));
        let mut points = Vec::new();
        for &w in &rolls {
            for &z in &faces {
                let f = modification.value(w, z).map_err(|error| match error {
                    EvaluationError::NotFinite { w, z } => GeneratingError::AmountNotFinite { w, z },
                    other => other.into(),
                })?;
                points.push([w, z, f]);
            }
        }
        Self::of_points(&points)
    }

    /// A cloud of points [w, z, f_t], mm; tolerances 1 mm.
    ///
    /// # Errors
    /// `AmountNotFinite`.
    pub fn of_points(points: &[[f64; 3]]) -> Result<Self, GeneratingError> {
        if let Some(&[w, z, _]) = points.iter().find(|p| p.iter().any(|x| !x.is_finite())) {
            return Err(GeneratingError::AmountNotFinite { w, z });
        }
        Ok(Self {
            points: points.iter().map(|&[w, z, _]| [w, z]).collect(),
            values: points.iter().map(|p| p[2]).collect(),
            tolerances: vec![1.0; points.len()],
        })
    }

    /// The same points with tolerances [mm] from a map over (w, z); their weight is 1/tolerance.
    ///
    /// # Errors
    /// `ToleranceNotPositive` for tolerances that are no positive numbers.
    pub fn with_tolerance(self, tolerance: impl Fn(f64, f64) -> f64) -> Result<Self, GeneratingError> {
        let tolerances: Vec<f64> = self.points.iter().map(|&[w, z]| tolerance(w, z)).collect();
        self.with_tolerances(&tolerances)
    }

    /// The same points with one tolerance [mm] each.
    ///
    /// # Errors
    /// As [`Samples::with_tolerance`]; a missing tolerance is reported as NaN.
    pub fn with_tolerances(self, tolerances: &[f64]) -> Result<Self, GeneratingError> {
        for (i, &[w, z]) in self.points.iter().enumerate() {
            let value = tolerances.get(i).copied().unwrap_or(f64::NAN);
            // 1/tolerance must be a number too.
            if !(value.is_finite() && value > 0.0 && (1.0 / value).is_finite()) {
                return Err(GeneratingError::ToleranceNotPositive { w, z, value });
            }
        }
        Ok(Self { tolerances: tolerances[..self.points.len()].to_vec(), ..self })
    }

    /// Number of points.
    pub fn count(&self) -> usize {
        self.points.len()
    }

    /// (w, z) of every point, mm.
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// f_t of every point, mm.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Tolerance of every point, mm.
    pub fn tolerances(&self) -> &[f64] {
        &self.tolerances
    }
}
