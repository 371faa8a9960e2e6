//! A workpiece that follows its worm and the pulses of the feed slide: encoders and scale are counted, the gearbox sums the counts, the
//! servo follows its setpoint over any motion of the slide. What remains is the error of the angle over time
//! (`docs/mathematics/gearbox.md`).

use super::correction::{AxisState, Correction, added};
use super::drive::{ClosedGearbox, PulseDrive, worm_ratio};
use super::interpolation::{Extremes, Interpolation};
use super::rotation::Rotation;
use super::servo::{Disturbances, Moment, ServoLoop, ServoParameters};
use super::slide::SlideMotion;
use super::stroke::StrokeError;
use electronic_gearbox::coupling::{Gearbox, LinearTerm, Ratio};
use std::f64::consts::TAU;

/// The worm that leads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FollowedWorm {
    /// Threads z_1.
    pub threads: u32,
    /// Teeth of the workpiece z_2, negative for an internal gear.
    pub teeth: i32,
    /// Pulses per revolution of its encoder.
    pub pulses: u32,
    /// Speed, rad/s.
    pub speed: f64,
}

impl FollowedWorm {
    /// Turns of the workpiece for each of the worm.
    pub fn workpiece_turns(&self) -> f64 {
        -f64::from(self.threads) / f64::from(self.teeth)
    }
}

/// Encoders, scale and servo of a machine.
#[derive(Clone, Debug, PartialEq)]
pub struct Following {
    /// Scale of the feed slide.
    pub feed: Interpolation,
    /// How its pulses turn the workpiece.
    pub rotation: Rotation,
    /// The worm; without one the slide alone turns the workpiece.
    pub worm: Option<FollowedWorm>,
    /// Pulses per revolution of the workpiece's encoder; the setpoint resolves 1/P of one.
    pub workpiece_pulses: u32,
    /// Loop and motor.
    pub servo: ServoParameters,
    /// Torques on the workpiece.
    pub disturbances: Disturbances,
    /// Rotation that is added over feed and worm.
    pub corrections: Vec<Correction>,
}

/// What the slide does.
#[derive(Clone, Copy, Debug)]
pub struct FollowedSlide<'a> {
    /// Its reference pulses (tick, sign).
    pub references: &'a [(u64, i64)],
    /// Its motion; without one the pulses themselves are taken as the truth, and its speed is not fed forward.
    pub motion: Option<&'a SlideMotion>,
    /// How long, s.
    pub duration: f64,
}

/// Mean and spread of an error, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FollowingError {
    /// Mean over the run. Centring the tooth space in the machine removes it there; it is not in the other figures.
    pub mean: f64,
    /// Root of the mean square about the mean.
    pub rms: f64,
    /// Least and greatest difference from the mean.
    pub extremes: Extremes,
}

/// Errors over a stretch of time, for charts, means removed. rad, Nm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FollowingBin {
    /// Middle of the stretch, s.
    pub time: f64,
    /// Setpoint less ideal angle.
    pub setpoint: Extremes,
    /// Actual less ideal angle.
    pub actual: Extremes,
    /// Torque of the motor.
    pub torque: Extremes,
}

/// What a simulation brought.
#[derive(Clone, Debug, PartialEq)]
pub struct FollowingRecord {
    /// Time for which the loop ran before the slide began to move, the worm turning, s. It is in none of the figures.
    pub lead_in: f64,
    /// Samples in the figures.
    pub samples: u64,
    /// Setpoint of the gearbox less ideal angle.
    pub setpoint: FollowingError,
    /// Actual less ideal angle.
    pub actual: FollowingError,
    /// Greatest torque of the motor, Nm.
    pub greatest_torque: f64,
    /// Share of samples in which the torque was at its limit.
    pub limited: f64,
    /// Errors over time.
    pub bins: Vec<FollowingBin>,
}

/// Most samples of the time before the motion.
const MOST_LEAD_IN_SAMPLES: f64 = 1e7;
/// Stretches into which a run is divided for charts.
const BINS: usize = 1500;

