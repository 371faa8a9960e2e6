//! Generating grinding: the chain workpiece -> worm of spec 00 and the coupled motion of its axes (spec 20 sections 4, 14).

use super::{MotionLaw, Pose, Workpiece, Worm};
use crate::geometry::Sides;

/// The constant part of the chain K_R: distances and angles. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GeneratingChain {
    /// Centre distance d.
    pub centre_distance: f64,
    /// Crossed-axes angle gamma.
    pub crossed_axes_angle: f64,
    /// theta_1 = cone angle of the worm.
    pub worm_cone: f64,
    /// theta_2 = minus the cone angle of the workpiece.
    pub work_cone: f64,
    /// r_w1 for a conical worm, 0 for a cylindrical one (its bracket is absent).
    pub worm_pivot: f64,
    /// r_w2 for a conical workpiece, 0 for a cylindrical one.
    pub work_pivot: f64,
}

/// Angles and feeds at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GeneratingState {
    /// Worm rotation phi_1, rad.
    pub worm_angle: f64,
    /// Workpiece rotation phi_2, rad.
    pub work_angle: f64,
    /// Tool shift z_V1, mm.
    pub shift: f64,
    /// Axial feed of the workpiece z_V2, mm.
    pub feed: f64,
    /// Added to the centre distance, mm.
    pub delta_d: f64,
    /// Added to the crossed-axes angle, rad.
    pub delta_gamma: f64,
}

impl GeneratingChain {
    /// X_SV = K_R of spec 00 at the given state.
    pub fn pose(&self, state: &GeneratingState) -> Pose<Worm, Workpiece> {
        type Link = Pose<Worm, Worm>;
        let head = Link::rz(-state.worm_angle)
            .then(&Link::ty(self.worm_pivot))
            .then(&Link::rx(self.worm_cone))
            .then(&Link::tz(-state.shift))
            .then(&Link::ty(self.centre_distance + state.delta_d))
            .then(&Link::ry(self.crossed_axes_angle + state.delta_gamma));
        type Turn = Pose<Workpiece, Workpiece>;
        let tail = Pose::<Worm, Workpiece>::tz(state.feed)
            .then(&Turn::rx(-self.work_cone))
            .then(&Turn::ty(-self.work_pivot))
            .then(&Turn::rz(state.work_angle));
        head.then(&tail)
    }
}

/// The motion of grinding as functions of the feed v = z_V2 (spec 20 section 14), with the coupling of the rotations.
#[derive(Clone, Debug, PartialEq)]
pub struct GeneratingMotion {
    /// The chain.
    pub chain: GeneratingChain,
    /// Threads z_1.
    pub threads: f64,
    /// Teeth z_2.
    pub teeth: f64,
    /// k_V1, rad/mm of tool shift.
    pub shift_coupling: f64,
    /// k_V2, rad/mm of feed.
    pub feed_coupling: f64,
    /// k_0F, rad, per flank (equal modulo 2 pi when both flanks are ground without backlash).
    pub phase: Sides<f64>,
    /// Tool shift z_V1 = F(v), mm.
    pub shift: MotionLaw,
    /// Delta_d(v), mm.
    pub delta_d: MotionLaw,
    /// Delta_phi_2(v), rad.
    pub delta_phi_2: MotionLaw,
    /// Delta_gamma(v), rad.
    pub delta_gamma: MotionLaw,
}

impl GeneratingMotion {
    /// The same motion without Delta_d, Delta_phi_2, Delta_gamma.
    pub fn uncorrected(&self) -> Self {
        self.with_share(0.0)
    }

    /// The same motion with every correction scaled to a share of itself.
    pub fn with_share(&self, share: f64) -> Self {
        Self {
            delta_d: self.delta_d.scaled(share),
            delta_phi_2: self.delta_phi_2.scaled(share),
            delta_gamma: self.delta_gamma.scaled(share),
            ..self.clone()
        }
    }

    /// The state of all axes at worm angle `worm_angle` and feed `feed`; `phase` is k_0F of the flank looked at.
    pub fn state(&self, worm_angle: f64, feed: f64, phase: f64) -> GeneratingState {
        let shift = self.shift.value(feed);
        let turned =
            phase - self.threads * worm_angle + self.shift_coupling * shift + self.feed_coupling * feed;
        GeneratingState {
            worm_angle,
            work_angle: turned / self.teeth + self.delta_phi_2.value(feed),
            shift,
            feed,
            delta_d: self.delta_d.value(feed),
            delta_gamma: self.delta_gamma.value(feed),
        }
    }
}
