//! What the encoder of the workpiece spindle gets wrong over a turn, and what that is on the teeth
//! (`docs/mathematics/gearbox.md#errors-of-what-is-measured`).

use super::error::{ControlError, within};
use super::interpolation::Extremes;
use std::f64::consts::TAU;

/// An error that repeats over the turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EncoderWave {
    /// Periods a turn.
    pub order: u32,
    /// Amplitude, rad.
    pub amplitude: f64,
    /// Phase, rad.
    pub phase: f64,
}

/// Angle that the encoder shows less the true one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EncoderErrors {
    waves: Vec<EncoderWave>,
}

/// What an encoder leaves on the teeth of a gear, as angles, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToothErrors {
    /// Least and greatest error of a tooth space.
    pub index: Extremes,
    /// Greatest difference of neighbours.
    pub single: f64,
}

impl EncoderErrors {
    /// Of errors that repeat. An eccentric disc is one of order 1 whose amplitude is eccentricity over radius of the graduation.
    ///
    /// # Errors
    /// [`ControlError::BadParameter`] with the name of the field.
    pub fn new(waves: Vec<EncoderWave>) -> Result<Self, ControlError> {
        for wave in &waves {
            within("order", f64::from(wave.order), 1.0..=1e6, "1 to 1e6 periods a turn")?;
            within("amplitude", wave.amplitude, 0.0..=1.0, "0 to 1 rad")?;
            within("phase", wave.phase, -1e6..=1e6, "-1e6 to 1e6 rad")?;
        }
        Ok(Self { waves })
    }

    /// Shown less true angle, rad.
    pub fn at(&self, angle: f64) -> f64 {
        self.waves
            .iter()
            .map(|wave| wave.amplitude * (f64::from(wave.order) * angle + wave.phase).sin())
            .sum()
    }

    /// Greatest error either way, rad.
    pub fn amplitude(&self) -> f64 {
        self.waves.iter().map(|wave| wave.amplitude).sum()
    }

    /// Errors of tooth spaces that are finished where the encoder says so: the workpiece stands the other way off.
    pub fn of_teeth(&self, teeth: u32) -> ToothErrors {
        let at = |tooth: u32| -self.at(TAU * f64::from(tooth % teeth.max(1)) / f64::from(teeth.max(1)));
        let mut index = Extremes::NONE;
        let mut single = 0.0f64;
        for tooth in 0..teeth.max(1) {
            index.add(at(tooth));
            single = single.max((at(tooth + 1) - at(tooth)).abs());
        }
        ToothErrors { index, single }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_eccentric_disc_makes_one_wave_of_pitches() {
        let wave = EncoderWave { order: 1, amplitude: 4e-5, phase: 0.3 };
        let errors = EncoderErrors::new(vec![wave]).unwrap();
        let teeth = errors.of_teeth(40);
        // Chord between two of 40 points on a circle: 2 sin(pi/40), times the amplitude at most.
        assert!((teeth.index.range() - 8e-5).abs() < 8e-5 * 4e-3, "{teeth:?}");
        let chord = 2.0 * 4e-5 * (std::f64::consts::PI / 40.0).sin();
        assert!(teeth.single <= chord && teeth.single > 0.996 * chord, "{teeth:?}");
        assert_eq!(errors.amplitude(), 4e-5);
    }

    #[test]
    fn an_order_of_the_teeth_is_not_seen_on_them() {
        let wave = EncoderWave { order: 40, amplitude: 1e-4, phase: 0.3 };
        let teeth = EncoderErrors::new(vec![wave]).unwrap().of_teeth(40);
        assert!(teeth.single < 1e-16 && teeth.index.range() < 1e-16);
    }

    #[test]
    fn bad_waves_name_the_field() {
        for (name, wave) in [
            ("order", EncoderWave { order: 0, amplitude: 0.0, phase: 0.0 }),
            ("amplitude", EncoderWave { order: 1, amplitude: f64::NAN, phase: 0.0 }),
            ("phase", EncoderWave { order: 1, amplitude: 0.0, phase: f64::INFINITY }),
        ] {
            let refused = EncoderErrors::new(vec![wave]);
            assert!(matches!(refused, Err(ControlError::BadParameter { name: found, .. }) if found == name));
        }
    }
}