impl Following {
    /// Simulates the loop over the whole stimulus, sample by sample.
    ///
    /// # Errors
    /// [`StrokeError`]: numbers of control, servo or disturbances, the gearbox, the reference pulses.
    pub fn run(&self, slide: &FollowedSlide<'_>) -> Result<FollowingRecord, StrokeError> {
        let p = self.feed.settings.pulses_per_interval();
        let parts = self.rotation.parts_per_revolution;
        let gearbox = self.gearbox(p)?;
        let turn = TAU * self.rotation.turns_per_millimetre;
        let worm_speed = self.worm.map_or(0.0, |worm| worm.speed);
        let worm_turn = self.worm.map_or(0.0, |worm| worm.workpiece_turns());

        let mut servo = ServoLoop::new(self.servo)?;
        let step = self.servo.sample_time;
        let waits = (self.servo.settling_time() / step).min(MOST_LEAD_IN_SAMPLES).ceil() as u64;
        let samples = (slide.duration / step).ceil() as u64;

        let mut pulses = PulseDrive::new(&self.feed, &self.rotation, slide.references)?;
        let mut cursor = slide.motion.map(SlideMotion::cursor);
        let origin = cursor.as_mut().map_or(0.0, |cursor| cursor.at(0.0).position);
        let begin = worm_turn * worm_speed * -(waits as f64 * step);
        servo = servo.starting_at(begin, worm_turn * worm_speed)?;
        let mut closed = ClosedGearbox::new(parts, begin);
        let mut observer = Observer::new(slide.duration);
        let mut first_added = None;
        for k in 0..waits + samples {
            let time = (k as f64 - waits as f64) * step;
            if k >= waits {
                pulses.advance(time)?;
            }
            let turned = pulses.turned();
            let worm_angle = worm_speed * time;
            let worm_counts =
                self.worm.map_or(0, |worm| (worm_angle / TAU * f64::from(worm.pulses)).floor() as i64);
            let slide_state = cursor.as_mut().map(|cursor| cursor.at(time.max(0.0)));
            let (way, speed, acceleration) = match slide_state {
                Some(state) if k >= waits => {
                    (turn * (state.position - origin), turn * state.speed, turn * state.acceleration)
                }
                Some(_) => (0.0, 0.0, 0.0),
                None => (turned as f64 / parts * TAU, 0.0, 0.0),
            };
            // What is added, by the axes as they are and as scale and encoder show them.
            let read = origin + pulses.net() as f64 * self.feed.pitch / f64::from(p);
            let feed = slide_state.filter(|_| k >= waits).map_or(
                AxisState {
                    position: if slide.motion.is_some() { origin } else { read },
                    ..AxisState::default()
                },
                |state| AxisState {
                    position: state.position,
                    speed: state.speed,
                    acceleration: state.acceleration,
                },
            );
            let worm = AxisState {
                position: worm_angle.to_degrees(),
                speed: worm_speed.to_degrees(),
                acceleration: 0.0,
            };
            let truly = added(&self.corrections, feed, worm)?;
            let shown_worm =
                self.worm.map_or(0.0, |worm| 360.0 * worm_counts as f64 / f64::from(worm.pulses));
            let shown = added(
                &self.corrections,
                AxisState { position: read, ..feed },
                AxisState { position: shown_worm, ..worm },
            )?;
            let begins = *first_added.get_or_insert(truly.position);
            let added_counts = (shown.position / TAU * parts + 0.5).floor();
            let counts = (gearbox.position(&[worm_counts])?.counts + turned) as f64 + added_counts;
            let (speed, acceleration) = (speed + truly.speed, acceleration + truly.acceleration);
            let ideal = worm_turn * worm_angle + way + truly.position - begins;
            let angle = closed.angle(counts);
            let setpoint = closed.setpoint(angle, worm_turn * worm_speed + speed, acceleration);
            let moment = Moment { time, worm_angle, workpiece_angle: ideal };
            let actual = servo.angle();
            let sample = servo.step(&setpoint, self.disturbances.torque(&moment)?)?;
            if k >= waits {
                observer.add(time, angle - ideal, actual - ideal, sample.torque, sample.limited);
            }
        }
        Ok(observer.finish(waits as f64 * step))
    }

