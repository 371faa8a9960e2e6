//! Target, produced (planned or simulated) and measured flank on one grid: the differences and whether the process model explains what was
//! measured. Knows no process.

use super::{ArealDegree, ArealError, ArealField, ArealFit};
use crate::Topography;

/// One flank minus another, mm. Thickness is judged elsewhere: all but the mean is about the mean.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// Mean.
    pub mean: f64,
    /// Root mean square about the mean.
    pub rms: f64,
    /// Largest distance from the mean.
    pub largest: f64,
    /// Largest minus smallest.
    pub range: f64,
    /// The areal fit: features, explained share.
    pub fit: ArealFit,
    /// Share of the points within the tolerance about the mean.
    pub within_tolerance: f64,
}

/// The three differences of a flank.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Produced minus target.
    pub produced: Difference,
    /// Measured minus target.
    pub measured: Difference,
    /// Measured minus produced.
    pub model: Difference,
    /// Correlation of measured and produced deviations about their means; `None` where one of them does not vary.
    pub correlation: Option<f64>,
}

/// Above this correlation the process model may explain the part.
const EXPLAINS: f64 = 0.9;

impl Difference {
    /// Of a difference on a grid (NaN = no value), judged by a tolerance about the mean, mm.
    ///
    /// # Errors
    /// [`ArealError::InvalidNumber`] for a tolerance that is not above 0; those of [`ArealFit::of_grid`].
    pub fn new(
        difference: &Topography,
        field: &ArealField,
        degree: ArealDegree,
        tolerance: f64,
    ) -> Result<Self, ArealError> {
        if !(tolerance.is_finite() && tolerance > 0.0) {
            let (name, allowed) = ("tolerance", "finite numbers above 0");
            return Err(ArealError::InvalidNumber { name, value: tolerance, allowed });
        }
        let fit = ArealFit::of_grid(difference, field, degree)?;
        let known: Vec<f64> = difference.f.iter().copied().filter(|f| f.is_finite()).collect();
        let count = known.len() as f64;
        let mean = known.iter().sum::<f64>() / count;
        let about: Vec<f64> = known.iter().map(|f| f - mean).collect();
        let ends = about.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(*x), b.max(*x)]);
        let inside = about.iter().filter(|x| x.abs() <= tolerance).count();
        Ok(Self {
            mean,
            rms: foundation::numerics::root_mean_square(&about),
            largest: ends[1].max(-ends[0]),
            range: ends[1] - ends[0],
            fit,
            within_tolerance: inside as f64 / count,
        })
    }
}

impl Comparison {
    /// Of three flanks on one grid over `field`.
    ///
    /// # Errors
    /// [`ArealError::OtherShape`] for flanks on different grids; those of [`Difference::new`].
    pub fn new(
        [target, produced, measured]: [&Topography; 3],
        field: &ArealField,
        degree: ArealDegree,
        tolerance: f64,
    ) -> Result<Self, ArealError> {
        for other in [produced, measured] {
            if other.w != target.w || other.z != target.z {
                let (found, wanted) = (other.f.len(), target.f.len());
                return Err(ArealError::OtherShape { name: "places of the target's grid", found, wanted });
            }
        }
        let (made, seen) = (produced.minus(target), measured.minus(target));
        let of = |difference: &Topography| Difference::new(difference, field, degree, tolerance);
        Ok(Self {
            produced: of(&made)?,
            measured: of(&seen)?,
            model: of(&measured.minus(produced))?,
            correlation: correlation(&made.f, &seen.f),
        })
    }

    /// Whether the process model explains the part: what it leaves open stays within `limit` (mm) about its mean, and the
    /// deviations that it predicts were measured.
    pub fn model_explains(&self, limit: f64) -> bool {
        self.correlation.is_some_and(|c| c > EXPLAINS) && self.model.largest <= limit
    }
}

/// Correlation over the points where both have values.
fn correlation(a: &[f64], b: &[f64]) -> Option<f64> {
    let both: Vec<(f64, f64)> =
        a.iter().copied().zip(b.iter().copied()).filter(|(a, b)| a.is_finite() && b.is_finite()).collect();
    let count = both.len() as f64;
    let (mean_a, mean_b) =
        (both.iter().map(|p| p.0).sum::<f64>() / count, both.iter().map(|p| p.1).sum::<f64>() / count);
    let sum = |f: &dyn Fn(f64, f64) -> f64| both.iter().map(|&(a, b)| f(a - mean_a, b - mean_b)).sum::<f64>();
    let (square_a, square_b) = (sum(&|a, _| a * a), sum(&|_, b| b * b));
    (square_a > 0.0 && square_b > 0.0).then(|| sum(&|a, b| a * b) / (square_a * square_b).sqrt())
}
