//! Multipliers of older controls on the same motion: a phase-locked loop, and the amplitudes of a scale's sine and cosine
//! (`docs/mathematics/gearbox.md#older-multipliers`). For comparison with the interpolator; no machine here uses them.

use super::error::{ControlError, within};
use super::interpolation::{Extremes, Interpolation};
use super::slide::SlideMotion;
use std::f64::consts::TAU;

/// A loop that holds an oscillator of P times the frequency in phase with the lines. Its detector counts lines up and down, so that it
/// never slips by a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhaseLockedLoop {
    /// Natural frequency, rad/s.
    frequency: f64,
    /// Damping.
    damping: f64,
}

/// Sine and cosine of a scale as they come, and how late.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AmplitudeInterpolation {
    /// Zero of both signals, of their amplitude.
    offset: f64,
    /// Difference of the amplitudes, of their mean.
    mismatch: f64,
    /// What the phase of the two is off a quarter by, rad.
    phase_error: f64,
    /// Time from signal to pulse, s.
    delay: f64,
}

/// Errors of a multiplier along the feed, mm.
#[derive(Clone, Debug, PartialEq)]
pub struct MultiplierRun {
    /// Over the whole motion.
    pub whole: Extremes,
    /// At constant speed, from the third line of it on; `None` if there is none.
    pub steady: Option<Extremes>,
    /// Over time: middle of a stretch in s, least and greatest in it.
    pub bins: Vec<(f64, Extremes)>,
}

/// Stretches into which a run is divided for charts.
const BINS: usize = 600;
/// Most instants at which a run is looked at.
const MOST_INSTANTS: f64 = 4e6;

/// Gathers errors beside the slide.
struct Beside<'a> {
    cursor: super::slide::SlideCursor<'a>,
    pitch: f64,
    /// Since when the speed is constant.
    constant: Option<f64>,
    whole: Extremes,
    steady: Extremes,
    bins: Vec<Extremes>,
    width: f64,
}

impl<'a> Beside<'a> {
    fn new(motion: &'a SlideMotion, pitch: f64, end: f64) -> Self {
        Self {
            cursor: motion.cursor(),
            pitch,
            constant: None,
            whole: Extremes::NONE,
            steady: Extremes::NONE,
            bins: vec![Extremes::NONE; BINS],
            width: (end / BINS as f64).max(f64::MIN_POSITIVE),
        }
    }

    /// `shown`, mm, at a time.
    fn look(&mut self, time: f64, shown: f64) {
        let state = self.cursor.at(time);
        let error = shown - state.position;
        self.whole.add(error);
        self.bins[((time / self.width) as usize).min(BINS - 1)].add(error);
        if state.acceleration != 0.0 || state.speed == 0.0 {
            self.constant = None;
            return;
        }
        let since = *self.constant.get_or_insert(time);
        if (time - since) * state.speed.abs() >= 3.0 * self.pitch {
            self.steady.add(error);
        }
    }

    fn finish(self) -> MultiplierRun {
        let middle = |k: usize| (k as f64 + 0.5) * self.width;
        let bins = self.bins.iter().enumerate().filter_map(|(k, bin)| Some((middle(k), bin.any()?)));
        MultiplierRun { whole: self.whole, steady: self.steady.any(), bins: bins.collect() }
    }
}

/// The staircase of P steps a pitch.
fn staircase(place: f64, pitch: f64, p: f64) -> f64 {
    (place / pitch * p).floor() / p * pitch
}

impl PhaseLockedLoop {
    /// Of a bandwidth in Hz.
    ///
    /// # Errors
    /// [`ControlError::BadParameter`] with the name of the field.
    pub fn new(bandwidth: f64, damping: f64) -> Result<Self, ControlError> {
        within("bandwidth", bandwidth, 1e-3..=1e6, "0.001 to 1e6 Hz")?;
        within("damping", damping, 0.05..=10.0, "0.05 to 10")?;
        Ok(Self { frequency: TAU * bandwidth, damping })
    }

    /// Deviation of the oscillator's phase and its rate after a time in which no line was passed: u'' + 2 d w u' + w^2 u = 0.
    fn after(&self, [u, rate]: [f64; 2], time: f64) -> [f64; 2] {
        let (w, d) = (self.frequency, self.damping);
        let decay = (-d * w * time).exp();
        // Half the slope of what the damping does not explain.
        let b = rate + d * w * u;
        let bend = w * w * (1.0 - d * d);
        let (cosine, sine) = if bend.abs() * time * time < 1e-12 {
            // At critical damping both forms have the same limit.
            (1.0, time)
        } else if bend > 0.0 {
            let f = bend.sqrt();
            ((f * time).cos(), (f * time).sin() / f)
        } else {
            let f = (-bend).sqrt();
            // Without the overflow that cosh has over a long time.
            let (up, down) = (((f - d * w) * time).exp(), ((-f - d * w) * time).exp());
            let value = [0.5 * (up + down), 0.5 * (up - down) / f];
            let place = u * value[0] + b * value[1];
            let speed = b * value[0] - u * bend * value[1] - d * w * place;
            return [place, speed];
        };
        let place = decay * (u * cosine + b * sine);
        [place, decay * (b * cosine - u * bend * sine) - d * w * place]
    }

