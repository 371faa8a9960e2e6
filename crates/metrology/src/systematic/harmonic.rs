//! The first harmonic of the rotation in the means of the teeth: run-out and wobble of the clamping, not of the process.

use foundation::numerics::{Harmonic, fisher_upper};

/// c + A cos(theta) + B sin(theta) through the means of the teeth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FirstHarmonic {
    /// Amplitude, in the unit of the values.
    pub amplitude: f64,
    /// Phase atan2(B, A), rad.
    pub phase: f64,
    /// How much better it fits than the mean alone.
    pub f: f64,
    /// Probability of so large an F by chance.
    pub p: f64,
    /// c.
    pub mean: f64,
    /// Standard uncertainty of c.
    pub uncertainty: f64,
}

/// Fewer teeth do not tell a harmonic from scatter.
const TEETH: usize = 5;

impl FirstHarmonic {
    /// Through means at tooth angles, rad. `None` with fewer than five teeth, and where the angles do not tell mean and harmonic apart.
    pub fn new(teeth: &[f64], angles: &[f64]) -> Option<Self> {
        if teeth.len() < TEETH {
            return None;
        }
        let rows = || angles.iter().map(|angle| Harmonic::row(*angle)).zip(teeth.iter().copied());
        let fit = Harmonic::over(rows().map(|(row, _)| row))?;
        // Sums of squares of numbers up to 1: a share of 1e-12 is one of 1e-6 in the numbers.
        let values = fit.normal.symmetric_eigenvalues();
        if values.min() <= 1e-12 * values.max() {
            return None;
        }
        let x = fit.through(rows());
        let count = teeth.len() as f64;
        let mean = teeth.iter().sum::<f64>() / count;
        let fitted = |angle: f64| x[0] + x[1] * angle.cos() + x[2] * angle.sin();
        let before: f64 = teeth.iter().map(|m| (m - mean).powi(2)).sum();
        let after: f64 = teeth.iter().zip(angles).map(|(m, a)| (m - fitted(*a)).powi(2)).sum();
        let freedom = count - 3.0;
        let f = if before > after { (before - after) / 2.0 / (after / freedom) } else { 0.0 };
        Some(Self {
            amplitude: x[1].hypot(x[2]),
            phase: x[2].atan2(x[1]),
            f,
            p: fisher_upper(f, 2.0, freedom),
            mean: x[0],
            uncertainty: (after / freedom * fit.inverse[(0, 0)]).sqrt(),
        })
    }
}

/// Largest share of a first harmonic that stays in the mean over teeth at these angles (rad), whatever its phase: 0 for teeth evenly around
/// the gear, nearly 1 for neighbours.
pub fn harmonic_left_in_mean(angles: &[f64]) -> f64 {
    let sum = |f: fn(f64) -> f64| angles.iter().map(|a| f(*a)).sum::<f64>() / angles.len() as f64;
    sum(f64::cos).hypot(sum(f64::sin))
}
