//! Analysis of variance of repeated readings on several teeth.

use super::SystematicError;
use foundation::numerics::fisher_upper;

/// What scatters between teeth and what within them, in the unit of the values.
#[derive(Clone, Debug, PartialEq)]
pub struct TeethVariance {
    /// Means of the teeth.
    pub teeth: Vec<f64>,
    /// Readings of each tooth, R.
    pub repeats: usize,
    /// Mean of all.
    pub mean: f64,
    /// Mean square between teeth.
    pub between: f64,
    /// Within teeth: mean square, F of the difference between teeth and its probability by chance, standard deviation of the teeth
    /// themselves; `None` for single readings.
    pub within: Option<WithinTeeth>,
}

/// What repeated readings tell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WithinTeeth {
    /// Mean square within teeth.
    pub square: f64,
    /// Mean square between over mean square within.
    pub f: f64,
    /// Probability of so large an F where teeth do not differ.
    pub p: f64,
    /// Standard deviation of the teeth without that of the readings.
    pub tooth_deviation: f64,
}

impl TeethVariance {
    /// Of readings `[tooth][repeat]`.
    ///
    /// # Errors
    /// [`SystematicError::TooFewTeeth`], [`SystematicError::OtherShape`] for teeth read differently often or never,
    /// [`SystematicError::InvalidNumber`].
    pub fn new(readings: &[Vec<f64>]) -> Result<Self, SystematicError> {
        let count = readings.len();
        if count < 2 {
            return Err(SystematicError::TooFewTeeth { teeth: count });
        }
        let repeats = readings[0].len().max(1);
        if let Some(other) = readings.iter().find(|r| r.len() != repeats) {
            let (name, found) = ("readings of a tooth", other.len());
            return Err(SystematicError::OtherShape { name, found, wanted: repeats });
        }
        if let Some(&value) = readings.iter().flatten().find(|y| !y.is_finite()) {
            let (name, allowed) = ("reading", "finite numbers");
            return Err(SystematicError::InvalidNumber { name, value, allowed });
        }
        let (n, r) = (count as f64, repeats as f64);
        let teeth: Vec<f64> = readings.iter().map(|y| y.iter().sum::<f64>() / r).collect();
        let mean = teeth.iter().sum::<f64>() / n;
        let between = r * teeth.iter().map(|m| (m - mean).powi(2)).sum::<f64>() / (n - 1.0);
        let within = (repeats > 1).then(|| {
            let squares = |(y, m): (&Vec<f64>, &f64)| y.iter().map(|y| (y - m).powi(2)).sum::<f64>();
            let freedom = n * (r - 1.0);
            let square = readings.iter().zip(&teeth).map(squares).sum::<f64>() / freedom;
            // Readings without any scatter: teeth differ for certain or not at all.
            let f = if between > 0.0 || square > 0.0 { between / square } else { 0.0 };
            WithinTeeth {
                square,
                f,
                p: fisher_upper(f, n - 1.0, freedom),
                tooth_deviation: ((between - square) / r).max(0.0).sqrt(),
            }
        });
        Ok(Self { teeth, repeats, mean, between, within })
    }

    /// Standard uncertainty of the mean from the scatter between teeth.
    pub fn uncertainty(&self) -> f64 {
        (self.between / (self.teeth.len() * self.repeats) as f64).sqrt()
    }
}