    /// The loop on a motion and `rest` s behind it, at rest and centred before.
    ///
    /// # Errors
    /// As [`SlideMotion::crossings`].
    pub fn run(
        &self,
        interpolation: &Interpolation,
        motion: &SlideMotion,
        rest: f64,
    ) -> Result<MultiplierRun, ControlError> {
        let (pitch, p) = (interpolation.pitch, f64::from(interpolation.settings.pulses_per_interval()));
        let end = motion.duration() + rest;
        let crossings: Vec<(f64, i64)> =
            motion.crossings(pitch)?.map(|crossing| (crossing.time, crossing.direction.sign())).collect();
        let cell = (motion.at(0.0).position / pitch).floor();
        let mut beside = Beside::new(motion, pitch, end);
        // Phase of the oscillator less lines and a half, in pitches, and the integral part of its frequency.
        let (mut lines, mut deviation, mut integral) = (0.0, 0.0, 0.0);
        let mut now = 0.0;
        let most = (MOST_INSTANTS / (crossings.len() as f64 + 1.0)).max(4.0);
        for (next, sign) in crossings.into_iter().chain([(end, 0)]) {
            let span = (next - now).max(0.0);
            // Twenty instants a period of the loop, and sixteen a line.
            let instants = (20.0 * span * self.frequency / TAU).max(16.0).min(most).ceil() as u32;
            let rate = integral - 2.0 * self.damping * self.frequency * deviation;
            for k in 0..=instants {
                let time = span * f64::from(k) / f64::from(instants);
                let [u, _] = self.after([deviation, rate], time);
                beside.look(now + time, staircase((cell + lines + 0.5 + u) * pitch, pitch, p));
            }
            let [u, speed] = self.after([deviation, rate], span);
            integral = speed + 2.0 * self.damping * self.frequency * u;
            lines += sign as f64;
            deviation = u - sign as f64;
            now = next;
        }
        Ok(beside.finish())
    }
}

impl AmplitudeInterpolation {
    /// Shares of the amplitude, rad and s.
    ///
    /// # Errors
    /// [`ControlError::BadParameter`] with the name of the field.
    pub fn new(offset: f64, mismatch: f64, phase_error: f64, delay: f64) -> Result<Self, ControlError> {
        within("offset", offset, -0.5..=0.5, "-0.5 to 0.5 of the amplitude")?;
        within("mismatch", mismatch, -0.5..=0.5, "-0.5 to 0.5 of the amplitude")?;
        within("phase_error", phase_error, -0.5..=0.5, "-0.5 to 0.5 rad")?;
        within("delay", delay, 0.0..=1.0, "0 to 1 s")?;
        Ok(Self { offset, mismatch, phase_error, delay })
    }

    /// Phase that the signals show less the true one, rad.
    pub fn phase_shown(&self, phase: f64) -> f64 {
        let sine = (1.0 + 0.5 * self.mismatch) * phase.sin() + self.offset;
        let cosine = (1.0 - 0.5 * self.mismatch) * (phase + self.phase_error).cos() + self.offset;
        let difference = sine.atan2(cosine) - phase;
        difference - TAU * (difference / TAU).round()
    }

