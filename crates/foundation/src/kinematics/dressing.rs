//! Dressing: the chain dresser -> worm of `docs/mathematics/conventions.md` and the corrected motion DK(v) along the worm
//! (`docs/mathematics/dressing.md`).

use super::{Dresser, MotionLaw, Pose, Room, Worm};
use crate::numerics::Scalar;
use std::f64::consts::TAU;

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
    /// X_SA = K_R of `docs/mathematics/conventions.md` (dresser coordinates into worm coordinates; the dresser's own rotation is
    /// immaterial).
    pub fn pose(&self) -> Pose<Worm, Dresser, T> {
        Pose::<Worm, Worm, T>::rz(-self.worm_angle)
            .then(&Pose::<Worm, Worm, T>::tz(-self.worm_shift))
            .then(&Pose::<Worm, Worm, T>::rx(-self.crossing_angle))
            .then(&Pose::<Worm, Worm, T>::tx(self.centre_distance))
            .then(&Pose::ty(-self.offset))
    }
}

impl DressingPosition {
    /// Worm and dresser each against the room: z along the worm's axis, x towards the dresser. The worm travels along its axis; its
    /// inverse before the dresser is [`DressingPosition::pose`].
    pub fn in_room(&self) -> (Pose<Room, Worm>, Pose<Room, Dresser>) {
        let worm = Pose::<Room, Room>::tz(self.worm_shift).then(&Pose::<Room, Worm>::rz(self.worm_angle));
        let dresser = Pose::<Room, Room>::rx(-self.crossing_angle)
            .then(&Pose::<Room, Room>::tx(self.centre_distance))
            .then(&Pose::<Room, Dresser>::ty(-self.offset));
        (worm, dresser)
    }

    /// The position whose [`DressingPosition::pose`] this is but for the dresser's own rotation; of the two that describe it, and
    /// among full turns, the one nearest to the worm angle `near` (rad). `None` where the dresser axis stands across the worm axis.
    pub fn of_pose(pose: &Pose<Worm, Dresser>, near: f64) -> Option<Self> {
        let axis = pose.rotation().column(2).into_owned();
        let tilted = axis.x.hypot(axis.y);
        let nearest = |angle: f64| angle - TAU * ((angle - near) / TAU).round();
        let direct = nearest(axis.x.atan2(axis.y));
        let turned = nearest((-axis.x).atan2(-axis.y));
        let (worm_angle, sine) = if tilted == 0.0 {
            (near, 0.0)
        } else if (direct - near).abs() <= (turned - near).abs() {
            (direct, tilted)
        } else {
            (turned, -tilted)
        };
        let t = Pose::<Worm, Worm>::rz(worm_angle).then(pose);
        let t = t.translation();
        let cosine = axis.z;
        if cosine.abs() < 1e-9 {
            return None;
        }
        // (d, -v_y cos g, v_y sin g - v_z).
        let offset = -t.y / cosine;
        Some(Self {
            worm_angle,
            worm_shift: offset * sine - t.z,
            crossing_angle: sine.atan2(cosine),
            centre_distance: t.x,
            offset,
        })
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pose_gives_back_its_position() {
        for (k, gamma) in [0.06, -0.03, 1e-6, 0.4].into_iter().enumerate() {
            let position = DressingPosition {
                worm_angle: -40.0 + 17.0 * k as f64,
                worm_shift: 12.5,
                crossing_angle: gamma,
                centre_distance: 150.0,
                offset: -1.25,
            };
            let (worm, dresser) = position.in_room();
            let by_room = worm.inverse().then(&dresser);
            assert!((by_room.rotation() - position.pose().rotation()).norm() < 1e-14);
            assert!((by_room.translation() - position.pose().translation()).norm() < 1e-12);
            let pose = position.pose().then(&Pose::rz(2.0));
            let back = DressingPosition::of_pose(&pose, position.worm_angle + 0.5).unwrap();
            // The worm angle follows from the direction of the dresser's axis: at 1e-6 rad only that far.
            let angle = 1e-14 / gamma.abs() + 1e-13;
            assert!((back.worm_angle - position.worm_angle).abs() < angle);
            assert!((back.crossing_angle - gamma).abs() < 1e-15);
            let moved = [
                back.worm_shift - position.worm_shift,
                back.centre_distance - position.centre_distance,
                back.offset - position.offset,
            ];
            assert!(moved.iter().all(|x| x.abs() < 200.0 * angle), "{moved:?}");
        }
    }
}
