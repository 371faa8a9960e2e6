//! Engaging the coupling while the leading axes run, putting it in phase, watching it, and opening it again
//! (`docs/mathematics/gearbox.md#couplings`).
//!
//! The follower's setpoint is y_0 + sum + offset. The gearbox gives y_0 + sum, exactly, with y_0 := follower - sum at the moment of
//! engaging; this machine gives the offset, which starts at 0 and is at rest from the end of the phase move on. So no rounding of it can
//! drift, and its numbers stay small however far the axes turn. Units: that of the follower (degrees or counts, one for all), and s.

mod phase_move;
mod profile;
mod ramp;
mod settings;

pub use phase_move::shortest_move;
pub use settings::{EngagementSettings, FollowingWindow};

use crate::Error;
use phase_move::PhaseMove;
use ramp::Ramp;

/// Position, speed and acceleration: of the coupling (the gearbox's sum with its rates; where the acceleration of the leading axes is
/// unknown, 0 there only makes that of the output less exact), or of the offset.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// In the follower's unit.
    pub position: f64,
    /// A second.
    pub speed: f64,
    /// A second squared.
    pub acceleration: f64,
}

/// Range of the gearbox, 2^62 counts.
const RANGE: f64 = (1u64 << 62) as f64;

impl Motion {
    fn check(&self) -> Result<(), Error> {
        for (name, value) in [
            ("position of the coupling", self.position),
            ("speed of the coupling", self.speed),
            ("acceleration of the coupling", self.acceleration),
        ] {
            if value.is_nan() || value.abs() >= RANGE {
                return Err(Error::BadParameter { name, value, allowed: "finite, below 2^62" });
            }
        }
        Ok(())
    }
}

/// State of the coupling.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum EngagementState {
    /// Open: the follower has nothing to do with the leading axes.
    Off,
    /// The follower comes up to speed.
    Ramping,
    /// It runs along; the phase move waits for its target, or runs.
    Synchronising,
    /// In phase.
    Coupled,
    /// The follower leaves the coupling and comes to rest.
    Leaving,
    /// It did not follow. The coupling is kept until the leading axes stand, since opening it in the gear does the damage.
    Fault,
}

/// What the follower has to do now.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EngagementOutput {
    /// State after the step.
    pub state: EngagementState,
    /// To be added to the gearbox's y_0 + sum and its rates; `None` while the coupling is open, when the follower is free.
    pub offset: Option<Motion>,
    /// How well the follower follows, while coupled.
    pub window: Option<FollowingWindow>,
    /// Whether the leading axes have to stop, each by its own ramp.
    pub stop_leading_axes: bool,
}

/// The state machine. One call of [`Engagement::update`] a cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Engagement {
    settings: EngagementSettings,
    stage: Stage,
    /// Offset where it is at rest, or was at the last step.
    offset: f64,
    /// Coupling at the last step.
    coupled: Motion,
    target: Option<Target>,
    off_requested: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Stage {
    Off,
    Ramping(Ramp),
    Waiting,
    Moving(PhaseMove),
    /// With the time outside the coarse window.
    Coupled(f64),
    Leaving(Ramp),
    Fault,
}

/// Offset modulo pitch that puts the follower in phase.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Target {
    offset: f64,
    pitch: f64,
}

impl Engagement {
    /// Open.
    ///
    /// # Errors
    /// [`Error::BadParameter`] for limits that are not positive, negative windows or times, a coarse window below the fine one, and
    /// anything that is not finite.
    pub fn new(settings: EngagementSettings) -> Result<Self, Error> {
        settings.check()?;
        Ok(Self {
            settings,
            stage: Stage::Off,
            offset: 0.0,
            coupled: Motion::default(),
            target: None,
            off_requested: false,
        })
    }

    /// Begins to bring the follower, which stands, up to the coupling's speed. At the same moment the gearbox gets y_0 := follower - sum,
    /// and `coupled` is its motion. The time is T = 1.875 |v|/a_max, the way v T/2 at a constant speed v.
    ///
    /// # Errors
    /// [`Error::Busy`] unless the coupling is open; [`Error::BadParameter`] for a motion beyond the range of the gearbox.
    pub fn engage(&mut self, coupled: Motion) -> Result<(), Error> {
        self.change_allowed()?;
        coupled.check()?;
        *self = Self {
            stage: Stage::Ramping(Ramp::new(coupled.speed)),
            offset: 0.0,
            coupled,
            target: None,
            off_requested: false,
            ..*self
        };
        Ok(())
    }

    /// Names the tooth space: `position` is where the follower's setpoint is, as of the last update, and `target` where it would have to be
    /// at that very moment, give or take multiples of `pitch` (360/|z_2| degrees). Both turn with the coupling, so that only their
    /// difference counts. The move begins as soon as the follower runs along.
    ///
    /// # Errors
    /// [`Error::NotEngaged`] if the coupling is open, [`Error::Busy`] from the beginning of the move on, [`Error::BadParameter`] as for
    /// [`shortest_move`].
    pub fn synchronise(&mut self, position: f64, target: f64, pitch: f64) -> Result<(), Error> {
        match self.stage {
            Stage::Off => Err(Error::NotEngaged),
            Stage::Ramping(_) | Stage::Waiting => {
                let way = shortest_move(position, target, pitch)?;
                self.target = Some(Target { offset: self.offset + way, pitch });
                Ok(())
            }
            Stage::Moving(_) | Stage::Coupled(_) | Stage::Leaving(_) | Stage::Fault => Err(Error::Busy),
        }
    }

