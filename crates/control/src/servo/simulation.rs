//! The loop and the motor sample by sample, in the order of operations of `docs/mathematics/gearbox.md#position-loop`.

use super::super::error::{ControlError, within};
use super::parameters::{Quantisation, ServoParameters};
use std::f64::consts::TAU;

/// Where the workpiece should be, how fast and how fast that changes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Setpoint {
    /// Angle, rad.
    pub position: f64,
    /// rad/s.
    pub speed: f64,
    /// rad/s^2.
    pub acceleration: f64,
}

/// What one sample brought.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SampleRecord {
    /// Setpoint minus true angle at the beginning of the sample, rad, without quantisation.
    pub error: f64,
    /// Torque of the motor within its limit, Nm.
    pub torque: f64,
    /// Whether the limit of the torque was reached; the integral part stands still then.
    pub limited: bool,
}

/// A running loop.
#[derive(Clone, Debug)]
pub struct ServoLoop {
    parameters: ServoParameters,
    /// Ts/J.
    rate: f64,
    /// Ki Ts.
    integral_gain: f64,
    counts: Option<Counts>,
    angle: f64,
    speed: f64,
    integral: f64,
}

/// Quantisation with numbers ready for use.
#[derive(Clone, Copy, Debug)]
struct Counts {
    per_revolution: f64,
    multiplier: f64,
    /// 2 pi/N_w and its reciprocal: every sample waits for the actual angle, and a division takes longest.
    angle_of_one: f64,
    per_radian: f64,
}

impl Counts {
    fn new(given: Quantisation) -> Self {
        let per_revolution = f64::from(given.counts_per_revolution);
        Self {
            per_revolution,
            multiplier: f64::from(given.multiplier),
            angle_of_one: TAU / per_revolution,
            per_radian: per_revolution / TAU,
        }
    }

    /// The setpoint in fractions of a count.
    #[inline]
    fn setpoint(&self, angle: f64) -> f64 {
        floor(angle * self.per_revolution / TAU * self.multiplier) / self.multiplier * TAU
            / self.per_revolution
    }

    /// The actual angle in whole counts.
    #[inline]
    fn actual(&self, angle: f64) -> f64 {
        floor(angle * self.per_radian) * self.angle_of_one
    }
}

/// `f64::floor` without a call: baseline x86-64 has no instruction for it.
#[inline]
fn floor(x: f64) -> f64 {
    // From 2^52 on every number is whole.
    if x.abs() < 4_503_599_627_370_496.0 {
        let towards_zero = (x as i64) as f64;
        if towards_zero > x { towards_zero - 1.0 } else { towards_zero }
    } else {
        x
    }
}

/// `f64::tanh`; from 20 on it is 1 in every digit (1 - tanh 20 = 8.5e-18), and no call is needed.
#[inline]
fn tanh(x: f64) -> f64 {
    if x.abs() < 20.0 { x.tanh() } else { 1f64.copysign(x) }
}

/// Greatest amount of a setpoint or torque: far beyond any machine, far from overflow.
const GREATEST: f64 = 1e12;

impl ServoLoop {
    /// A loop at rest at angle 0.
    ///
    /// # Errors
    /// [`ControlError::BadParameter`], [`ControlError::UnstableLoop`].
    pub fn new(parameters: ServoParameters) -> Result<Self, ControlError> {
        parameters.validate()?;
        Ok(Self {
            parameters,
            rate: parameters.sample_time / parameters.drive.inertia,
            integral_gain: parameters.gains.integral * parameters.sample_time,
            counts: parameters.quantisation.map(Counts::new),
            angle: 0.0,
            speed: 0.0,
            integral: 0.0,
        })
    }

    /// The same loop with the workpiece at another angle (rad) and speed (rad/s), its integral part empty.
    ///
    /// # Errors
    /// [`ControlError::BadParameter`].
    pub fn starting_at(mut self, angle: f64, speed: f64) -> Result<Self, ControlError> {
        self.angle = usable("angle", angle)?;
        self.speed = usable("speed", speed)?;
        self.integral = 0.0;
        Ok(self)
    }

    /// True angle of the workpiece, rad.
    pub fn angle(&self) -> f64 {
        self.angle
    }

    /// Speed of the workpiece, rad/s.
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// The numbers of the loop.
    pub fn parameters(&self) -> &ServoParameters {
        &self.parameters
    }

