//! The numbers of a loop: motor and load, gains, quantisation; their ranges, and gains for a wanted bandwidth.

use super::super::error::{ControlError, within};
use std::f64::consts::TAU;

/// Motor and load, both at the workpiece spindle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drive {
    /// Moment of inertia J of all that turns, seen at the workpiece, kg m^2.
    pub inertia: f64,
    /// Viscous friction B, Nm s/rad.
    pub viscous_friction: f64,
    /// Coulomb friction Tc, Nm; it acts as Tc tanh(w/ws).
    pub coulomb_friction: f64,
    /// Speed ws at which Coulomb friction changes over, rad/s.
    pub friction_speed: f64,
    /// Greatest torque of the motor Tmax, Nm.
    pub torque_limit: f64,
}

/// Gains of the loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gains {
    /// Kp, Nm/rad.
    pub proportional: f64,
    /// Ki, Nm/(rad s).
    pub integral: f64,
    /// Kd, Nm s/rad; it acts on the difference of the speeds.
    pub derivative: f64,
}

/// Setpoint and actual position as counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quantisation {
    /// Encoder counts per revolution of the workpiece, N_w.
    pub counts_per_revolution: u32,
    /// P: the setpoint resolves 1/P of a count.
    pub multiplier: u32,
}

/// A loop and what it drives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ServoParameters {
    /// Sample time Ts, s.
    pub sample_time: f64,
    /// Motor and load.
    pub drive: Drive,
    /// Gains.
    pub gains: Gains,
    /// Share of the feedforward of acceleration and friction: 0 none, 1 whole.
    pub feed_forward: f64,
    /// Whole counts; `None` for a loop of real numbers.
    pub quantisation: Option<Quantisation>,
}

/// Range of a quantity that must be positive. Its ends keep every product of the loop far from overflow.
const POSITIVE: std::ops::RangeInclusive<f64> = 1e-12..=1e12;
const POSITIVE_WORDS: &str = "above 0 (1e-12 to 1e12)";
const NOT_NEGATIVE: std::ops::RangeInclusive<f64> = 0.0..=1e12;
const NOT_NEGATIVE_WORDS: &str = "0 to 1e12";
/// Time to settle in periods 1/w_0 of the loop: the transient of a triple pole has gone to 1e-8 after 25.
const SETTLING: f64 = 30.0;

impl Drive {
    fn validate(&self) -> Result<(), ControlError> {
        within("inertia", self.inertia, POSITIVE, POSITIVE_WORDS)?;
        within("viscous_friction", self.viscous_friction, NOT_NEGATIVE, NOT_NEGATIVE_WORDS)?;
        within("coulomb_friction", self.coulomb_friction, NOT_NEGATIVE, NOT_NEGATIVE_WORDS)?;
        within("friction_speed", self.friction_speed, POSITIVE, POSITIVE_WORDS)?;
        within("torque_limit", self.torque_limit, POSITIVE, POSITIVE_WORDS)?;
        Ok(())
    }
}

impl Gains {
    /// Gains that put the three poles of the loop in continuous time on one place: Kp = 3 J w0^2, Ki = J w0^3,
    /// Kd = 3 J w0 - B with w0 = 2 pi `bandwidth`. `bandwidth` in Hz.
    ///
    /// # Errors
    /// [`ControlError::BadParameter`].
    pub fn triple_pole(bandwidth: f64, drive: &Drive) -> Result<Self, ControlError> {
        drive.validate()?;
        let w0 = TAU * within("bandwidth", bandwidth, 1e-9..=1e9, "above 0 (1e-9 to 1e9 Hz)")?;
        let inertia = drive.inertia;
        Ok(Self {
            proportional: 3.0 * inertia * w0 * w0,
            integral: inertia * w0 * w0 * w0,
            derivative: 3.0 * inertia * w0 - drive.viscous_friction,
        })
    }

    fn validate(&self) -> Result<(), ControlError> {
        const GAIN: std::ops::RangeInclusive<f64> = -1e60..=1e60;
        for (name, value) in [
            ("proportional", self.proportional),
            ("integral", self.integral),
            ("derivative", self.derivative),
        ] {
            within(name, value, GAIN, "a finite number (-1e60 to 1e60)")?;
        }
        Ok(())
    }
}

