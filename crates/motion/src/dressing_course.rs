//! The worm on the dresser: the thread runs along the dresser while it turns.

use super::grinding_course::beyond;
use super::{BodyPlace, Waypoint};
use foundation::geometry::InvoluteFlank;
use foundation::kinematics::{Dresser, DressingMotion, DressingPosition, Pose, Worm};
use machine::{Mounts, StationSpindle, ToolSpindle};
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// A dressing stroke's bodies.
#[derive(Clone, Debug)]
pub struct DressingCourse {
    /// The motion.
    pub motion: DressingMotion,
    /// Worm positions v_zS on which its corrections are given, mm; beyond them they go on straight.
    pub interval: [f64; 2],
    /// How the bodies are clamped.
    pub mounts: Mounts,
    /// Places where the dresser touches the worm at v_zS = 0: point (mm) and normal, in worm coordinates. Along the stroke they go
    /// round with the thread.
    pub contacts: Vec<(Vector3<f64>, Vector3<f64>)>,
}

/// Places of a flank in which a dresser whose worm stands at `worm_angle` (rad) touches some lengths of roll (mm): where the flank
/// crosses the plane through the worm axis on the dresser's side. Point and normal in worm coordinates.
pub fn dresser_contacts(
    flank: &InvoluteFlank,
    worm_angle: f64,
    rolls: &[f64],
) -> Vec<(Vector3<f64>, Vector3<f64>)> {
    let pitch = TAU / flank.teeth;
    let lead = flank.base_radius / flank.base_helix_angle.tan();
    rolls
        .iter()
        .map(|&w| {
            let p = flank.point(w, 0.0);
            // Along the helix the point turns by z/lead; the dresser stands in the direction of -worm_angle. Any thread will do.
            let apart = -worm_angle - p.y.atan2(p.x);
            let z = (apart - pitch * (apart / pitch).round()) * lead;
            (flank.point(w, z), flank.normal(w, z))
        })
        .collect()
}

impl DressingCourse {
    /// Position of the bodies at a place.
    fn position(&self, at: &Waypoint) -> DressingPosition {
        let [phi, gamma, d, v_y] =
            [0, 1, 2, 3].map(|j| beyond(&self.motion.correction[j], self.interval, at.v));
        let chain = &self.motion.chain;
        DressingPosition {
            worm_angle: phi + at.v / chain.screw_parameter + chain.worm_angle + at.lead,
            worm_shift: at.v,
            crossing_angle: gamma + chain.crossing_angle,
            centre_distance: d + chain.centre_distance + at.lift,
            offset: v_y + chain.offset,
        }
    }

    pub(super) fn place(&self, at: &Waypoint) -> BodyPlace {
        BodyPlace::of_dressing(&self.mounts, &self.position(at))
    }

    pub(super) fn off(&self, pose: &Pose<ToolSpindle, StationSpindle>, near: &Waypoint) -> Option<f64> {
        let bodies: Pose<Worm, Dresser> = self.mounts.bodies(pose);
        let is = DressingPosition::of_pose(&bodies, self.position(near).worm_angle)?;
        let wanted = self.position(&Waypoint { v: is.worm_shift, ..*near });
        // How the dresser stands off its place, in worm coordinates: its own rotation is in neither pose.
        let moved = is.pose().then(&wanted.pose().inverse());
        let here = Pose::<Worm, Worm>::rz(-is.worm_shift / self.motion.chain.screw_parameter).then(&Pose::<
            Worm,
            Worm,
        >::tz(
            -is.worm_shift,
        ));
        let left = |(point, normal): &(Vector3<f64>, Vector3<f64>)| {
            let p = here.rotation() * point + here.translation();
            let n = here.rotation() * normal;
            n.dot(&(moved.rotation() * p + moved.translation() - p)).abs()
        };
        Some(self.contacts.iter().map(left).fold(0.0, f64::max))
    }
}