    /// One sample: the control reads setpoint and angle, then motor and `disturbance_torque` (Nm) act for one sample
    /// time.
    ///
    /// # Errors
    /// [`ControlError::BadParameter`] for a setpoint or torque that is not a number or beyond 1e12; the state is kept.
    #[inline]
    pub fn step(
        &mut self,
        reference: &Setpoint,
        disturbance_torque: f64,
    ) -> Result<SampleRecord, ControlError> {
        let largest = |a: f64, b: f64| a.abs() <= GREATEST && b.abs() <= GREATEST;
        if !(largest(reference.position, reference.speed)
            && largest(reference.acceleration, disturbance_torque))
        {
            return Err(refused(reference, disturbance_torque));
        }
        let ServoParameters { sample_time, drive, gains, feed_forward, .. } = &self.parameters;
        let friction = |speed: f64| {
            if drive.coulomb_friction == 0.0 {
                0.0
            } else {
                drive.coulomb_friction * tanh(speed / drive.friction_speed)
            }
        };
        let seen = match &self.counts {
            Some(counts) => counts.setpoint(reference.position) - counts.actual(self.angle),
            None => reference.position - self.angle,
        };
        let forward = feed_forward
            * (drive.inertia * reference.acceleration
                + drive.viscous_friction * reference.speed
                + friction(reference.speed));
        let growth = self.integral_gain * seen;
        let wanted = gains.proportional * seen
            + gains.derivative * (reference.speed - self.speed)
            + self.integral
            + growth
            + forward;
        let torque = wanted.clamp(-drive.torque_limit, drive.torque_limit);
        let limited = torque != wanted;
        if !limited {
            self.integral += growth;
        }
        let error = reference.position - self.angle;
        self.speed += self.rate
            * (torque - drive.viscous_friction * self.speed - friction(self.speed) + disturbance_torque);
        self.angle += sample_time * self.speed;
        Ok(SampleRecord { error, torque, limited })
    }
}

fn usable(name: &'static str, value: f64) -> Result<f64, ControlError> {
    within(name, value, -GREATEST..=GREATEST, "a finite number (-1e12 to 1e12)")
}

/// Which of the numbers of a step is not usable.
#[cold]
fn refused(reference: &Setpoint, torque: f64) -> ControlError {
    let numbers = [
        ("position", reference.position),
        ("speed", reference.speed),
        ("acceleration", reference.acceleration),
    ];
    let first = numbers.into_iter().find_map(|(name, value)| usable(name, value).err());
    first.unwrap_or(ControlError::BadParameter {
        name: "disturbance_torque",
        value: torque,
        allowed: "a finite number (-1e12 to 1e12)",
    })
}

#[cfg(test)]
mod tests {
    use super::super::FlankRecord;
    use super::super::parameters::tests::example;
    use super::*;

    #[test]
    fn floor_and_tanh_are_those_of_the_library() {
        let numbers = [
            0.0,
            0.5,
            1.0,
            -0.5,
            -1.0,
            -1.5,
            123_456.789,
            -4.5e15,
            4.5e15,
            5e15,
            -1e300,
            2f64.powi(52) - 0.5,
        ];
        for x in numbers {
            assert_eq!(floor(x), x.floor(), "{x}");
            assert_eq!(tanh(x), x.tanh(), "{x}");
        }
        for x in [19.0, 19.99, 20.0, 20.01, -20.0, -19.99] {
            assert_eq!(tanh(x), f64::tanh(x), "{x}");
        }
    }

    /// The four runs of the reference numbers: 0.8 Nm at 50 Hz and a step of -3 Nm after 1 s on a workpiece at 225 1/min.
    fn run(parameters: ServoParameters) -> (Vec<f64>, f64, f64) {
        let w0 = TAU * 3.75;
        let mut servo = ServoLoop::new(parameters).unwrap().starting_at(0.0, w0).unwrap();
        let mut records = [FlankRecord::new(46_984.631_039_295_42).unwrap(); 2];
        let mut errors = Vec::new();
        for k in 0..16_000 {
            let t = f64::from(k) * parameters.sample_time;
            let torque = 0.8 * (TAU * 50.0 * t).sin() - if t > 1.0 { 3.0 } else { 0.0 };
            let setpoint = Setpoint { position: w0 * t, speed: w0, acceleration: 0.0 };
            let error = servo.step(&setpoint, torque).unwrap().error;
            errors.push(error);
            if t > 0.5 && t < 1.0 {
                records[0].add(error);
            } else if t > 1.0 {
                records[1].add(error);
            }
        }
        (errors, records[0].rms_um().unwrap(), records[1].peak_um())
    }

