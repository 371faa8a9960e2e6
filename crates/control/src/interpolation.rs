//! The pulse interpolator behind a real slide: its pulses, what they miss the slide by, and what the additional rotation that they turn
//! misses the lead by (`docs/mathematics/gearbox.md`).

use super::error::{ControlError, within};
use super::rotation::{Rotation, RotationCounter};
use super::slide::{SlideCursor, SlideMotion};
use electronic_gearbox::Error as GearboxError;
use electronic_gearbox::pulse::{EventInterpolator, Mode, PulseKind, Settings, Status, TimedPulse};

/// Scale, clock and interpolator of a slide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interpolation {
    /// P, counter and mode.
    pub settings: Settings,
    /// Clock f1, Hz.
    pub clock: f64,
    /// Distance of the lines p, mm.
    pub pitch: f64,
}

/// How many pulses of which kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PulseCounts {
    /// Of the scale.
    pub references: u64,
    /// Inserted at the spacing of the interval before.
    pub intermediates: u64,
    /// Inserted at the clock's pace.
    pub corrections: u64,
    /// Sum of the signs of all.
    pub net: i64,
    /// Sum of the signs of those of the scale.
    pub net_references: i64,
    /// Parts of rotation turned, either way.
    pub passed: u64,
}

/// Least and greatest of a quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes {
    /// Least.
    pub least: f64,
    /// Greatest.
    pub greatest: f64,
}

impl Extremes {
    pub(super) const NONE: Self = Self { least: f64::INFINITY, greatest: f64::NEG_INFINITY };

    pub(super) fn add(&mut self, value: f64) {
        (self.least, self.greatest) = (self.least.min(value), self.greatest.max(value));
    }

    /// `None` if nothing was added.
    pub(super) fn any(self) -> Option<Self> {
        (self.least <= self.greatest).then_some(self)
    }

    /// Greatest less least.
    pub fn range(&self) -> f64 {
        self.greatest - self.least
    }
}

/// Errors over a stretch of time, for charts. Lengths mm, angles rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorBin {
    /// Middle of the stretch, s.
    pub time: f64,
    /// Pulse position less slide.
    pub axial: Extremes,
    /// Additional rotation less that of the lead; zeros without a rotation.
    pub angle: Extremes,
}

/// What a run brought.
#[derive(Clone, Debug, PartialEq)]
pub struct InterpolationRun {
    /// Counts.
    pub counts: PulseCounts,
    /// State at the end.
    pub status: Status,
    /// Additional rotation in parts 1/P of a workpiece pulse at the end.
    pub rotation: i64,
    /// Error along the feed over everything from the second reference pulse on, mm; `None` if there was none.
    pub error: Option<Extremes>,
    /// The same where speed has been constant for this interval and the one before.
    pub steady: Option<Extremes>,
    /// Mean error of intervals passed upwards and downwards at constant speed, mm.
    pub means: [Option<f64>; 2],
    /// Error of the angle, rad.
    pub angle: Option<Extremes>,
    /// Errors over time.
    pub bins: Vec<ErrorBin>,
}

impl InterpolationRun {
    /// How far the pulse position of both senses differs at one place of the slide, mm; `None` unless both were driven.
    pub fn direction_offset(&self) -> Option<f64> {
        let [up, down] = self.means;
        Some(down? - up?)
    }
}

/// Stretches into which a run is divided for charts.
const BINS: usize = 1500;

impl Interpolation {
    /// Clock and pitch within range.
    ///
    /// # Errors
    /// [`ControlError::BadParameter`].
    pub fn validate(&self) -> Result<(), ControlError> {
        within("clock", self.clock, 1e-3..=1e12, "0.001 to 1e12 Hz")?;
        within("pitch", self.pitch, 1e-9..=1e6, "1e-9 to 1e6 mm")?;
        Ok(())
    }

    /// The reference pulses of a motion as (tick, sign): each in the first tick at or after its line, one a tick at most.
    ///
    /// # Errors
    /// As [`SlideMotion::crossings`].
    pub fn references(&self, motion: &SlideMotion) -> Result<Vec<(u64, i64)>, ControlError> {
        self.validate()?;
        let mut last = 0;
        Ok(motion
            .crossings(self.pitch)?
            .map(|crossing| {
                last = ((crossing.time * self.clock).ceil() as u64).max(last + 1);
                (last, crossing.direction.sign())
            })
            .collect())
    }