    /// Asks for the coupling to be opened. A ramp or phase move that runs is finished first; then the follower comes to rest with the
    /// time rule of engaging, also while the leading axes run on. In a fault the coupling opens once they stand. The caller has to
    /// know that tool and gear are clear of each other.
    pub fn switch_off(&mut self) {
        self.off_requested = !matches!(self.stage, Stage::Off | Stage::Leaving(_));
    }

    /// One cycle of `step` seconds; `coupled` is the motion of the coupling at its end, `following_error` setpoint minus actual position
    /// of the follower. The time it takes does not depend on data.
    ///
    /// # Errors
    /// [`Error::BadParameter`] for a step that is not positive, and for a motion beyond the range of the gearbox: nothing has changed
    /// then, and the caller has lost its leading axes. The same error forgets a target that has gone 2^52 pitches away during the ramp. A
    /// following error that is not finite counts as outside the windows.
    pub fn update(
        &mut self,
        step: f64,
        coupled: Motion,
        following_error: f64,
    ) -> Result<EngagementOutput, Error> {
        if !(step > 0.0 && step.is_finite()) {
            return Err(Error::BadParameter {
                name: "step of time",
                value: step,
                allowed: "above 0 s, finite",
            });
        }
        coupled.check()?;
        self.begin_next_stage(&coupled)?;
        let way = coupled.position - self.coupled.position;
        let acceleration = self.settings.acceleration;
        let mut offset = Motion { position: self.offset, ..Motion::default() };
        let mut window = None;
        match &mut self.stage {
            Stage::Off | Stage::Waiting | Stage::Fault => {}
            Stage::Ramping(ramp) => {
                // The follower goes S times the way of the coupling: the offset takes the rest away.
                let step = ramp.advance(step, &coupled, acceleration);
                offset.position -= (1.0 - step.mean) * way;
                offset.speed = -(1.0 - step.share) * coupled.speed;
                offset.acceleration = step.rate * coupled.speed - (1.0 - step.share) * coupled.acceleration;
                if ramp.is_over() {
                    self.stage = Stage::Waiting;
                }
            }
            Stage::Moving(run) => {
                offset = run.advance(step);
                if run.is_over() {
                    self.stage = Stage::Coupled(0.0);
                }
            }
            Stage::Coupled(outside) => {
                let now = self.settings.window(following_error);
                window = Some(now);
                *outside = if now == FollowingWindow::Outside { *outside + step } else { 0.0 };
                if now == FollowingWindow::Outside && *outside >= self.settings.fault_time {
                    self.stage = Stage::Fault;
                }
            }
            Stage::Leaving(ramp) => {
                let step = ramp.advance(step, &coupled, acceleration);
                offset.position -= step.mean * way;
                offset.speed = -step.share * coupled.speed;
                offset.acceleration = -step.rate * coupled.speed - step.share * coupled.acceleration;
            }
        }
        self.offset = offset.position;
        self.coupled = coupled;
        let state = self.state();
        Ok(EngagementOutput {
            state,
            offset: (state != EngagementState::Off).then_some(offset),
            window,
            stop_leading_axes: state == EngagementState::Fault,
        })
    }

    /// Changes of state that begin with a step: what has ended with the last one, or was asked for since.
    fn begin_next_stage(&mut self, coupled: &Motion) -> Result<(), Error> {
        match self.stage {
            Stage::Leaving(ramp) if ramp.is_over() => self.stage = Stage::Off,
            Stage::Waiting | Stage::Coupled(_) if self.off_requested => {
                self.off_requested = false;
                self.stage = Stage::Leaving(Ramp::new(self.coupled.speed));
            }
            Stage::Waiting => {
                if let Some(Target { offset, pitch }) = self.target.take() {
                    let way = shortest_move(self.offset, offset, pitch)?;
                    let Self { settings, .. } = *self;
                    self.stage = Stage::Moving(PhaseMove::new(
                        self.offset,
                        way,
                        settings.phase_speed,
                        settings.acceleration,
                    ));
                }
            }
            Stage::Fault if self.off_requested && coupled.speed.abs() <= self.settings.standstill_speed => {
                self.off_requested = false;
                self.stage = Stage::Off;
            }
            Stage::Off
            | Stage::Ramping(_)
            | Stage::Moving(_)
            | Stage::Coupled(_)
            | Stage::Leaving(_)
            | Stage::Fault => {}
        }
        Ok(())
    }

    /// Where it is.
    pub const fn state(&self) -> EngagementState {
        match self.stage {
            Stage::Off => EngagementState::Off,
            Stage::Ramping(_) => EngagementState::Ramping,
            Stage::Waiting | Stage::Moving(_) => EngagementState::Synchronising,
            Stage::Coupled(_) => EngagementState::Coupled,
            Stage::Leaving(_) => EngagementState::Leaving,
            Stage::Fault => EngagementState::Fault,
        }
    }

    /// Whether the follower runs along and waits for [`Engagement::synchronise`].
    pub const fn awaits_target(&self) -> bool {
        matches!(self.stage, Stage::Waiting) && self.target.is_none()
    }

    /// Whether ratio, table and sign may change.
    ///
    /// # Errors
    /// [`Error::Busy`] unless the coupling is open: any change would be a jump of the follower.
    pub const fn change_allowed(&self) -> Result<(), Error> {
        match self.stage {
            Stage::Off => Ok(()),
            _ => Err(Error::Busy),
        }
    }
}

#[cfg(test)]
mod tests;
