//! Bringing the follower to the speed of the coupling, or out of it, while the leading axes run.

use super::Motion;
use super::profile::{PEAK_SPEED, mean_transition, transition, transition_speed};

/// Progress of a ramp. Its time T = 1.875 |v|/a_max goes by the greatest speed seen since it began: leading axes that speed up stretch it,
/// so that the limit holds for them as well; those that slow down or stop leave it as it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ramp {
    /// 0..=1.
    progress: f64,
    greatest_speed: f64,
}

/// What one step of a ramp has done.
pub(super) struct RampStep {
    /// Mean of S over the step.
    pub mean: f64,
    /// S at its end.
    pub share: f64,
    /// dS/dt at its end, 1/s.
    pub rate: f64,
}

impl Ramp {
    /// At its beginning, with the speed of the coupling there.
    pub(super) fn new(speed: f64) -> Self {
        Self { progress: 0.0, greatest_speed: speed.abs() }
    }

    pub(super) fn is_over(&self) -> bool {
        self.progress >= 1.0
    }

    /// One step of `duration` > 0; `coupled` is the motion of the coupling at its end.
    pub(super) fn advance(
        &mut self,
        duration: f64,
        coupled: &Motion,
        greatest_acceleration: f64,
    ) -> RampStep {
        self.greatest_speed = self.greatest_speed.max(coupled.speed.abs());
        let whole = PEAK_SPEED * self.greatest_speed / greatest_acceleration;
        let left = (1.0 - self.progress) * whole;
        if duration >= left {
            let mean = (left * mean_transition(self.progress, 1.0) + (duration - left)) / duration;
            self.progress = 1.0;
            return RampStep { mean, share: 1.0, rate: 0.0 };
        }
        let from = self.progress;
        self.progress = (from + duration / whole).min(1.0);
        RampStep {
            mean: mean_transition(from, self.progress),
            share: transition(self.progress),
            rate: transition_speed(self.progress) / whole,
        }
    }
}
