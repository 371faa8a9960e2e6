//! Generating grinding: the chain workpiece -> worm of `docs/mathematics/conventions.md` and the coupled motion of its axes
//! (`docs/mathematics/generating-contact.md`).

use super::{MotionLaw, Pose, Room, Workpiece, Worm};
use crate::geometry::Sides;
use crate::numerics::Scalar;
use std::f64::consts::TAU;

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
    /// X_SV = K_R of `docs/mathematics/conventions.md` at the given state.
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

impl GeneratingChain {
    /// Worm and workpiece each against the room: z along the worm's unturned axis, y towards the workpiece. The worm shifts along its
    /// axis, the workpiece feeds along its own; the worm's inverse before the workpiece is [`GeneratingChain::pose`].
    pub fn in_room(&self, state: &GeneratingState) -> (Pose<Room, Worm>, Pose<Room, Workpiece>) {
        let worm = Pose::<Room, Room>::tz(state.shift)
            .then(&Pose::<Room, Room>::rx(-self.worm_cone))
            .then(&Pose::<Room, Room>::ty(-self.worm_pivot))
            .then(&Pose::<Room, Worm>::rz(state.worm_angle));
        let work = Pose::<Room, Room>::ty(state.delta_d + self.centre_distance)
            .then(&Pose::<Room, Room>::ry(state.delta_gamma + self.crossed_axes_angle))
            .then(&Pose::<Room, Workpiece>::tz(state.feed))
            .then(&Pose::<Workpiece, Workpiece>::rx(-self.work_cone))
            .then(&Pose::<Workpiece, Workpiece>::ty(-self.work_pivot))
            .then(&Pose::<Workpiece, Workpiece>::rz(state.work_angle));
        (worm, work)
    }

    /// The state at which [`GeneratingChain::pose`] gives this pose: of the two that the rotation admits, and among full turns, the
    /// one nearest to `near`. `None` where the axes are parallel, or for a pose that these pivots and cones do not reach.
    pub fn state_of(&self, pose: &Pose<Worm, Workpiece>, near: &GeneratingState) -> Option<GeneratingState> {
        let r = pose.rotation();
        let (sin_1, cos_1) = self.worm_cone.sin_cos();
        let (sin_2, cos_2) = self.work_cone.sin_cos();
        // e_z . Rx(theta_1) Ry(gamma) Rx(-theta_2) e_z = cos th1 cos th2 cos gamma + sin th1 sin th2.
        let cosine = (r[(2, 2)] - sin_1 * sin_2) / (cos_1 * cos_2);
        let wanted = self.crossed_axes_angle + near.delta_gamma;
        let gamma = if cos_1 == 1.0 && cos_2 == 1.0 {
            // The sine is at hand where the cosine loses it.
            r[(0, 2)].hypot(r[(1, 2)]).atan2(r[(2, 2)])
        } else if cosine.abs() <= 1.0 {
            cosine.acos()
        } else {
            return None;
        };
        let gamma = if wanted < 0.0 { -gamma } else { gamma };
        let head = Pose::<Worm, Worm>::rx(self.worm_cone).then(&Pose::<Worm, Worm>::ry(gamma));
        let core = head.then(&Pose::<Worm, Workpiece>::rx(-self.work_cone));
        // Rz(phi_1) R = core Rz(phi_2): the last columns give phi_1, the last rows phi_2.
        let (a, b) = (core.rotation(), r);
        let worm = a[(1, 2)].atan2(a[(0, 2)]) - b[(1, 2)].atan2(b[(0, 2)]);
        let work = a[(2, 1)].atan2(a[(2, 0)]) - b[(2, 1)].atan2(b[(2, 0)]);
        let nearest = |angle: f64, to: f64| angle - TAU * ((angle - to) / TAU).round();
        // R = Rz(-phi_1) core Rz(phi_2): angles of the last column of core less those of R give +phi_1; the last row of R is that of
        // core turned by -phi_2.
        let worm_angle = nearest(worm, near.worm_angle);
        let work_angle = nearest(work, near.work_angle);
        let turned = Pose::<Worm, Worm>::rz(worm_angle).then(pose);
        // Translation of the chain: p_1 + Rx(th1) (-z_V1 e_z + d e_y) + head e_z z_V2 + core (0, -p_2, 0), linear in z_V1, d, z_V2.
        let pivots = nalgebra::Vector3::new(0.0, self.worm_pivot, 0.0)
            + core.rotation() * nalgebra::Vector3::new(0.0, -self.work_pivot, 0.0);
        let tilted = Pose::<Worm, Worm>::rx(self.worm_cone);
        let columns = nalgebra::Matrix3::from_columns(&[
            tilted.rotation() * -nalgebra::Vector3::z(),
            tilted.rotation() * nalgebra::Vector3::y(),
            head.rotation() * nalgebra::Vector3::z(),
        ]);
        let [shift, distance, feed]: [f64; 3] = columns.lu().solve(&(turned.translation() - pivots))?.into();
        let state = GeneratingState {
            worm_angle,
            work_angle,
            shift,
            feed,
            delta_d: distance - self.centre_distance,
            delta_gamma: gamma - self.crossed_axes_angle,
        };
        [shift, distance, feed, worm_angle, work_angle, gamma].iter().all(|x| x.is_finite()).then_some(state)
    }
}

/// The motion of grinding as functions of the feed v = z_V2 (`docs/mathematics/generating-contact.md#exact-contact`), with the coupling of
/// the rotations.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pose_gives_back_its_state() {
        let chains =
            [(0.0, 0.0, 0.0, 0.0, 2.0), (-0.05, 0.0, 120.0, 0.0, -1.2), (0.04, -0.1, 90.0, 41.0, 1.9)];
        for (worm_cone, work_cone, worm_pivot, work_pivot, crossed_axes_angle) in chains {
            let chain = GeneratingChain {
                centre_distance: 150.0,
                crossed_axes_angle,
                worm_cone,
                work_cone,
                worm_pivot,
                work_pivot,
            };
            for k in 0..20 {
                let x = f64::from(k);
                let state = GeneratingState {
                    worm_angle: 3.7 * x - 20.0,
                    work_angle: -1.3 * x + 5.0,
                    shift: 4.0 * x - 30.0,
                    feed: 12.0 - x,
                    delta_d: 0.01 * x,
                    delta_gamma: 0.001 * (x - 10.0),
                };
                let near = GeneratingState {
                    worm_angle: state.worm_angle + 1.0,
                    work_angle: state.work_angle - 2.0,
                    ..GeneratingState {
                        shift: 0.0,
                        feed: 0.0,
                        delta_d: 0.0,
                        delta_gamma: 0.0,
                        worm_angle: 0.0,
                        work_angle: 0.0,
                    }
                };
                let (worm, work) = chain.in_room(&state);
                let (by_room, pose) = (worm.inverse().then(&work), chain.pose(&state));
                assert!((by_room.rotation() - pose.rotation()).norm() < 1e-14);
                assert!((by_room.translation() - pose.translation()).norm() < 1e-12);
                let back = chain.state_of(&chain.pose(&state), &near).unwrap();
                for (a, b) in [
                    (back.worm_angle, state.worm_angle),
                    (back.work_angle, state.work_angle),
                    (back.shift, state.shift),
                    (back.feed, state.feed),
                    (back.delta_d, state.delta_d),
                    (back.delta_gamma, state.delta_gamma),
                ] {
                    assert!((a - b).abs() < 2e-12 * (1.0 + b.abs()), "{state:?} {back:?}");
                }
            }
        }
    }
}