    /// Runs the interpolator over reference pulses up to `last_tick`, comparing with the slide if there is one. Every pulse goes to
    /// `trace` as well, with the parts of rotation that it turned.
    ///
    /// # Errors
    /// [`GearboxError::BadReferenceTrain`], [`GearboxError::GearRange`].
    pub fn run(
        &self,
        references: &[(u64, i64)],
        last_tick: u64,
        slide: Option<&SlideMotion>,
        rotation: Option<&Rotation>,
        trace: &mut dyn FnMut(TimedPulse, i64),
    ) -> Result<InterpolationRun, GearboxError> {
        let mut machine = EventInterpolator::new(self.settings);
        let chain = match rotation {
            Some(rotation) => Some((rotation.counter(self.settings.pulses_per_interval())?, rotation)),
            None => None,
        };
        let mut observer = Observer::new(self, references, last_tick, slide, chain);
        let mut failed = Ok(());
        let mut sink = |pulse| match observer.pulse(pulse) {
            Ok(turned) => trace(pulse, turned),
            Err(error) => failed = Err(error),
        };
        for &(tick, sign) in references {
            machine.reference(tick, sign, &mut sink)?;
        }
        machine.advance(last_tick, &mut sink);
        failed?;
        Ok(observer.finish(machine.status(), last_tick))
    }
}

/// Follows the pulses of a run beside the slide.
struct Observer<'a> {
    interpolation: &'a Interpolation,
    chain: Option<(RotationCounter, &'a Rotation)>,
    counts: PulseCounts,
    measure: Option<Measure<'a>>,
}

/// Comparison with the slide.
struct Measure<'a> {
    slide: SlideCursor<'a>,
    stops: std::iter::Peekable<std::vec::IntoIter<f64>>,
    /// Place of the slide at pulse position 0, mm.
    origin: f64,
    /// Pulses at that place.
    zero: i64,
    /// Sense of the running interval, and whether it and the one before had constant speed.
    sign: i64,
    steady: u32,
    error: Extremes,
    steady_error: Extremes,
    sums: [(f64, f64); 2],
    last: Option<(f64, f64)>,
    angle: Extremes,
    bins: Vec<(Extremes, Extremes)>,
    width: f64,
}