    /// The signals on a motion and `rest` s behind it.
    ///
    /// # Errors
    /// [`ControlError::BadParameter`] for a motion with more instants than a run can look at.
    pub fn run(
        &self,
        interpolation: &Interpolation,
        motion: &SlideMotion,
        rest: f64,
    ) -> Result<MultiplierRun, ControlError> {
        let (pitch, p) = (interpolation.pitch, f64::from(interpolation.settings.pulses_per_interval()));
        let end = motion.duration() + rest;
        // Some hundred instants a line at the greatest speed, if there are not too many lines.
        let (speed, _) = motion.greatest();
        let instants = (200.0 * end * speed / pitch).clamp(1e4, MOST_INSTANTS).ceil() as u32;
        let mut beside = Beside::new(motion, pitch, end);
        let mut late = motion.cursor();
        for k in 0..=instants {
            let time = end * f64::from(k) / f64::from(instants);
            let seen = late.at((time - self.delay).max(0.0)).position;
            let shown = seen + self.phase_shown(TAU * seen / pitch) / TAU * pitch;
            beside.look(time, staircase(shown, pitch, p));
        }
        Ok(beside.finish())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::slide::Move;
    use electronic_gearbox::pulse::{Mode, Settings};

    fn interpolation() -> Interpolation {
        Interpolation {
            settings: Settings::new(16, 1 << 20, Mode::NoBacklash).unwrap(),
            clock: 1e6,
            pitch: 0.01,
        }
    }

    fn motion(acceleration: f64) -> SlideMotion {
        SlideMotion::of_moves(0.003, &[Move::To { position: 20.0, speed: 5.0, acceleration }]).unwrap()
    }

    #[test]
    fn a_loop_without_lines_comes_to_rest_as_its_equation_says() {
        for damping in [0.3, 1.0, 2.5] {
            let pll = PhaseLockedLoop::new(10.0, damping).unwrap();
            // By small steps.
            let (mut u, mut rate, step) = (0.7, -3.0, 1e-7);
            for _ in 0..200_000 {
                let bend = -pll.frequency * (2.0 * damping * rate + pll.frequency * u);
                rate += step * bend;
                u += step * rate;
            }
            let [place, speed] = pll.after([0.7, -3.0], 0.02);
            assert!(
                (place - u).abs() < 1e-4 && (speed - rate).abs() < 1e-2,
                "{damping}: {place} {u}, {speed} {rate}"
            );
            assert!(pll.after([0.7, -3.0], 1e3).iter().all(|value| value.abs() < 1e-12));
        }
    }

    /// A loop of second order lags by a/w^2 while the speed grows: from the start of the acceleration on, when it has settled.
    #[test]
    fn a_loop_lags_while_the_speed_grows() {
        let (bandwidth, acceleration) = (10.0, 2.0);
        let pll = PhaseLockedLoop::new(bandwidth, 0.7).unwrap();
        // It accelerates over 2.5 s.
        let motion = motion(acceleration);
        // Lines so fine that neither their ripple nor the staircase counts.
        let fine = Interpolation {
            settings: Settings::new(256, 1 << 20, Mode::NoBacklash).unwrap(),
            clock: 1e7,
            pitch: 0.001,
        };
        let run = pll.run(&fine, &motion, 0.1).unwrap();
        let lag = acceleration / (TAU * bandwidth).powi(2);
        let late: Vec<f64> = run
            .bins
            .iter()
            .filter(|(time, _)| (1.5..2.3).contains(time))
            .map(|(_, e)| e.least + e.greatest)
            .collect();
        let mean = late.iter().sum::<f64>() / late.len() as f64 / 2.0;
        assert!((mean / lag + 1.0).abs() < 0.02, "{mean} for {lag}");
        // In constant speed it is right to a pulse and the ripple of the lines.
        let steady = run.steady.unwrap();
        assert!(run.whole.range() > 1.2 * steady.range(), "{:?} {steady:?}", run.whole);
    }

    /// For small errors: offsets once a period, sqrt(2) o; mismatch and phase twice, m/2 and half the angle.
    #[test]
    fn signals_repeat_their_error_in_every_period() {
        let greatest = |made: AmplitudeInterpolation| {
            (0..3600).map(|k| made.phase_shown(TAU * f64::from(k) / 3600.0).abs()).fold(0.0, f64::max)
        };
        let offset = greatest(AmplitudeInterpolation::new(1e-4, 0.0, 0.0, 0.0).unwrap());
        assert!((offset / (2f64.sqrt() * 1e-4) - 1.0).abs() < 1e-3, "{offset}");
        let mismatch = greatest(AmplitudeInterpolation::new(0.0, 1e-4, 0.0, 0.0).unwrap());
        assert!((mismatch / 0.5e-4 - 1.0).abs() < 1e-3, "{mismatch}");
        let phase = greatest(AmplitudeInterpolation::new(0.0, 0.0, 1e-4, 0.0).unwrap());
        assert!((phase / 1e-4 - 1.0).abs() < 1e-3, "{phase}");
    }

    #[test]
    fn perfect_signals_leave_the_staircase_and_the_delay() {
        let perfect = AmplitudeInterpolation::new(0.0, 0.0, 0.0, 0.0).unwrap();
        let run = perfect.run(&interpolation(), &motion(100.0), 0.1).unwrap();
        let step = 0.01 / 16.0;
        assert!(run.whole.greatest <= 1e-9 && run.whole.least >= -step - 1e-9);
        assert!(run.whole.range() > 0.98 * step);
        let late = AmplitudeInterpolation::new(0.0, 0.0, 0.0, 1e-3).unwrap();
        let steady = late.run(&interpolation(), &motion(100.0), 0.1).unwrap().steady.unwrap();
        assert!(
            (steady.least + step + 5e-3).abs() < 2e-5 && (steady.greatest + 5e-3).abs() < 2e-5,
            "{steady:?}"
        );
    }

    #[test]
    fn bad_multipliers_name_the_field() {
        let name = |error: ControlError| match error {
            ControlError::BadParameter { name, .. } => name,
            other => panic!("{other}"),
        };
        assert_eq!(name(PhaseLockedLoop::new(0.0, 0.7).unwrap_err()), "bandwidth");
        assert_eq!(name(PhaseLockedLoop::new(1.0, f64::NAN).unwrap_err()), "damping");
        assert_eq!(name(AmplitudeInterpolation::new(0.6, 0.0, 0.0, 0.0).unwrap_err()), "offset");
        assert_eq!(name(AmplitudeInterpolation::new(0.0, 0.6, 0.0, 0.0).unwrap_err()), "mismatch");
        assert_eq!(name(AmplitudeInterpolation::new(0.0, 0.0, 0.6, 0.0).unwrap_err()), "phase_error");
        assert_eq!(name(AmplitudeInterpolation::new(0.0, 0.0, 0.0, -1.0).unwrap_err()), "delay");
    }
}
