//! How a tool is recorded at the light barrier: in which senses, how often, how fast.

use crate::job::ToolMeasuring;
use crate::measuring::Sense;

/// Senses, turns and times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recording {
    /// Senses of the tool, in the order of measuring.
    pub senses: &'static [Sense],
    /// Whole turns in each.
    pub revolutions: usize,
    /// Speed of the tool, 1/min.
    pub speed_rpm: f64,
    /// Time from one pose to the next, s.
    pub move_time_s: f64,
    /// Start of the random numbers of a simulated measurement.
    pub seed: u64,
}

impl Recording {
    pub(super) fn of_job(given: &ToolMeasuring) -> Self {
        Self {
            senses: given.senses.list(),
            revolutions: given.revolutions,
            speed_rpm: given.speed_rpm,
            move_time_s: given.move_time_s,
            seed: given.seed,
        }
    }

    /// Time of so many turns in each of so many poses, s (`docs/mathematics/skiving.md#light-barrier`).
    pub fn time_s(&self, poses: usize, turns: usize) -> f64 {
        poses as f64 * (turns as f64 * 60.0 / self.speed_rpm + self.move_time_s)
    }
}