    #[test]
    fn the_linear_run() {
        let (errors, rms, peak) = run(example());
        for (k, expected) in [(1, 0.0), (100, -1.721_815_762_634_193_4e-6), (8100, 7.410_557_166_309_673e-5)]
        {
            assert!((errors[k] - expected).abs() < 1e-14, "{k}: {} instead of {expected}", errors[k]);
        }
        assert!(
            (rms - 1.055_761_088_441_926).abs() < 1e-10 && (peak - 3.760_962_268_856_286_7).abs() < 1e-10
        );
    }

    #[test]
    fn friction_that_is_not_fed_forward_is_learnt() {
        let mut parameters = example();
        parameters.drive.coulomb_friction = 1.5;
        parameters.feed_forward = 0.0;
        let (errors, rms, _) = run(parameters);
        assert!((errors[1] - 3.487_105_787_883_596e-7).abs() < 1e-14, "{}", errors[1]);
        assert!((rms - 1.055_761_088_441_926).abs() < 1e-10, "{rms}");
    }

    #[test]
    fn a_limit_near_the_load_takes_longer() {
        let mut parameters = example();
        parameters.drive.torque_limit = 4.8;
        let (errors, _, peak) = run(parameters);
        assert!((errors[15_999] - 6.666_534_723_365_203e-5).abs() < 1e-13, "{}", errors[15_999]);
        assert!((peak - 4.969_025_474_133_98).abs() < 1e-9, "{peak}");
    }

    #[test]
    fn quantisation_is_a_small_noise() {
        let mut parameters = example();
        parameters.drive.coulomb_friction = 1.5;
        parameters.quantisation = Some(Quantisation { counts_per_revolution: 2_097_152, multiplier: 16 });
        let (errors, rms, peak) = run(parameters);
        // A fraction of a count more or less in the setpoint would be 1.9e-7 rad.
        assert!((errors[15_999] - 2.744_233_121_632_078e-5).abs() < 1e-8, "{}", errors[15_999]);
        assert!((rms / 1.057_741_404_139_443_3 - 1.0).abs() < 1e-4, "{rms}");
        assert!((peak / 3.670_393_005_323_480_6 - 1.0).abs() < 1e-3, "{peak}");
    }

    #[test]
    fn numbers_that_are_none_are_refused_and_change_nothing() {
        let mut servo = ServoLoop::new(example()).unwrap();
        servo.step(&Setpoint { position: 1e-4, ..Setpoint::default() }, 0.0).unwrap();
        let before = (servo.angle(), servo.speed(), servo.integral);
        let at = |position| Setpoint { position, ..Setpoint::default() };
        let named = |outcome| match outcome {
            Err(ControlError::BadParameter { name, .. }) => name,
            other => panic!("{other:?}"),
        };
        assert_eq!(named(servo.step(&at(f64::NAN), 0.0)), "position");
        assert_eq!(named(servo.step(&Setpoint { speed: f64::INFINITY, ..at(0.0) }, 0.0)), "speed");
        assert_eq!(named(servo.step(&Setpoint { acceleration: 1e13, ..at(0.0) }, 0.0)), "acceleration");
        assert_eq!(named(servo.step(&at(0.0), f64::NAN)), "disturbance_torque");
        assert_eq!((servo.angle(), servo.speed(), servo.integral), before);
        assert!(servo.starting_at(f64::NAN, 0.0).is_err());
    }

    #[test]
    fn the_greatest_numbers_stay_numbers() {
        let mut servo = ServoLoop::new(example()).unwrap();
        for k in 0..10_000 {
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
            let setpoint = Setpoint { position: sign * 1e12, speed: -sign * 1e12, acceleration: 1e12 };
            let record = servo.step(&setpoint, 1e12).unwrap();
            assert!(record.error.is_finite() && record.torque.abs() <= 60.0 && record.limited);
        }
        assert!(servo.angle().is_finite() && servo.speed().is_finite());
    }
}
