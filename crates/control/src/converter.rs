//! The part of a workpiece pulse as a voltage: what a digital-to-analogue converter makes of the fine half of the rotation
//! (`docs/mathematics/gearbox.md#coarse-and-fine`).

use super::error::{ControlError, within};
use super::interpolation::Extremes;

/// A converter whose full scale is one workpiece pulse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Converter {
    /// Voltage of a whole workpiece pulse.
    volts_per_pulse: f64,
    /// Steps of it.
    steps: f64,
    /// Voltage at 0.
    offset: f64,
    /// Relative error of the slope.
    gain_error: f64,
}

impl Converter {
    /// With 1 to 24 bits.
    ///
    /// # Errors
    /// [`ControlError::BadParameter`] with the name of the field.
    pub fn new(volts_per_pulse: f64, bits: u32, offset: f64, gain_error: f64) -> Result<Self, ControlError> {
        within("volts_per_pulse", volts_per_pulse, 1e-6..=1e6, "1e-6 to 1e6 V")?;
        within("bits", f64::from(bits), 1.0..=24.0, "1 to 24")?;
        within("offset", offset, -1e6..=1e6, "-1e6 to 1e6 V")?;
        within("gain_error", gain_error, -1.0..=1.0, "-1 to 1")?;
        Ok(Self { volts_per_pulse, steps: f64::from(1u32 << bits), offset, gain_error })
    }

    /// Voltage for the part `fine` of `parts`.
    pub fn volts(&self, fine: u32, parts: u32) -> f64 {
        let step = (f64::from(fine) / f64::from(parts) * self.steps + 0.5).floor();
        step / self.steps * self.volts_per_pulse * (1.0 + self.gain_error) + self.offset
    }

    /// How far the voltage is off, workpiece pulses.
    pub fn error(&self, fine: u32, parts: u32) -> f64 {
        self.volts(fine, parts) / self.volts_per_pulse - f64::from(fine) / f64::from(parts)
    }

    /// Least and greatest error over all parts, workpiece pulses.
    pub fn limits(&self, parts: u32) -> Extremes {
        let mut limits = Extremes::NONE;
        (0..parts).for_each(|fine| limits.add(self.error(fine, parts)));
        limits
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_converter_with_enough_bits_is_exact() {
        let exact = Converter::new(10.0, 4, 0.0, 0.0).unwrap();
        assert_eq!(exact.volts(8, 16), 5.0);
        assert_eq!(exact.limits(16), Extremes { least: 0.0, greatest: 0.0 });
        // Three bits: 1/16 is half a step off.
        let coarse = Converter::new(10.0, 3, 0.0, 0.0).unwrap();
        assert_eq!(coarse.limits(16), Extremes { least: 0.0, greatest: 1.0 / 16.0 });
    }

    #[test]
    fn offset_and_gain_are_errors_of_the_sawtooth() {
        let off = Converter::new(5.0, 12, 0.05, 0.02).unwrap();
        let limits = off.limits(64);
        assert!(
            (limits.least - 0.01).abs() < 1e-15
                && (limits.greatest - (0.01 + 0.02 * 63.0 / 64.0)).abs() < 1e-15
        );
    }

    #[test]
    fn bad_converters_name_the_field() {
        let refused = |made: Result<Converter, ControlError>| match made {
            Err(ControlError::BadParameter { name, .. }) => name,
            other => panic!("{other:?}"),
        };
        assert_eq!(refused(Converter::new(0.0, 8, 0.0, 0.0)), "volts_per_pulse");
        assert_eq!(refused(Converter::new(1.0, 25, 0.0, 0.0)), "bits");
        assert_eq!(refused(Converter::new(1.0, 8, f64::NAN, 0.0)), "offset");
        assert_eq!(refused(Converter::new(1.0, 8, 0.0, 2.0)), "gain_error");
    }
}
