//! The worm on the workpiece: the coupled motion of generating grinding at a constant ratio of worm speed and feed.

use super::{BodyPlace, Waypoint};
use foundation::kinematics::{GeneratingMotion, GeneratingState, MotionLaw, Pose, Workpiece, Worm};
use machine::{Mounts, StationSpindle, ToolSpindle};
use std::f64::consts::TAU;

/// A grinding stroke's bodies.
#[derive(Clone, Debug)]
pub struct GrindingCourse {
    /// The motion.
    pub motion: GeneratingMotion,
    /// k_0F of the flank that is ground, of either if both are, rad.
    pub phase: f64,
    /// Feeds z_V2 on which the motion is given, mm; beyond them its laws go on straight.
    pub feeds: [f64; 2],
    /// Turning of the worm per feed, rad/mm, signed.
    pub turning: f64,
    /// How the bodies are clamped.
    pub mounts: Mounts,
    /// Normal deviation of the flank per turning of the workpiece: the largest r_b2 cos(beta_b2) of its flanks, mm/rad.
    pub per_turn: f64,
    /// Normal deviation of the flank per centre distance: the largest sin(alpha_n).
    pub per_distance: f64,
}

/// Slope of a worm's modification along its axis that a course takes into account: 10 um/mm, steeper than any relief.
const PER_SHIFT: f64 = 0.01;

/// A law that goes on straight beyond an interval.
pub(super) fn beyond(law: &MotionLaw, [from, to]: [f64; 2], v: f64) -> f64 {
    let at = v.clamp(from, to);
    let [value, slope, _] = law.jet(at);
    value + slope * (v - at)
}

impl GrindingCourse {
    /// State of the bodies at a place; the workpiece as the coupling has it.
    fn state(&self, at: &Waypoint) -> GeneratingState {
        let worm_angle = self.turning * (at.v - self.feeds[0]) + at.lead;
        let shift = beyond(&self.motion.shift, self.feeds, at.v);
        GeneratingState {
            worm_angle,
            work_angle: self.coupled(worm_angle, shift, at.v),
            shift,
            feed: at.v,
            delta_d: beyond(&self.motion.delta_d, self.feeds, at.v) + at.lift,
            delta_gamma: beyond(&self.motion.delta_gamma, self.feeds, at.v),
        }
    }

    /// Angle of the workpiece that belongs to worm, shift and feed.
    fn coupled(&self, worm_angle: f64, shift: f64, feed: f64) -> f64 {
        let m = &self.motion;
        let turned = -worm_angle * m.threads + self.phase + shift * m.shift_coupling + feed * m.feed_coupling;
        turned / m.teeth + beyond(&m.delta_phi_2, self.feeds, feed)
    }

    pub(super) fn place(&self, at: &Waypoint) -> BodyPlace {
        let state = self.state(at);
        BodyPlace {
            pose: self.mounts.spindles(&self.motion.chain.pose(&state)),
            angles: [state.worm_angle, state.work_angle],
        }
    }

    pub(super) fn off(&self, pose: &Pose<ToolSpindle, StationSpindle>, near: &Waypoint) -> Option<f64> {
        let bodies: Pose<Worm, Workpiece> = self.mounts.bodies(pose);
        let is = self.motion.chain.state_of(&bodies, &self.state(near))?;
        let wanted = self.state(&Waypoint { v: is.feed, ..*near });
        let turned = is.work_angle - self.coupled(is.worm_angle, is.shift, is.feed);
        let turned = turned - TAU * (turned / TAU).round();
        Some(
            self.per_turn * turned.abs()
                + self.per_distance * (is.delta_d - wanted.delta_d).abs()
                + PER_SHIFT * (is.shift - wanted.shift).abs(),
        )
    }
}
