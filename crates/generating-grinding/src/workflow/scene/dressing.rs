//! The stage of dressing: worm and dresser along a dressing motion, with the line in which they touch. Knows no gear.

use foundation::kinematics::{Dresser, DressingMotion, DressingPosition, Pose, Room};
use foundation::numerics::equidistant;
use nalgebra::Vector3;
use scene::{Coordinate, Frame, Stage, numbers, place};
use std::f64::consts::TAU;

/// Frames of a stage at least and at most, and frames for a turn of the worm.
const FRAMES: [usize; 2] = [61, 181];
const FRAMES_PER_TURN: f64 = 24.0;
/// What takes no part in a stage is drawn back by this and the depth of the worm's threads, mm.
pub const PARKED: f64 = 30.0;
/// What stages of dressing are counted by.
pub const WORM_POSITION: Coordinate = Coordinate { label: "worm position v_zS", unit: "mm" };

/// The worm as far as it is there. mm.
#[derive(Clone, Copy, Debug)]
pub struct WormExtent {
    /// Radii of root and tip at z = 0.
    pub radii: [f64; 2],
    /// What they fall by along the axis, mm/mm.
    pub slope: f64,
    /// Axial positions of the faces.
    pub faces: [f64; 2],
}

/// A dressing motion to be shown.
pub struct ShownDressing<'a> {
    /// Its identifier.
    pub id: String,
    /// Its name.
    pub title: String,
    /// The motion of the dresser.
    pub motion: &'a DressingMotion,
    /// Worm positions v_zS from where to where, mm.
    pub driven: [f64; 2],
    /// The dresser's body.
    pub dresser: &'a str,
    /// How far the body stands along the dresser's axis from the coordinates of the motion, mm.
    pub offset: f64,
    /// Points in which dresser and worm touch at a worm position, in coordinates of the worm, from root to tip or back.
    pub line: &'a dyn Fn(f64) -> Vec<Vector3<f64>>,
}

/// A body that stands aside.
pub type Parked = (String, [f64; 12]);

impl WormExtent {
    /// Whether a point in coordinates of the worm lies on it.
    pub fn holds(&self, point: &Vector3<f64>) -> bool {
        let radius = point.xy().norm() + self.slope * point.z;
        let within = |x: f64, [from, to]: [f64; 2]| (from..=to).contains(&x);
        within(radius, self.radii) && within(point.z, self.faces)
    }
}

impl ShownDressing<'_> {
    /// The stage, with the bodies that stand aside.
    pub fn stage(&self, extent: &WormExtent, parked: &[Parked]) -> Stage {
        let count = dressing_frames(self.driven, self.motion.chain.screw_parameter);
        let frame = |v: f64| {
            let position = self.motion.position(v);
            let contact: Vec<Vector3<f64>> =
                (self.line)(v).into_iter().filter(|point| extent.holds(point)).collect();
            dressing_frame(v, &position, (self.dresser, self.offset), &contact, parked)
        };
        Stage {
            id: self.id.clone(),
            title: self.title.clone(),
            coordinate: WORM_POSITION,
            frames: equidistant(self.driven, count).into_iter().map(frame).collect(),
        }
    }
}

/// Frames of a stroke from one worm position to another on a worm of this screw parameter, mm and mm/rad.
pub fn dressing_frames([from, to]: [f64; 2], screw_parameter: f64) -> usize {
    let turns = ((to - from) / (TAU * screw_parameter)).abs();
    ((turns * FRAMES_PER_TURN).ceil() as usize + 1).clamp(FRAMES[0], FRAMES[1])
}

/// Worm and dresser at a position; `contact` in coordinates of the worm.
pub fn dressing_frame(
    at: f64,
    position: &DressingPosition,
    (dresser, offset): (&str, f64),
    contact: &[Vector3<f64>],
    parked: &[Parked],
) -> Frame {
    let (worm, stand) = position.in_room();
    let body = stand.then(&Pose::<Dresser, Dresser>::tz(offset));
    let mut frame = Frame::new(at, [("worm", numbers(&worm)), (dresser, numbers(&body))]);
    frame.poses.extend(parked.iter().filter(|(id, _)| id != dresser).cloned());
    let in_room = |point: &Vector3<f64>| place(&(worm.rotation() * point + worm.translation()));
    frame.contact = contact.iter().map(in_room).collect();
    frame
}

/// Where a dresser stands while it does not dress: drawn back from its position along x.
pub fn parked_dresser(position: &DressingPosition, depth: f64) -> [f64; 12] {
    let (_, stand) = position.in_room();
    numbers(&Pose::<Room, Room>::tx(PARKED + depth).then(&stand))
}
