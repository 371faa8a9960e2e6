//! How well a decomposition meets its samples.

/// Residuals f - fit over all samples.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FitQuality {
    /// Root of the mean square, mm.
    pub rms: f64,
    /// Root of the mean square of residual over tolerance: what the fit makes small.
    pub weighted_rms: f64,
    /// Largest magnitude, mm.
    pub largest: f64,
    /// Largest magnitude over the tolerance of its sample.
    pub tolerance_ratio: f64,
}

impl FitQuality {
    /// From pairs (residual, tolerance).
    pub(super) fn of(residuals: impl Iterator<Item = (f64, f64)>) -> Self {
        let (mut count, mut sum, mut weighted) = (0usize, 0.0, 0.0);
        let mut quality = Self::default();
        for (residual, tolerance) in residuals {
            count += 1;
            sum += residual * residual;
            weighted += (residual / tolerance).powi(2);
            quality.largest = quality.largest.max(residual.abs());
            quality.tolerance_ratio = quality.tolerance_ratio.max(residual.abs() / tolerance);
        }
        quality.weighted_rms = (weighted / count.max(1) as f64).sqrt();
        quality.rms = (sum / count.max(1) as f64).sqrt();
        quality
    }
}
