//! Generating grinding: the chain workpiece -> worm of spec 00 and the coupled motion of its axes (spec 20 sections 4, 14).

use super::{MotionLaw, Pose, Workpiece, Worm};
use crate::geometry::Sides;
use crate::numerics::Scalar;

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

/// Angles and feeds at one instant; with dual numbers also their velocities.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GeneratingState<T: Scalar = f64> {
    /// Worm rotation phi_1, rad.
    pub worm_angle: T,
    /// Workpiece rotation phi_2, rad.
    pub work_angle: T,
    /// Tool shift z_V1, mm.
    pub shift: T,
    /// Axial feed of the workpiece z_V2, mm.
    pub feed: T,
    /// Added to the centre distance, mm.
    pub delta_d: T,
    /// Added to the crossed-axes angle, rad.
    pub delta_gamma: T,
}

impl GeneratingChain {
    /// X_SV = K_R of spec 00 at the given state.
    pub fn pose<T: Scalar>(&self, state: &GeneratingState<T>) -> Pose<Worm, Workpiece, T> {
        let constant = |x: f64| T::from(x);
        let head = Pose::<Worm, Worm, T>::rz(-state.worm_angle)
            .then(&Pose::<Worm, Worm, T>::ty(constant(self.worm_pivot)))
            .then(&Pose::<Worm, Worm, T>::rx(constant(self.worm_cone)))
            .then(&Pose::<Worm, Worm, T>::tz(-state.shift))
            .then(&Pose::<Worm, Worm, T>::ty(state.delta_d + self.centre_distance))
            .then(&Pose::<Worm, Worm, T>::ry(state.delta_gamma + self.crossed_axes_angle));
        let tail = Pose::<Worm, Workpiece, T>::tz(state.feed)
            .then(&Pose::<Workpiece, Workpiece, T>::rx(constant(-self.work_cone)))
            .then(&Pose::<Workpiece, Workpiece, T>::ty(constant(-self.work_pivot)))
            .then(&Pose::<Workpiece, Workpiece, T>::rz(state.work_angle));
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

    /// The state of all axes at worm angle `worm_angle` (rad) and feed `feed` (mm); `phase` is k_0F of the flank looked
    /// at. Dual arguments give the velocities along with it.
    pub fn state<T: Scalar>(&self, worm_angle: T, feed: T, phase: f64) -> GeneratingState<T> {
        let [shift, _] = self.shift.lifted(feed);
        let turned =
            -worm_angle * self.threads + phase + shift * self.shift_coupling + feed * self.feed_coupling;
        GeneratingState {
            worm_angle,
            work_angle: turned / self.teeth + self.delta_phi_2.lifted(feed)[0],
            shift,
            feed,
            delta_d: self.delta_d.lifted(feed)[0],
            delta_gamma: self.delta_gamma.lifted(feed)[0],
        }
    }
}
