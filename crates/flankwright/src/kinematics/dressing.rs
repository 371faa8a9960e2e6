//! Dressing: the chain dresser -> worm of spec 00 and the corrected motion DK(v) along the worm (spec 30).

use super::{Dresser, MotionLaw, Pose, Worm};
use crate::numerics::Scalar;

/// A dressing correction vector DK = (d_phi_S, d_gamma, d_d, d_v_yA): rad, rad, mm, mm.
pub type DressingCorrection = [f64; 4];

/// Nominal kinematics of dressing and the screw coupling. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DressingChain {
    /// phi_S0 at v_zS = 0.
    pub worm_angle: f64,
    /// Crossing angle gamma_A0.
    pub crossing_angle: f64,
    /// Centre distance d_A0.
    pub centre_distance: f64,
    /// Tangential offset v_yA0.
    pub offset: f64,
    /// Screw parameter p of the worm, mm/rad, signed by the hand.
    pub screw_parameter: f64,
}

/// Where dresser and worm stand at one instant; with dual numbers also their velocities.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DressingPosition<T: Scalar = f64> {
    /// Worm angle phi_S, rad.
    pub worm_angle: T,
    /// Axial position of the worm v_zS, mm.
    pub worm_shift: T,
    /// Crossing angle gamma_A, rad.
    pub crossing_angle: T,
    /// Centre distance d_A, mm.
    pub centre_distance: T,
    /// Tangential offset v_yA, mm.
    pub offset: T,
}

impl<T: Scalar> DressingPosition<T> {
    /// X_SA = K_R of spec 00 (dresser coordinates into worm coordinates; the dresser's own rotation is immaterial).
    pub fn pose(&self) -> Pose<Worm, Dresser, T> {
        Pose::<Worm, Worm, T>::rz(-self.worm_angle)
            .then(&Pose::<Worm, Worm, T>::tz(-self.worm_shift))
            .then(&Pose::<Worm, Worm, T>::rx(-self.crossing_angle))
            .then(&Pose::<Worm, Worm, T>::tx(self.centre_distance))
            .then(&Pose::ty(-self.offset))
    }
}

/// The dressing motion: nominal kinematics plus DK as functions of the worm position v = v_zS.
#[derive(Clone, Debug, PartialEq)]
pub struct DressingMotion {
    /// Nominal kinematics.
    pub chain: DressingChain,
    /// d_phi_S, d_gamma, d_d, d_v_yA over v: rad, rad, mm, mm.
    pub correction: [MotionLaw; 4],
}

impl DressingMotion {
    /// Constant corrections (the same DK along the whole worm).
    pub fn constant(chain: DressingChain, dk: DressingCorrection) -> Self {
        Self { chain, correction: dk.map(|x| MotionLaw::polynomial(0.0, vec![x])) }
    }

    /// DK at v.
    pub fn correction_at(&self, v: f64) -> DressingCorrection {
        [0, 1, 2, 3].map(|j| self.correction[j].value(v))
    }

    /// Position of worm and dresser at v. A dual argument gives the velocities along with it.
    pub fn position<T: Scalar>(&self, v: T) -> DressingPosition<T> {
        let [phi, gamma, d, v_y] = [0, 1, 2, 3].map(|j| self.correction[j].lifted(v)[0]);
        DressingPosition {
            worm_angle: phi + v / self.chain.screw_parameter + self.chain.worm_angle,
            worm_shift: v,
            crossing_angle: gamma + self.chain.crossing_angle,
            centre_distance: d + self.chain.centre_distance,
            offset: v_y + self.chain.offset,
        }
    }
}
