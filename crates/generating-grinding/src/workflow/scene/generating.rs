//! The stage of generating: worm and gear over the feed, both turning, with the points in which they touch at that moment and the lines
//! that one turn of contact leaves on the flanks. Knows no dresser.

use super::dressing::{PARKED, Parked};
use contact::{ContactSolution, FlankPair, Pair};
use foundation::geometry::Flank;
use foundation::kinematics::{GeneratingMotion, GeneratingState, Pose, Room};
use foundation::numerics::equidistant;
use nalgebra::Vector3;
use scene::{Coordinate, Frame, Stage, numbers, place};
use std::f64::consts::TAU;

/// Frames of a stage.
const FRAMES: usize = 121;
/// The worm turns so far from frame to frame: an eighth of a thread, at most 15 deg.
const PER_THREAD: f64 = 8.0;
const LARGEST_TURN: f64 = TAU / 24.0;
/// Rounds in which a contact is brought to its moment, and what it may miss: rad and mm.
const ROUNDS: usize = 12;
const SETTLED: [f64; 2] = [1e-9, 1e-7];
/// Contacts are looked for this share of the profile beside it: modifications move them.
const BESIDE: f64 = 0.1;
/// Points of a line on a flank.
const LINE: usize = 9;

/// The exact contact of a place (w, z) of the gear's flank; `None` where the tool leaves nothing.
pub type Solver<'a> = Box<dyn Fn(f64, f64) -> Option<ContactSolution> + 'a>;

/// A flank that is ground.
pub struct ShownFlank<'a> {
    /// The flank.
    pub flank: Flank,
    /// Lengths of roll and axial positions on the gear, mm.
    pub roll: [f64; 2],
    /// Axial positions from and to, mm.
    pub face: [f64; 2],
    /// Finds its contacts.
    pub solve: &'a Solver<'a>,
}

/// A stroke to be shown.
pub struct ShownGenerating<'a> {
    /// Its identifier.
    pub id: String,
    /// Its name.
    pub title: String,
    /// Worm and gear.
    pub pair: &'a Pair,
    /// How they move.
    pub motion: &'a GeneratingMotion,
    /// z_V2 from where to where, mm.
    pub feed: [f64; 2],
    /// Flanks that are ground.
    pub flanks: Vec<ShownFlank<'a>>,
}