impl ServoParameters {
    /// Whether every number is in its range and the loop is stable.
    ///
    /// # Errors
    /// [`ControlError::BadParameter`] with the name of the field, [`ControlError::UnstableLoop`].
    pub fn validate(&self) -> Result<(), ControlError> {
        self.validate_numbers()?;
        let largest_pole = self.largest_pole()?;
        if largest_pole < 1.0 { Ok(()) } else { Err(ControlError::UnstableLoop { largest_pole }) }
    }

    /// Time after which no transient is left, s; bounded for a loop that is too soft to settle.
    pub(crate) fn settling_time(&self) -> f64 {
        let bandwidth = (self.gains.integral / self.drive.inertia).cbrt();
        SETTLING / bandwidth.max(1e-3)
    }

    /// The numbers alone, without stability.
    pub(super) fn validate_numbers(&self) -> Result<(), ControlError> {
        within("sample_time", self.sample_time, POSITIVE, POSITIVE_WORDS)?;
        self.drive.validate()?;
        self.gains.validate()?;
        within("feed_forward", self.feed_forward, 0.0..=2.0, "0 to 2")?;
        if let Some(quantisation) = self.quantisation {
            let counts = f64::from(quantisation.counts_per_revolution);
            within("counts_per_revolution", counts, 1.0..=f64::MAX, "at least 1")?;
            let multiplier = f64::from(quantisation.multiplier);
            within("multiplier", multiplier, 2.0..=256.0, "2 to 256 pulses per interval")?;
        }
        // In the limit of the torque the loop is open: there the samples of the drive alone must not diverge.
        let decay = self.drive.viscous_friction * self.sample_time / self.drive.inertia;
        within(
            "viscous_friction*sample_time/inertia",
            decay,
            0.0..=1.0,
            "0 to 1: choose a shorter sample time",
        )?;
        Ok(())
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// The loop of the reference numbers: 40 Hz, 8 kHz sampling.
    pub fn example() -> ServoParameters {
        let drive = Drive {
            inertia: 0.12,
            viscous_friction: 0.05,
            coulomb_friction: 0.0,
            friction_speed: 0.05,
            torque_limit: 60.0,
        };
        let gains = Gains::triple_pole(40.0, &drive).unwrap();
        ServoParameters { sample_time: 125e-6, drive, gains, feed_forward: 1.0, quantisation: None }
    }

    #[test]
    fn bad_input_names_the_field() {
        let counts =
            |counts_per_revolution, multiplier| Some(Quantisation { counts_per_revolution, multiplier });
        type Change = fn(&mut ServoParameters);
        let cases: [(&str, Change); 11] = [
            ("sample_time", |p| p.sample_time = 0.0),
            ("inertia", |p| p.drive.inertia = -1.0),
            ("viscous_friction", |p| p.drive.viscous_friction = f64::NAN),
            ("coulomb_friction", |p| p.drive.coulomb_friction = -0.1),
            ("friction_speed", |p| p.drive.friction_speed = 0.0),
            ("torque_limit", |p| p.drive.torque_limit = f64::INFINITY),
            ("proportional", |p| p.gains.proportional = f64::NAN),
            ("integral", |p| p.gains.integral = f64::INFINITY),
            ("derivative", |p| p.gains.derivative = f64::NEG_INFINITY),
            ("feed_forward", |p| p.feed_forward = -0.5),
            ("viscous_friction*sample_time/inertia", |p| p.drive.viscous_friction = 1e4),
        ];
        let refused = |parameters: ServoParameters| match parameters.validate() {
            Err(ControlError::BadParameter { name, .. }) => name,
            other => panic!("{other:?}"),
        };
        for (field, change) in cases {
            let mut parameters = example();
            change(&mut parameters);
            assert_eq!(refused(parameters), field);
        }
        let quantised = |quantisation| ServoParameters { quantisation, ..example() };
        assert_eq!(refused(quantised(counts(0, 16))), "counts_per_revolution");
        assert_eq!(refused(quantised(counts(36_000, 1))), "multiplier");
        assert_eq!(quantised(counts(36_000, 16)).validate(), Ok(()));
        assert!(Gains::triple_pole(0.0, &example().drive).is_err());
    }
}
