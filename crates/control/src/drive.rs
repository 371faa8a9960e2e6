//! How encoders, scale and gearbox drive a workpiece, sample by sample: pulses of the slide that turn it, its coupling to the worm, the
//! setpoint of its loop.

use super::interpolation::Interpolation;
use super::rotation::{Rotation, RotationCounter};
use super::servo::Setpoint;
use electronic_gearbox::Error as GearboxError;
use electronic_gearbox::coupling::{Ratio, endless_ratio};
use electronic_gearbox::pulse::{EventInterpolator, Status, TimedPulse};
use std::f64::consts::TAU;
use std::iter::Peekable;
use std::slice::Iter;

/// The pulses of a slide in time, and what they turn the workpiece by.
pub(super) struct PulseDrive<'a> {
    interpolator: EventInterpolator,
    rotation: RotationCounter,
    clock: f64,
    references: Peekable<Iter<'a, (u64, i64)>>,
    net: i64,
}

impl<'a> PulseDrive<'a> {
    /// Before the first of the reference pulses (tick, sign).
    pub(super) fn new(
        feed: &Interpolation,
        rotation: &Rotation,
        references: &'a [(u64, i64)],
    ) -> Result<Self, GearboxError> {
        Ok(Self {
            interpolator: EventInterpolator::new(feed.settings),
            rotation: rotation.counter(feed.settings.pulses_per_interval())?,
            clock: feed.clock,
            references: references.iter().peekable(),
            net: 0,
        })
    }

    /// All pulses up to a time (s), not before the one given last.
    pub(super) fn advance(&mut self, time: f64) -> Result<(), GearboxError> {
        let tick = (time * self.clock).floor() as u64;
        let mut failed = Ok(());
        let mut sink = |timed: TimedPulse| {
            self.net += timed.pulse.direction.sign();
            if let Err(error) = self.rotation.pulse(timed.pulse.direction) {
                failed = Err(error);
            }
        };
        while let Some((at, sign)) = self.references.next_if(|(at, _)| *at <= tick) {
            self.interpolator.reference(*at, *sign, &mut sink)?;
        }
        self.interpolator.advance(tick, &mut sink);
        failed
    }

    /// Sum of the signs of all pulses so far.
    pub(super) fn net(&self) -> i64 {
        self.net
    }

    /// Parts of rotation so far.
    pub(super) fn turned(&self) -> i64 {
        self.rotation.total()
    }

    /// State of the interpolator.
    pub(super) fn status(&self) -> Status {
        self.interpolator.status()
    }
}

/// Parts of a revolution of the workpiece (`parts` of them) per count of the worm (`worm_pulses` a revolution), which turn against each
/// other.
pub(super) fn worm_ratio(
    threads: i64,
    teeth: i64,
    parts: i64,
    worm_pulses: u32,
) -> Result<Ratio, GearboxError> {
    endless_ratio(-threads, parts, teeth, i64::from(worm_pulses))
}

/// Counts of a closed gearbox as angle of the workpiece. It is closed at its first counts, where the workpiece stands.
pub(super) struct ClosedGearbox {
    parts: f64,
    begin: f64,
    offset: Option<f64>,
}

impl ClosedGearbox {
    /// `parts` counts a revolution; the workpiece stands at `begin`, rad.
    pub(super) fn new(parts: f64, begin: f64) -> Self {
        Self { parts, begin, offset: None }
    }

    /// Angle that belongs to counts, rad.
    pub(super) fn angle(&mut self, counts: f64) -> f64 {
        let offset = *self.offset.get_or_insert(self.begin / TAU * self.parts - counts);
        (counts + offset) / self.parts * TAU
    }

    /// What the loop is given for an angle of the gearbox, with the ideal speed and acceleration. Half a part up: the loop rounds its
    /// setpoint down, this one is whole already.
    pub(super) fn setpoint(&self, angle: f64, speed: f64, acceleration: f64) -> Setpoint {
        Setpoint { position: angle + 0.5 / self.parts * TAU, speed, acceleration }
    }
}
