//! What two bodies do against each other in a stroke, and how far a pose of the machine is off it on the flank: the worm on the
//! workpiece, the worm on the dresser. The disc on one line of the worm is in `line_course`.

use super::LineCourse;
use super::waypoint::{BodyPlace, Waypoint};
use foundation::geometry::InvoluteFlank;
use foundation::kinematics::{
    Dresser, DressingMotion, DressingPosition, GeneratingMotion, GeneratingState, MotionLaw, Pose, Workpiece,
    Worm,
};
use machine::{Mounts, Station, StationSpindle, ToolSpindle};
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// The motion of the bodies in a stroke.
#[derive(Clone, Debug)]
pub enum Course {
    /// Worm on workpiece.
    Grinding(GrindingCourse),
    /// Worm on dresser.
    Dressing(DressingCourse),
    /// Worm on a disc that writes one line of it.
    Line(LineCourse),
}

impl Course {
    /// Where it happens.
    pub fn station(&self) -> Station {
        match self {
            Self::Grinding(_) => Station::Work,
            Self::Dressing(_) | Self::Line(_) => Station::Dresser,
        }
    }

    /// How the bodies are clamped.
    pub fn mounts(&self) -> &Mounts {
        match self {
            Self::Grinding(course) => &course.mounts,
            Self::Dressing(course) => &course.mounts,
            Self::Line(course) => &course.mounts,
        }
    }

    /// Where the spindles are wanted.
    pub fn place(&self, at: &Waypoint) -> BodyPlace {
        match self {
            Self::Grinding(course) => course.place(at),
            Self::Dressing(course) => course.place(at),
            Self::Line(course) => course.place(at),
        }
    }

    /// Bound of the deviation (mm, normal) that a pose leaves on the flank against the course at its own place on it; `near` is a
    /// place nearby. `None` for a pose of other bodies.
    pub fn off(&self, pose: &Pose<ToolSpindle, StationSpindle>, near: &Waypoint) -> Option<f64> {
        match self {
            Self::Grinding(course) => course.off(pose, near),
            Self::Dressing(course) => course.off(pose, near),
            Self::Line(course) => course.off(pose, near),
        }
    }
}

/// The worm on the workpiece: the coupled motion of generating grinding at a constant ratio of worm speed and feed.
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

    fn place(&self, at: &Waypoint) -> BodyPlace {
        let state = self.state(at);
        BodyPlace {
            pose: self.mounts.spindles(&self.motion.chain.pose(&state)),
            angles: [state.worm_angle, state.work_angle],
        }
    }

    fn off(&self, pose: &Pose<ToolSpindle, StationSpindle>, near: &Waypoint) -> Option<f64> {
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

/// The worm on the dresser: the thread runs along the dresser while it turns.
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

    fn place(&self, at: &Waypoint) -> BodyPlace {
        BodyPlace::of_dressing(&self.mounts, &self.position(at))
    }

    fn off(&self, pose: &Pose<ToolSpindle, StationSpindle>, near: &Waypoint) -> Option<f64> {
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

/// The value of a law that goes on straight beyond an interval, as programs drive it.
pub fn beyond(law: &MotionLaw, [from, to]: [f64; 2], v: f64) -> f64 {
    let at = v.clamp(from, to);
    let [value, slope, _] = law.jet(at);
    value + slope * (v - at)
}
