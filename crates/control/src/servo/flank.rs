//! What an error of the workpiece's angle is at the flank: its mean square and its peak over a stretch of samples.

use super::super::error::{ControlError, within};

/// Collects position errors as flank deviations f_n = e s_rot, um, normal to the flank (`docs/mathematics/gearbox.md#position-loop`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlankRecord {
    um_per_radian: f64,
    samples: u64,
    squares: f64,
    peak: f64,
}

impl FlankRecord {
    /// An empty record; `um_per_radian` is s_rot, the movement of the flank per angle of the workpiece.
    ///
    /// # Errors
    /// [`ControlError::BadParameter`].
    pub fn new(um_per_radian: f64) -> Result<Self, ControlError> {
        within("um_per_radian", um_per_radian, 0.0..=1e12, "0 to 1e12 um per rad")?;
        Ok(Self { um_per_radian, samples: 0, squares: 0.0, peak: 0.0 })
    }

    /// Adds the error (rad) of one sample and returns the flank deviation, um.
    #[inline]
    pub fn add(&mut self, error: f64) -> f64 {
        let deviation = error * self.um_per_radian;
        self.samples += 1;
        self.squares += deviation * deviation;
        self.peak = self.peak.max(deviation.abs());
        deviation
    }

    /// Samples added.
    pub fn samples(&self) -> u64 {
        self.samples
    }

    /// Root of the mean square, um; `None` without samples.
    pub fn rms_um(&self) -> Option<f64> {
        (self.samples > 0).then(|| (self.squares / self.samples as f64).sqrt())
    }

    /// Largest amount, um; 0 without samples.
    pub fn peak_um(&self) -> f64 {
        self.peak
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mean_square_and_peak() {
        let mut record = FlankRecord::new(1000.0).unwrap();
        assert_eq!((record.rms_um(), record.peak_um()), (None, 0.0));
        assert_eq!([0.003, -0.004].map(|error| record.add(error)), [3.0, -4.0]);
        assert_eq!((record.samples(), record.peak_um()), (2, 4.0));
        assert!((record.rms_um().unwrap() - 12.5f64.sqrt()).abs() < 1e-15);
        assert!(FlankRecord::new(f64::NAN).is_err());
    }
}
