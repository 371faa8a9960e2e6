//! Torques that disturb the workpiece spindle, as data: in time, or in the angle of worm or workpiece (cutting torque at
//! the frequency of the teeth, cogging of the motor, the blow of an uneven thread).

use super::super::error::{ControlError, within};
use std::f64::consts::TAU;

/// The rotary axis whose angle a torque follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spindle {
    /// The worm.
    Worm,
    /// The workpiece.
    Workpiece,
}

/// A disturbing torque. Torques in Nm, angles and phases in rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Disturbance {
    /// Always the same.
    Constant {
        /// Its torque.
        torque: f64,
    },
    /// From a moment on.
    Step {
        /// Torque afterwards; before, it is 0.
        torque: f64,
        /// The moment, s; it still belongs to the time before.
        after: f64,
    },
    /// amplitude sin(2 pi frequency t + phase).
    HarmonicInTime {
        /// Amplitude.
        amplitude: f64,
        /// Hz.
        frequency: f64,
        /// Phase at time 0.
        phase: f64,
    },
    /// amplitude sin(order angle + phase).
    HarmonicInAngle {
        /// Whose angle.
        spindle: Spindle,
        /// Amplitude.
        amplitude: f64,
        /// Periods per revolution.
        order: f64,
        /// Phase at angle 0.
        phase: f64,
    },
    /// Equal pulses at equal angles.
    PulseTrain {
        /// Whose angle.
        spindle: Spindle,
        /// Torque during a pulse; between pulses it is 0.
        torque: f64,
        /// Pulses per revolution.
        pulses: u32,
        /// Angle at which one of them begins.
        first: f64,
        /// Angle over which a pulse lasts; at most the distance of two.
        width: f64,
    },
}

/// Time and the angles of both spindles.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moment {
    /// s.
    pub time: f64,
    /// rad.
    pub worm_angle: f64,
    /// rad.
    pub workpiece_angle: f64,
}

/// Several disturbances at once.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Disturbances {
    sources: Vec<Disturbance>,
}

/// Greatest amount of a torque, as of the loop itself, divided by the greatest number of sources.
const GREATEST_TORQUE: std::ops::RangeInclusive<f64> = -1e9..=1e9;
const MOST_SOURCES: usize = 1000;

impl Disturbances {
    /// Takes the sources, up to 1000.
    ///
    /// # Errors
    /// [`ControlError::BadParameter`] with the name of the field.
    pub fn new(sources: Vec<Disturbance>) -> Result<Self, ControlError> {
        within("disturbances", sources.len() as f64, 0.0..=MOST_SOURCES as f64, "at most 1000")?;
        sources.iter().try_for_each(Disturbance::validate)?;
        Ok(Self { sources })
    }

    /// The sources.
    pub fn sources(&self) -> &[Disturbance] {
        &self.sources
    }

    /// Sum of all torques at a moment, Nm.
    ///
    /// # Errors
    /// [`ControlError::BadParameter`] for a moment that is not made of numbers.
    pub fn torque(&self, moment: &Moment) -> Result<f64, ControlError> {
        for (name, value) in [
            ("time", moment.time),
            ("worm_angle", moment.worm_angle),
            ("workpiece_angle", moment.workpiece_angle),
        ] {
            within(name, value, -1e12..=1e12, "a finite number (-1e12 to 1e12)")?;
        }
        Ok(self.sources.iter().map(|source| source.torque(moment)).sum())
    }
}

impl Disturbance {
    fn validate(&self) -> Result<(), ControlError> {
        let torque = |name, value| within(name, value, GREATEST_TORQUE, "a finite number (-1e9 to 1e9 Nm)");
        let angle = |name, value| within(name, value, -1e9..=1e9, "a finite number (-1e9 to 1e9 rad)");
        let positive = |name, value| within(name, value, 1e-9..=1e9, "above 0 (1e-9 to 1e9)");
        match *self {
            Self::Constant { torque: value } => torque("torque", value)?,
            Self::Step { torque: value, after } => {
                torque("torque", value)?;
                within("after", after, -1e12..=1e12, "a finite time")?
            }
            Self::HarmonicInTime { amplitude, frequency, phase } => {
                torque("amplitude", amplitude)?;
                positive("frequency", frequency)?;
                angle("phase", phase)?
            }
            Self::HarmonicInAngle { amplitude, order, phase, .. } => {
                torque("amplitude", amplitude)?;
                positive("order", order)?;
                angle("phase", phase)?
            }
            Self::PulseTrain { torque: value, pulses, first, width, .. } => {
                torque("torque", value)?;
                within("pulses", f64::from(pulses), 1.0..=1e9, "1 to 1e9 per revolution")?;
                angle("first", first)?;
                let distance = TAU / f64::from(pulses);
                within(
                    "width",
                    width,
                    f64::MIN_POSITIVE..=distance,
                    "above 0, at most the distance of two pulses",
                )?
            }
        };
        Ok(())
    }