impl ShownGenerating<'_> {
    /// The stage, with the bodies that stand aside.
    pub fn stage(&self, parked: &[Parked]) -> Stage {
        let step = (TAU / (PER_THREAD * self.motion.threads)).min(LARGEST_TURN);
        let feeds = equidistant(self.feed, FRAMES);
        let frame = |(number, feed): (usize, f64)| self.frame(step * number as f64, feed, parked);
        Stage {
            id: self.id.clone(),
            title: self.title.clone(),
            coordinate: Coordinate { label: "axial feed z_V2", unit: "mm" },
            frames: feeds.into_iter().enumerate().map(frame).collect(),
        }
    }

    /// Where the gear stands while the worm is dressed: drawn back from the first frame along y.
    pub fn parked_gear(&self, depth: f64) -> [f64; 12] {
        let (_, gear) = self.motion.chain.in_room(&self.state(0.0, self.feed[0]));
        numbers(&Pose::<Room, Room>::ty(PARKED + depth).then(&gear))
    }

    fn state(&self, worm_angle: f64, feed: f64) -> GeneratingState {
        let flank = self.flanks.first().map_or(Flank::Left, |shown| shown.flank);
        self.motion.state(worm_angle, feed, self.motion.phase[flank])
    }

    fn frame(&self, worm_angle: f64, feed: f64, parked: &[Parked]) -> Frame {
        let state = self.state(worm_angle, feed);
        let (worm, gear) = self.motion.chain.in_room(&state);
        let mut frame = Frame::new(feed, [("worm", numbers(&worm)), ("gear", numbers(&gear))]);
        frame.poses.extend(parked.iter().cloned());
        for shown in &self.flanks {
            frame.contact.extend(self.touching(shown, worm_angle, feed).iter().map(place));
            let line = self.line(shown, &state);
            if line.len() > 1 {
                frame.trace.push(line.iter().map(place).collect());
            }
        }
        frame
    }

    /// The points of one flank that touch at a worm angle and feed, in coordinates of the room: one for each thread in mesh.
    fn touching(&self, shown: &ShownFlank<'_>, worm_angle: f64, feed: f64) -> Vec<Vector3<f64>> {
        let turn = TAU / self.motion.threads;
        let ends = shown.roll.map(|w| self.nominal_angle(shown.flank, w, feed));
        let beside = BESIDE * (ends[1] - ends[0]).abs();
        let (low, high) = (ends[0].min(ends[1]) - beside, ends[0].max(ends[1]) + beside);
        let (first, last) =
            (((low - worm_angle) / turn).ceil() as i64, ((high - worm_angle) / turn).floor() as i64);
        (first..=last)
            .filter_map(|thread| self.settled(shown, [worm_angle + turn * thread as f64, feed]))
            .collect()
    }

    /// The contact of a flank at a worm angle and a feed: the unmodified one, moved until the exact contact happens at that moment.
    fn settled(&self, shown: &ShownFlank<'_>, moment: [f64; 2]) -> Option<Vector3<f64>> {
        let mut nominal = moment;
        for _ in 0..ROUNDS {
            let (w, z) = self.nominal_place(shown, nominal);
            let found = (shown.solve)(w, z)?;
            let miss = [moment[0] - found.worm_angle, moment[1] - found.feed];
            if miss[0].abs() <= SETTLED[0] && miss[1].abs() <= SETTLED[1] {
                let within = |x: f64, [from, to]: [f64; 2]| (from..=to).contains(&x);
                let seen = within(w, shown.roll) && within(z, shown.face);
                return seen.then(|| self.in_room(shown.flank, (w, z), &found));
            }
            nominal = [nominal[0] + miss[0], nominal[1] + miss[1]];
        }
        None
    }

    fn flank_pair(&self, flank: Flank) -> &FlankPair {
        &self.pair.flanks[flank]
    }

    /// phi_1 at which a length of roll of the unmodified flank touches at a feed.
    fn nominal_angle(&self, flank: Flank, w: f64, feed: f64) -> f64 {
        let (pair, shift) = (self.flank_pair(flank), self.motion.shift.value(feed));
        let w_1 = pair.worm_roll(w, shift, feed);
        pair.worm_angle(w_1, pair.worm_z(w_1, shift, feed))
    }

    /// The place of the unmodified flank that touches at [phi_1, z_V2]: the angle is linear in the length of roll.
    fn nominal_place(&self, shown: &ShownFlank<'_>, [worm_angle, feed]: [f64; 2]) -> (f64, f64) {
        let [from, to] = shown.roll.map(|w| self.nominal_angle(shown.flank, w, feed));
        let share = (worm_angle - from) / (to - from);
        let w = shown.roll[0] + share * (shown.roll[1] - shown.roll[0]);
        (w, self.flank_pair(shown.flank).work_z(w, self.motion.shift.value(feed), feed))
    }

    /// A contact in coordinates of the room.
    fn in_room(&self, flank: Flank, (w, z): (f64, f64), found: &ContactSolution) -> Vector3<f64> {
        let pair = self.flank_pair(flank);
        let mut state = self.motion.state(found.worm_angle, found.feed, self.motion.phase[flank]);
        state.work_angle = self.nearest_space(state.work_angle, pair.work_angle(w, z));
        let (_, gear) = self.motion.chain.in_room(&state);
        let point = pair.work.point(w, z) + pair.work.normal(w, z) * found.f_n;
        gear.rotation() * point + gear.translation()
    }

    /// The angle of the gear turned by whole pitches next to another one.
    fn nearest_space(&self, angle: f64, to: f64) -> f64 {
        let pitch = TAU / self.motion.teeth;
        angle + ((to - angle) / pitch).round() * pitch
    }

    /// The line of a flank that is ground at the feed of a state, on the tooth that stands in the worm, in coordinates of the room.
    fn line(&self, shown: &ShownFlank<'_>, state: &GeneratingState) -> Vec<Vector3<f64>> {
        let pair = self.flank_pair(shown.flank);
        let [from, to] = shown.roll;
        let z_of = |w: f64| pair.work_z(w, state.shift, state.feed);
        let middle = 0.5 * (from + to);
        let work_angle = self.nearest_space(state.work_angle, pair.work_angle(middle, z_of(middle)));
        let (_, gear) = self.motion.chain.in_room(&GeneratingState { work_angle, ..*state });
        let Some(ends) = clipped(shown.roll, [z_of(from), z_of(to)], shown.face) else { return Vec::new() };
        let point = |w: f64| gear.rotation() * pair.work.point(w, z_of(w)) + gear.translation();
        equidistant(ends, LINE).into_iter().map(point).collect()
    }
}

/// The part of an interval in which a linear function with these values at its ends lies between limits.
fn clipped([from, to]: [f64; 2], [at_from, at_to]: [f64; 2], [least, most]: [f64; 2]) -> Option<[f64; 2]> {
    let (mut first, mut last) = (0.0f64, 1.0f64);
    let rise = at_to - at_from;
    if rise == 0.0 {
        return (least..=most).contains(&at_from).then_some([from, to]);
    }
    let crossings = [(least - at_from) / rise, (most - at_from) / rise];
    first = first.max(crossings[0].min(crossings[1]));
    last = last.min(crossings[0].max(crossings[1]));
    (first < last).then(|| [first, last].map(|share| from + share * (to - from)))
}
