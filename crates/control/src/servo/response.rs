//! The answer of the linear loop to a disturbing torque, in closed form (`docs/mathematics/gearbox.md#position-loop`).

use super::super::error::{ControlError, within};
use super::parameters::ServoParameters;
use super::stability::characteristic;
use nalgebra::Complex;
use std::f64::consts::TAU;

impl ServoParameters {
    /// Position error (setpoint minus actual angle) per torque at `frequency` (Hz), rad/Nm: modulus and phase of the
    /// samples. It holds for the linear loop: torque within its limit, no quantisation, speed well above that at which
    /// friction turns round.
    ///
    /// # Errors
    /// [`ControlError::BadParameter`], also for a frequency beyond half the sampling rate;
    /// [`ControlError::UnstableLoop`].
    pub fn disturbance_response(&self, frequency: f64) -> Result<Complex<f64>, ControlError> {
        self.validate()?;
        let half_rate = 0.5 / self.sample_time;
        within("frequency", frequency, 0.0..=half_rate, "0 to half the sampling rate, Hz")?;
        // u = z - 1 without loss at low frequencies.
        let half = 0.5 * TAU * frequency * self.sample_time;
        let u = Complex::new(-2.0 * half.sin() * half.sin(), (2.0 * half).sin());
        let [c0, c1, c2] = characteristic(self);
        // g = Ts z/(z - 1), numerator and denominator times (z - 1)^2: regular at standstill, where the answer is 0.
        let gain = self.sample_time / self.drive.inertia * self.sample_time;
        Ok(-(u * (u + 1.0) * gain) / (((u + c2) * u + c1) * u + c0))
    }
}

#[cfg(test)]
mod tests {
    use super::super::parameters::tests::example;
    use super::super::{ServoLoop, Setpoint};
    use super::*;

    #[test]
    fn simulation_and_closed_form_agree_in_modulus_and_phase() {
        let mut parameters = example();
        parameters.drive.torque_limit = 1e6;
        for frequency in [10.0, 40.0, 100.0, 500.0] {
            let mut servo = ServoLoop::new(parameters).unwrap();
            // The last of 2 s, whole periods; the start has died out by then.
            let (mut sine, mut cosine) = (0.0, 0.0);
            for k in 0..16_000 {
                let phase = TAU * frequency * f64::from(k) * parameters.sample_time;
                let error = servo.step(&Setpoint::default(), phase.sin()).unwrap().error;
                if k >= 8000 {
                    sine += error * phase.sin() / 4000.0;
                    cosine += error * phase.cos() / 4000.0;
                }
            }
            let closed = parameters.disturbance_response(frequency).unwrap();
            let apart = (Complex::new(sine, cosine) - closed).norm() / closed.norm();
            assert!(apart < 1e-11, "{frequency} Hz: {apart}");
        }
    }

    #[test]
    fn a_constant_torque_leaves_nothing_and_bad_frequencies_are_refused() {
        let parameters = example();
        assert_eq!(parameters.disturbance_response(0.0).unwrap().norm(), 0.0);
        for frequency in [-1.0, f64::NAN, 4001.0] {
            assert_eq!(parameters.disturbance_response(frequency).unwrap_err().code(), "bad-parameter");
        }
    }
}