    /// Torque at a moment of finite numbers, Nm.
    fn torque(&self, moment: &Moment) -> f64 {
        let angle = |spindle| match spindle {
            Spindle::Worm => moment.worm_angle,
            Spindle::Workpiece => moment.workpiece_angle,
        };
        match *self {
            Self::Constant { torque } => torque,
            Self::Step { torque, after } => {
                if moment.time > after {
                    torque
                } else {
                    0.0
                }
            }
            Self::HarmonicInTime { amplitude, frequency, phase } => {
                amplitude * (TAU * frequency * moment.time + phase).sin()
            }
            Self::HarmonicInAngle { spindle, amplitude, order, phase } => {
                amplitude * (order * angle(spindle) + phase).sin()
            }
            Self::PulseTrain { spindle, torque, pulses, first, width } => {
                let distance = TAU / f64::from(pulses);
                if (angle(spindle) - first).rem_euclid(distance) < width { torque } else { 0.0 }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    fn at(time: f64, worm_angle: f64, workpiece_angle: f64) -> Moment {
        Moment { time, worm_angle, workpiece_angle }
    }

    fn one(source: Disturbance, moment: Moment) -> f64 {
        Disturbances::new(vec![source]).unwrap().torque(&moment).unwrap()
    }

    #[test]
    fn every_source_gives_its_torque_at_its_place() {
        let step = Disturbance::Step { torque: -3.0, after: 1.0 };
        assert_eq!([1.0, 1.001].map(|t| one(step, at(t, 0.0, 0.0))), [0.0, -3.0]);
        let in_time = Disturbance::HarmonicInTime { amplitude: 2.0, frequency: 5.0, phase: FRAC_PI_2 };
        assert!((one(in_time, at(0.1, 9.0, 9.0)) + 2.0).abs() < 1e-14);
        // Three starts against 40 teeth: once a tooth on the workpiece is once a start on the worm.
        let worm =
            Disturbance::HarmonicInAngle { spindle: Spindle::Worm, amplitude: 1.0, order: 3.0, phase: 0.2 };
        let work = Disturbance::HarmonicInAngle {
            spindle: Spindle::Workpiece,
            amplitude: 1.0,
            order: 40.0,
            phase: 0.2,
        };
        let coupled = at(0.0, 1.3, 1.3 * 3.0 / 40.0);
        assert!((one(worm, coupled) - one(work, coupled)).abs() < 1e-14);
        assert!((one(worm, coupled) - 4.1f64.sin()).abs() < 1e-14);
        let train = |first| Disturbance::PulseTrain {
            spindle: Spindle::Workpiece,
            torque: 4.0,
            pulses: 2,
            first,
            width: 0.5,
        };
        let angles = [0.0, 0.49, 0.51, PI + 0.1, -PI + 0.1, -0.1];
        assert_eq!(angles.map(|a| one(train(0.0), at(0.0, 0.2, a))), [4.0, 4.0, 0.0, 4.0, 4.0, 0.0]);
        assert_eq!(one(train(-0.2), at(0.0, 0.2, -0.1)), 4.0);
        let sum = Disturbances::new(vec![Disturbance::Constant { torque: 0.5 }, step]).unwrap();
        assert_eq!(sum.torque(&at(2.0, 0.0, 0.0)), Ok(-2.5));
        assert_eq!(Disturbances::default().torque(&at(2.0, 0.0, 0.0)), Ok(0.0));
    }

    #[test]
    fn bad_input_names_the_field() {
        let train = Disturbance::PulseTrain {
            spindle: Spindle::Worm,
            torque: 1.0,
            pulses: 4,
            first: 0.0,
            width: 1.6,
        };
        let cases = [
            ("torque", Disturbance::Constant { torque: f64::NAN }),
            ("after", Disturbance::Step { torque: 1.0, after: f64::INFINITY }),
            ("frequency", Disturbance::HarmonicInTime { amplitude: 1.0, frequency: 0.0, phase: 0.0 }),
            ("width", train),
        ];
        for (field, source) in cases {
            match Disturbances::new(vec![source]) {
                Err(ControlError::BadParameter { name, .. }) => assert_eq!(name, field),
                other => panic!("{field}: {other:?}"),
            }
        }
        let many = vec![Disturbance::Constant { torque: 1.0 }; 1001];
        assert!(Disturbances::new(many).is_err());
        assert!(Disturbances::default().torque(&at(f64::NAN, 0.0, 0.0)).is_err());
    }
}