impl<'a> Observer<'a> {
    fn new(
        interpolation: &'a Interpolation,
        references: &[(u64, i64)],
        last_tick: u64,
        slide: Option<&'a SlideMotion>,
        chain: Option<(RotationCounter, &'a Rotation)>,
    ) -> Self {
        let measure = slide.zip(references.first()).and_then(|(motion, &(_, sign))| {
            let first = motion.crossings(interpolation.pitch).ok()?.next()?.line;
            let p = i64::from(interpolation.settings.pulses_per_interval());
            let backwards = sign < 0;
            let zero = match interpolation.settings.mode() {
                Mode::NoBacklash if backwards => p - 1,
                _ => 0,
            };
            Some(Measure {
                slide: motion.cursor(),
                stops: motion.stops().into_iter().peekable(),
                // The first pulse belongs to its line: position 0 is one pulse before it.
                origin: (first + i64::from(backwards)) as f64 * interpolation.pitch
                    - interpolation.pitch / p as f64,
                zero,
                sign: 0,
                steady: 0,
                error: Extremes::NONE,
                steady_error: Extremes::NONE,
                sums: [(0.0, 0.0); 2],
                last: None,
                angle: Extremes::NONE,
                bins: vec![(Extremes::NONE, Extremes::NONE); BINS],
                width: (last_tick as f64 / interpolation.clock / BINS as f64).max(f64::MIN_POSITIVE),
            })
        });
        Self { interpolation, chain, counts: PulseCounts::default(), measure }
    }

    fn pulse(&mut self, timed: TimedPulse) -> Result<i64, GearboxError> {
        let time = timed.tick as f64 / self.interpolation.clock;
        self.turns_before(time);
        self.look(time);
        let sign = timed.pulse.direction.sign();
        let counts = &mut self.counts;
        counts.net += sign;
        match timed.pulse.kind {
            PulseKind::Reference => {
                counts.references += 1;
                counts.net_references += sign;
            }
            PulseKind::Intermediate => counts.intermediates += 1,
            PulseKind::Correction => counts.corrections += 1,
        }
        let turned = match &mut self.chain {
            Some((chain, _)) => chain.pulse(timed.pulse.direction)?,
            None => 0,
        };
        counts.passed += turned.unsigned_abs();
        if let Some(measure) = &mut self.measure
            && timed.pulse.kind == PulseKind::Reference
        {
            let uniform = measure.slide.at(time).acceleration == 0.0;
            measure.steady = if uniform && measure.sign == sign { measure.steady + 1 } else { 0 };
            measure.sign = sign;
            measure.last = None;
        }
        self.look(time);
        Ok(turned)
    }

    /// Between two pulses the error is least or greatest at a pulse or where the slide turns.
    fn turns_before(&mut self, time: f64) {
        while let Some(stop) = self.measure.as_mut().and_then(|m| m.stops.next_if(|stop| *stop < time)) {
            self.look(stop);
        }
    }

    fn look(&mut self, time: f64) {
        let Some(measure) = &mut self.measure else { return };
        // Before the second reference pulse nothing is inserted: the machine does not know the speed yet.
        if self.counts.references < 2 {
            return;
        }
        let state = measure.slide.at(time);
        let p = f64::from(self.interpolation.settings.pulses_per_interval());
        let way = state.position - measure.origin;
        let pulses = (self.counts.net - measure.zero) as f64;
        let error = pulses * self.interpolation.pitch / p - way;
        measure.error.add(error);
        let bin = ((time / measure.width) as usize).min(BINS - 1);
        measure.bins[bin].0.add(error);
        // Two whole intervals of constant speed, and one for the burst behind them.
        if measure.steady >= 3 && state.acceleration == 0.0 {
            measure.steady_error.add(error);
            if let Some((before, earlier)) = measure.last {
                let (sum, duration) = &mut measure.sums[usize::from(measure.sign < 0)];
                *sum += 0.5 * (error + earlier) * (time - before);
                *duration += time - before;
            }
            measure.last = Some((time, error));
        }
        if let Some((chain, rotation)) = &self.chain {
            let turned = chain.total() as f64 / rotation.parts_per_revolution;
            // The pulses at the zero of the slide have turned the workpiece before anything is ground.
            let way = way + measure.zero as f64 * self.interpolation.pitch / p;
            let error = std::f64::consts::TAU * (turned - rotation.turns_per_millimetre * way);
            measure.angle.add(error);
            measure.bins[bin].1.add(error);
        }
    }

    fn finish(mut self, status: Status, last_tick: u64) -> InterpolationRun {
        let end = last_tick as f64 / self.interpolation.clock;
        self.turns_before(end);
        self.look(end);
        let rotation = self.chain.map_or(0, |(chain, _)| chain.total());
        let counts = self.counts;
        let Some(measure) = self.measure else {
            let (error, steady, angle) = (None, None, None);
            let means = [None; 2];
            return InterpolationRun {
                counts,
                status,
                rotation,
                error,
                steady,
                means,
                angle,
                bins: Vec::new(),
            };
        };
        let mean = |(sum, duration): (f64, f64)| (duration > 0.0).then(|| sum / duration);
        let bins = measure.bins.iter().enumerate().filter_map(|(k, (axial, angle))| {
            let time = (k as f64 + 0.5) * measure.width;
            let zero = Extremes { least: 0.0, greatest: 0.0 };
            Some(ErrorBin { time, axial: axial.any()?, angle: angle.any().unwrap_or(zero) })
        });
        InterpolationRun {
            counts,
            status,
            rotation,
            error: measure.error.any(),
            steady: measure.steady_error.any(),
            means: measure.sums.map(mean),
            angle: measure.angle.any(),
            bins: bins.collect(),
        }
    }
}