    /// The coupling to the worm, exact; without a worm a coupling that nothing drives.
    fn gearbox(&self, p: u32) -> Result<Gearbox<1>, StrokeError> {
        let ratio = match self.worm {
            Some(worm) => {
                let parts = i64::from(self.workpiece_pulses) * i64::from(p);
                worm_ratio(worm.threads.into(), worm.teeth.into(), parts, worm.pulses)?
            }
            None => Ratio::new(0, 1)?,
        };
        Ok(Gearbox::new(0, [LinearTerm::new(ratio, 0)]))
    }
}

/// Sums about the first value, so that a large mean costs no digits.
#[derive(Clone, Copy)]
struct Sums {
    first: Option<f64>,
    sum: f64,
    squares: f64,
    extremes: Extremes,
}

impl Sums {
    const NONE: Self = Self { first: None, sum: 0.0, squares: 0.0, extremes: Extremes::NONE };

    fn add(&mut self, error: f64) {
        let difference = error - *self.first.get_or_insert(error);
        self.sum += difference;
        self.squares += difference * difference;
        self.extremes.add(error);
    }

    fn finish(&self, samples: u64) -> FollowingError {
        let Some(first) = self.first else {
            return FollowingError { mean: 0.0, rms: 0.0, extremes: Extremes { least: 0.0, greatest: 0.0 } };
        };
        let count = samples as f64;
        let shift = self.sum / count;
        let mean = first + shift;
        let rms = (self.squares / count - shift * shift).max(0.0).sqrt();
        FollowingError { mean, rms, extremes: about(self.extremes, mean) }
    }
}

fn about(extremes: Extremes, mean: f64) -> Extremes {
    Extremes { least: extremes.least - mean, greatest: extremes.greatest - mean }
}

/// Gathers the figures of a run.
struct Observer {
    samples: u64,
    setpoint: Sums,
    actual: Sums,
    greatest_torque: f64,
    limited: u64,
    bins: Vec<[Extremes; 3]>,
    width: f64,
}

impl Observer {
    fn new(duration: f64) -> Self {
        Self {
            samples: 0,
            setpoint: Sums::NONE,
            actual: Sums::NONE,
            greatest_torque: 0.0,
            limited: 0,
            bins: vec![[Extremes::NONE; 3]; BINS],
            width: (duration / BINS as f64).max(f64::MIN_POSITIVE),
        }
    }

    fn add(&mut self, time: f64, setpoint: f64, actual: f64, torque: f64, limited: bool) {
        self.samples += 1;
        self.setpoint.add(setpoint);
        self.actual.add(actual);
        self.greatest_torque = self.greatest_torque.max(torque.abs());
        self.limited += u64::from(limited);
        let bin = &mut self.bins[((time / self.width) as usize).min(BINS - 1)];
        for (extremes, value) in bin.iter_mut().zip([setpoint, actual, torque]) {
            extremes.add(value);
        }
    }

    fn finish(self, lead_in: f64) -> FollowingRecord {
        let (setpoint, actual) = (self.setpoint.finish(self.samples), self.actual.finish(self.samples));
        let bins = self.bins.iter().enumerate().filter_map(|(k, [of_setpoint, of_actual, torque])| {
            Some(FollowingBin {
                time: (k as f64 + 0.5) * self.width,
                setpoint: about(of_setpoint.any()?, setpoint.mean),
                actual: about(of_actual.any()?, actual.mean),
                torque: torque.any()?,
            })
        });
        FollowingRecord {
            lead_in,
            samples: self.samples,
            setpoint,
            actual,
            greatest_torque: self.greatest_torque,
            limited: self.limited as f64 / self.samples.max(1) as f64,
            bins: bins.collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::servo::{Disturbance, Drive, Gains};
    use super::*;
    use electronic_gearbox::pulse::{Mode, Settings};

    fn following(disturbances: Vec<Disturbance>) -> Following {
        let drive = Drive {
            inertia: 0.12,
            viscous_friction: 0.05,
            coulomb_friction: 0.5,
            friction_speed: 0.05,
            torque_limit: 60.0,
        };
        let gains = Gains::triple_pole(40.0, &drive).unwrap();
        let settings = Settings::new(16, Settings::COUNTER_LIMIT, Mode::NoBacklash).unwrap();
        Following {
            feed: Interpolation { settings, clock: 1e6, pitch: 0.01 },
            rotation: Rotation::exact(1.0 / 900.0, 16e7, 0.01 / 16.0).unwrap(),
            worm: Some(FollowedWorm { threads: 3, teeth: 40, pulses: 10_000_000, speed: 50.0 }),
            // So fine that counting stays below the errors looked at.
            workpiece_pulses: 10_000_000,
            servo: ServoParameters {
                sample_time: 125e-6,
                drive,
                gains,
                feed_forward: 1.0,
                quantisation: None,
            },
            disturbances: Disturbances::new(disturbances).unwrap(),
            corrections: Vec::new(),
        }
    }

    /// A rotation that is added goes into setpoint and ideal angle: with a fine encoder and a stiff loop the workpiece follows it, and the
    /// error is far below what was added.
    #[test]
    fn an_added_rotation_is_followed() {
        use super::super::correction::{CorrectionCurve, LeadingAxis};
        use super::super::slide::Move;
        use electronic_gearbox::coupling::PolynomialCoupling;
        let mut control = following(Vec::new());
        // 1e-4 rad at 3 mm, as a parabola.
        let curve = PolynomialCoupling::new(&[0.0, 0.0, 1e-4 / 9.0]).unwrap();
        control.corrections =
            vec![Correction { axis: LeadingAxis::Feed, curve: CorrectionCurve::Polynomial(curve) }];
        let motion =
            SlideMotion::of_moves(0.0, &[Move::To { position: 3.0, speed: 10.0, acceleration: 100.0 }])
                .unwrap();
        let references = control.feed.references(&motion).unwrap();
        let slide = FollowedSlide { references: &references, motion: Some(&motion), duration: 0.5 };
        let (with, without) = (control.run(&slide).unwrap(), {
            control.corrections.clear();
            control.run(&slide).unwrap()
        });
        // The scale shows the slide to 10 um, at 3 mm a slope of 0.67e-4 rad a mm: 0.7e-6 rad.
        let more = with.setpoint.extremes.range() - without.setpoint.extremes.range();
        assert!(more < 1.5e-6, "{more}");
        assert!(
            with.actual.extremes.range() < without.actual.extremes.range() + 3e-6,
            "{with:?} {without:?}"
        );
    }

    #[test]
    fn a_harmonic_torque_leaves_what_the_closed_form_says() {
        let control =
            following(vec![Disturbance::HarmonicInTime { amplitude: 2.0, frequency: 50.0, phase: 0.3 }]);
        let rest = FollowedSlide { references: &[], motion: None, duration: 0.4 };
        let record = control.run(&rest).unwrap();
        let amplitude = 2.0 * control.servo.disturbance_response(50.0).unwrap().norm();
        assert!((record.actual.extremes.greatest / amplitude - 1.0).abs() < 1e-2, "{record:?}");
        assert!((record.actual.rms / amplitude * 2f64.sqrt() - 1.0).abs() < 1e-2);
        assert_eq!((record.samples, record.limited), (3200, 0.0));
    }

    #[test]
    fn a_moving_slide_leaves_little_beside_its_pulses() {
        use super::super::slide::Move;
        let control = following(Vec::new());
        let motion =
            SlideMotion::of_moves(0.0, &[Move::To { position: 2.0, speed: 10.0, acceleration: 100.0 }])
                .unwrap();
        let references = control.feed.references(&motion).unwrap();
        let duration = motion.duration() + 0.1;
        let slide = FollowedSlide { references: &references, motion: Some(&motion), duration };
        let record = control.run(&slide).unwrap();
        // The feed turns the workpiece by 14 mrad. Nothing is inserted before the second line: two pitches of 70 urad each.
        assert!(record.setpoint.extremes.range() < 2.1 * TAU / 900.0 * 0.01, "{record:?}");
        // The loop follows errors slower than its bandwidth: what the setpoint is off, the workpiece is off, with some overshoot.
        let share = record.actual.rms / record.setpoint.rms;
        assert!((0.8..1.2).contains(&share), "{share}");
        let bins = &record.bins;
        assert!(bins.windows(2).all(|pair| pair[0].time < pair[1].time));
        let greatest = bins.iter().map(|bin| bin.actual.greatest).fold(f64::MIN, f64::max);
        assert_eq!(greatest, record.actual.extremes.greatest);
    }
}
