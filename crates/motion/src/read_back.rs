//! From a program back to the motions of the bodies: blocks -> axis positions -> forward kinematics -> laws over the path parameter.
//! Shares no formula with the way in which the program was made: it knows the machine, the mounts and the bodies' chains, no plan.

use super::{AxisWords, MotionError, SCurve};
use foundation::kinematics::{
    Dresser, DressingChain, DressingMotion, DressingPosition, GeneratingMotion, GeneratingState, MotionLaw,
    Pose, Workpiece, Worm,
};
use machine::{AxisLimits, Machine, Mounts, Positions, Role, Station};
use nc::{Block, Coupling, CurveTable, Gear, GearSynchronisation, Targets};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

mod places;

pub use places::DressingPlace;

/// A block that interpolates, between two positions.
#[derive(Clone, Debug)]
struct Segment {
    /// Block, from 1.
    block: usize,
    from: Positions,
    to: Positions,
    /// Time, s.
    duration: f64,
    /// The follower of a gear that is on: its number in the machine and the gear.
    gear: Option<(usize, Engaged)>,
}

/// A gear that is on.
#[derive(Clone, Debug)]
struct Engaged {
    /// Leaders: number in the machine, sense in which the control counts, coupling.
    leaders: Vec<(usize, f64, Coupled)>,
    /// Sense of the follower.
    sense: f64,
    /// Follower and leaders where it was switched on, as the machine counts.
    at: (f64, Vec<f64>),
}

#[derive(Clone, Debug)]
enum Coupled {
    Ratio(f64),
    Table(Box<CurveTable>),
}

impl Engaged {
    fn follower(&self, at: &Positions) -> f64 {
        let mut moved = 0.0;
        for ((axis, sense, coupled), begun) in self.leaders.iter().zip(&self.at.1) {
            let (now, then) = (sense * at[*axis], sense * begun);
            moved += match coupled {
                Coupled::Ratio(ratio) => ratio * (now - then),
                Coupled::Table(table) => table.value(now) - table.value(then),
            };
        }
        self.at.0 + self.sense * moved
    }
}

/// What a program does to the axes.
#[derive(Clone, Debug)]
pub struct Tracked {
    /// Blocks that interpolate, chains that no rapid move interrupts.
    chains: Vec<Vec<Segment>>,
    /// Rapid moves between known places: block, from 1, and its ends.
    rapids: Vec<(usize, [Positions; 2])>,
    /// Range of every axis over the program, mm or rad; `None` for one that is not named.
    pub ranges: Vec<Option<[f64; 2]>>,
    /// Whole way of every axis, mm or rad.
    pub ways: Vec<f64>,
    /// Greatest speed of every axis in blocks that state a time, mm/s or rad/s.
    pub speeds: Vec<f64>,
    /// Time of all blocks, s: stated, or of rapid moves under the limits of the axes.
    pub duration: f64,
}

/// A stroke of a program: its motion and where it stands in the text.
#[derive(Clone, Debug)]
pub struct ReadStroke<M> {
    /// Motion of the bodies.
    pub motion: M,
    /// Path parameter from where to where, ascending, mm.
    pub range: [f64; 2],
    /// Pitches by which the workpiece stands off its coupling in the sense of the coupling's phase; 0 for dressing.
    pub index: i64,
    /// First and last block, from 1.
    pub blocks: [usize; 2],
    /// Time, s.
    pub duration: f64,
}

/// Follows the blocks of a program from `start`, where axes that it does not name stand.
///
/// # Errors
/// [`MotionError::NotFollowed`] for a block that moves an axis whose place is not known, or a gear without one.
pub fn track(
    blocks: &[Block],
    machine: &Machine,
    words: &AxisWords,
    start: &Positions,
) -> Result<Tracked, MotionError> {
    let mut walk = Walk {
        machine,
        words,
        at: *start,
        tables: BTreeMap::new(),
        gears: BTreeMap::new(),
        engaged: None,
        speeds: BTreeMap::new(),
        tracked: Tracked {
            chains: Vec::new(),
            rapids: Vec::new(),
            ranges: vec![None; machine.axes().len()],
            ways: vec![0.0; machine.axes().len()],
            speeds: vec![0.0; machine.axes().len()],
            duration: 0.0,
        },
        placed: vec![false; machine.axes().len()],
        open: false,
    };
    for (k, block) in blocks.iter().enumerate() {
        walk.block(k + 1, block)?;
    }
    Ok(walk.tracked)
}

struct Walk<'a> {
    machine: &'a Machine,
    words: &'a AxisWords,
    at: Positions,
    tables: BTreeMap<u32, CurveTable>,
    gears: BTreeMap<usize, Gear>,
    engaged: Option<(usize, Engaged)>,
    /// Speeds of spindles that lead, rad/s by number in the machine.
    speeds: BTreeMap<usize, f64>,
    tracked: Tracked,
    /// Whether the last chain goes on.
    open: bool,
    /// Which axes a move has placed: their first one comes from wherever they stood.
    placed: Vec<bool>,
}

/// Parts of a block with cubic motion: a cubic of mm over 64 parts is followed to below 1e-6 of its sagitta.
const PARTS: usize = 64;

impl Walk<'_> {
    fn block(&mut self, number: usize, block: &Block) -> Result<(), MotionError> {
        match block {
            Block::Rapid(target) => {
                let from = self.at;
                self.at = self.words.positions(self.machine, &from, target);
                self.follow();
                let time = |k: usize| match self.placed[k] {
                    true => rapid_time(&self.machine.axes()[k].limits, self.at[k] - from[k]),
                    false => 0.0,
                };
                let known = |&k: &usize| self.placed[k] || self.at[k] == from[k];
                if self.placed.contains(&true) && (0..self.machine.axes().len()).all(|k| known(&k)) {
                    self.tracked.rapids.push((number, [from, self.at]));
                }
                self.tracked.duration += (0..self.machine.axes().len()).map(time).fold(0.0, f64::max);
                self.add_way(&from);
                self.place(target);
                self.seen();
                self.open = false;
            }
            Block::Linear { target, duration } => {
                let to = self.words.positions(self.machine, &self.at, target);
                self.place(target);
                self.segment(number, to, *duration);
            }
            Block::Cubic(motion) => {
                let from = self.at;
                for part in 1..=PARTS {
                    let u = part as f64 / PARTS as f64;
                    let mut to = from;
                    for (word, span) in &motion.spans {
                        let Some(&axis) = self.words.numbers.get(*word) else { continue };
                        let sense = self.machine.axes()[axis].nc_sign;
                        to[axis] = sense * span.value(sense * from[axis], u);
                    }
                    self.segment(number, to, motion.duration / PARTS as f64);
                }
            }
            Block::BSpline(motion) => {
                let from = self.at;
                let (first, last) = (motion.knots.first(), motion.knots.last());
                let (Some(first), Some(last)) = (first, last) else { return Ok(()) };
                for part in 1..=PARTS {
                    let u = first + (last - first) * part as f64 / PARTS as f64;
                    let mut to = from;
                    for (word, &axis) in self.words.numbers.iter().enumerate() {
                        let sense = self.machine.axes()[axis].nc_sign;
                        if let Some(value) = motion.value(word, sense * from[axis], u) {
                            to[axis] = sense * value;
                        }
                    }
                    self.segment(number, to, motion.duration / PARTS as f64);
                }
            }
            Block::Dwell(time) => self.tracked.duration += time,
            Block::Spindle { spindle, speed } => {
                let word = nc::Word::Spindle(*spindle);
                for (known, &axis) in self.words.words.iter().zip(&self.words.numbers) {
                    if known.word == word {
                        self.placed[axis] = true;
                        self.speeds.insert(axis, speed * self.machine.axes()[axis].nc_sign);
                    }
                }
            }
            Block::Table(table) => {
                self.tables.insert(table.id, (**table).clone());
            }
            Block::GearDefine(gear) => {
                self.gears.insert(gear.follower, (**gear).clone());
            }
            Block::GearOn { follower, synchronisation } => {
                self.engage(number, *follower, synchronisation.as_deref())?;
            }
            Block::GearOff { .. } => self.engaged = None,
            Block::TipControlOn(_) | Block::TipControlOff | Block::Tip(_) | Block::TipSpeed(_) => {
                let reason =
                    "tool centre point control, which moves the axes in ways that no block says".into();
                return Err(MotionError::NotFollowed { block: number, reason });
            }
            Block::Comment(_)
            | Block::Stop
            | Block::End
            | Block::Tool { .. }
            | Block::Output { .. }
            | Block::Coolant(_) => {}
            Block::LengthOffset(_) | Block::WorkOffset(_) | Block::Probe(_) | Block::ShiftOffset(_) => {
                let reason =
                    "a length, a work offset or a probed place, whose values the program does not hold"
                        .into();
                return Err(MotionError::NotFollowed { block: number, reason });
            }
        }
        Ok(())
    }

    fn engage(
        &mut self,
        block: usize,
        follower: usize,
        synchronisation: Option<&GearSynchronisation>,
    ) -> Result<(), MotionError> {
        let not_followed = |reason: &str| MotionError::NotFollowed { block, reason: reason.into() };
        let gear = self.gears.get(&follower).ok_or_else(|| not_followed("a gear that is not defined"))?;
        let number = |word: usize| {
            self.words
                .numbers
                .get(word)
                .copied()
                .ok_or_else(|| not_followed("an axis that the machine has not"))
        };
        let sense = |axis: usize| self.machine.axes()[axis].nc_sign;
        let axis = number(follower)?;
        let mut leaders = Vec::with_capacity(gear.leaders.len());
        let mut begun = Vec::with_capacity(gear.leaders.len());
        for (k, leader) in gear.leaders.iter().enumerate() {
            let number = number(leader.axis)?;
            let coupled = match leader.coupling {
                Coupling::Ratio { num, den } => Coupled::Ratio(num / den),
                Coupling::Table(id) => Coupled::Table(Box::new(
                    self.tables.get(&id).cloned().ok_or_else(|| not_followed("a table that is not given"))?,
                )),
            };
            begun.push(match synchronisation {
                Some(at) => sense(number) * at.leaders.get(k).copied().unwrap_or(f64::NAN),
                None => self.at[number],
            });
            leaders.push((number, sense(number), coupled));
        }
        let own = synchronisation.map_or(self.at[axis], |at| sense(axis) * at.follower);
        self.placed[axis] = true;
        self.engaged = Some((axis, Engaged { leaders, sense: sense(axis), at: (own, begun) }));
        self.follow();
        Ok(())
    }

    /// The follower goes where its leaders have gone.
    fn follow(&mut self) {
        if let Some((axis, gear)) = &self.engaged {
            self.at[*axis] = gear.follower(&self.at);
        }
    }

    fn segment(&mut self, block: usize, mut to: Positions, duration: f64) {
        for (&axis, speed) in &self.speeds {
            to[axis] = self.at[axis] + speed * duration;
        }
        let from = self.at;
        self.at = to;
        self.follow();
        self.seen();
        self.add_way(&from);
        for k in 0..self.machine.axes().len() {
            let speed = (self.at[k] - from[k]).abs() / duration;
            self.tracked.speeds[k] = self.tracked.speeds[k].max(speed);
        }
        let segment = Segment { block, from, to: self.at, duration, gear: self.engaged.clone() };
        match (self.open, self.tracked.chains.last_mut()) {
            (true, Some(chain)) => chain.push(segment),
            _ => self.tracked.chains.push(vec![segment]),
        }
        self.open = true;
        self.tracked.duration += duration;
    }

    fn add_way(&mut self, from: &Positions) {
        for k in 0..self.machine.axes().len() {
            if self.placed[k] {
                self.tracked.ways[k] += (self.at[k] - from[k]).abs();
            }
        }
    }

    /// Axes that a block names stand somewhere from here on.
    fn place(&mut self, target: &Targets) {
        for (word, _) in target.iter() {
            if let Some(&axis) = self.words.numbers.get(word) {
                self.placed[axis] = true;
            }
        }
    }

    fn seen(&mut self) {
        for (k, range) in self.tracked.ranges.iter_mut().enumerate() {
            if self.placed[k] {
                let value = self.at[k];
                *range = Some(range.map_or([value; 2], |[a, b]| [a.min(value), b.max(value)]));
            }
        }
    }
}

/// Time of a rapid move of one axis, s; none for an axis without limits.
fn rapid_time(limits: &AxisLimits, way: f64) -> f64 {
    let limit = |x: Option<f64>| x.unwrap_or(f64::INFINITY);
    if limits.velocity.is_none() && limits.acceleration.is_none() {
        return 0.0;
    }
    SCurve::new(way, limit(limits.velocity), limit(limits.acceleration), limit(limits.jerk)).duration()
}

impl Segment {
    /// Positions at a share u of the block.
    fn at(&self, machine: &Machine, u: f64) -> Positions {
        let mut at = super::path::straight(machine, &self.from, &self.to, u);
        if let Some((axis, gear)) = &self.gear {
            at[*axis] = gear.follower(&at);
        }
        at
    }

    /// Shares of the block between which the follower is one cubic of a table: ends included, each divided for a spline.
    fn shares(&self) -> Vec<f64> {
        let mut shares = vec![0.0, 1.0];
        if let Some((_, gear)) = &self.gear {
            for (axis, sense, coupled) in &gear.leaders {
                let Coupled::Table(table) = coupled else { continue };
                let (from, to) = (sense * self.from[*axis], sense * self.to[*axis]);
                if from == to {
                    continue;
                }
                let breaks = table.pieces.iter().map(|piece| piece.leader).chain([table.start[0]]);
                let inside = |u: &f64| *u > NEAR && *u < 1.0 - NEAR;
                shares.extend(breaks.map(|x| (x - from) / (to - from)).filter(inside));
            }
        }
        shares.sort_by(f64::total_cmp);
        if shares.len() > 2 {
            let finer = shares
                .windows(2)
                .flat_map(|u| (0..TABLE_PARTS).map(|k| u[0] + (u[1] - u[0]) * k as f64 / TABLE_PARTS as f64));
            shares = finer.chain([1.0]).collect();
        }
        shares
    }
}

/// Share of a block, or of the mean distance of places, below which two places are one: a spline through both would follow their
/// rounding.
const NEAR: f64 = 0.02;
/// Parts of a table's cubic through which a spline goes.
const TABLE_PARTS: usize = 4;
/// A path parameter that changes by less than this over a block stands, mm.
const STANDS: f64 = 1e-9;
/// Shares of a block beside the strokes at which its place is looked at, and parts of a rapid move.
const LINKS: [f64; 3] = [0.0, 0.5, 1.0];
const RAPID_PLACES: usize = 32;

/// A place of the bodies in a program.
#[derive(Clone, Copy)]
struct Place<S> {
    v: f64,
    /// Centre distance, mm.
    distance: f64,
    state: S,
    /// Block, from 1, and time, s.
    block: usize,
    duration: f64,
    /// Whether the follower of a table is between its ends here.
    inner: bool,
}

/// Lets a run go on with a place, or ends it. A block is part of a stroke if the path parameter changes by more than the distance of
/// the bodies: otherwise the tool comes in or goes out.
fn extend<S: Copy>(
    run: &mut Vec<Place<S>>,
    runs: &mut Vec<Vec<Place<S>>>,
    before: Place<S>,
    place: Place<S>,
) {
    let step = place.v - before.v;
    let moves = step.abs() > STANDS && step.abs() > (place.distance - before.distance).abs();
    let turns_back = match run.as_slice() {
        [.., a, b] => (b.v - a.v) * step < 0.0,
        _ => false,
    };
    if !moves || turns_back {
        let done = std::mem::take(run);
        if done.len() > 1 {
            runs.push(done);
        }
    }
    if moves {
        if run.is_empty() {
            run.push(Place { duration: 0.0, ..before });
        }
        run.push(place);
    }
}

impl Tracked {
    /// Runs of places along which the path parameter rises or falls.
    fn runs<S: Copy>(
        &self,
        machine: &Machine,
        mut state: impl FnMut(&Positions, Option<&S>, Option<(&Positions, &Positions)>) -> Option<([f64; 2], S)>,
    ) -> Result<Vec<Vec<Place<S>>>, MotionError> {
        let mut runs: Vec<Vec<Place<S>>> = Vec::new();
        for chain in &self.chains {
            let mut run: Vec<Place<S>> = Vec::new();
            let mut last: Option<(Positions, Place<S>)> = None;
            for segment in chain {
                let shares = segment.shares();
                for (k, &u) in shares.iter().enumerate() {
                    // The start of a block is the end of the one before it, unless a chain begins.
                    if k == 0 && last.is_some() {
                        continue;
                    }
                    let at = segment.at(machine, u);
                    let before = last.as_ref();
                    let found = state(&at, before.map(|b| &b.1.state), before.map(|b| (&b.0, &at)));
                    let ([v, distance], state) = found.ok_or_else(|| MotionError::NotFollowed {
                        block: segment.block,
                        reason: "the bodies cannot stand so against each other".into(),
                    })?;
                    let duration = if k > 0 { segment.duration * (u - shares[k - 1]) } else { 0.0 };
                    let inner = k > 0 && k + 1 < shares.len();
                    let place = Place { v, distance, state, block: segment.block, duration, inner };
                    if let Some((_, before)) = last {
                        extend(&mut run, &mut runs, before, place);
                    }
                    last = Some((at, place));
                }
            }
            if run.len() > 1 {
                runs.push(run);
            }
        }
        Ok(runs)
    }

    /// Blocks in which an axis moves faster than `limit` (mm/s or rad/s), each with its greatest speed.
    pub fn faster(&self, axis: usize, limit: f64) -> Vec<(usize, f64)> {
        let mut found: Vec<(usize, f64)> = Vec::new();
        for segment in self.chains.iter().flatten() {
            let speed = (segment.to[axis] - segment.from[axis]).abs() / segment.duration;
            match found.last_mut() {
                _ if speed <= limit => {}
                Some((block, greatest)) if *block == segment.block => *greatest = greatest.max(speed),
                _ => found.push((segment.block, speed)),
            }
        }
        found
    }

    /// All moves whose ends are known: block, from 1, and its ends. Between them the axes go straight, but for one that a gear leads.
    pub fn moves(&self) -> impl Iterator<Item = (usize, [&Positions; 2])> {
        let blocks =
            self.chains.iter().flatten().map(|segment| (segment.block, [&segment.from, &segment.to]));
        blocks.chain(self.rapids.iter().map(|(block, [from, to])| (*block, [from, to])))
    }

    /// Blocks of rapid moves, from 1, rising.
    pub fn rapid_blocks(&self) -> impl Iterator<Item = usize> {
        self.rapids.iter().map(|(block, _)| *block)
    }

    /// Where the axes stand off the strokes of these blocks: along all other blocks and rapid moves, and at the first and the last place
    /// of each stroke. Block, from 1, and positions.
    pub fn beside(&self, machine: &Machine, strokes: &[[usize; 2]]) -> Vec<(usize, Positions)> {
        let inside = |block: usize| strokes.iter().any(|&[first, last]| block >= first && block <= last);
        let mut places = Vec::new();
        for segment in self.chains.iter().flatten() {
            if inside(segment.block) {
                let ends = [
                    strokes.iter().any(|s| s[0] == segment.block),
                    strokes.iter().any(|s| s[1] == segment.block),
                ];
                let at = [segment.from, segment.to];
                places.extend(
                    ends.into_iter().zip(at).filter(|(end, _)| *end).map(|(_, at)| (segment.block, at)),
                );
            } else {
                places.extend(LINKS.map(|u| (segment.block, segment.at(machine, u))));
            }
        }
        for (block, [from, to]) in &self.rapids {
            let along = (0..=RAPID_PLACES).map(|k| k as f64 / RAPID_PLACES as f64);
            places.extend(along.map(|u| (*block, super::path::straight(machine, from, to, u))));
        }
        places
    }

    /// The grinding strokes of the program: motions with the chain, the tooth numbers and the phase of `nominal`, everything else
    /// from the program.
    ///
    /// # Errors
    /// [`MotionError::NotFollowed`].
    pub fn grinding(
        &self,
        machine: &Machine,
        mounts: &Mounts,
        nominal: &GeneratingMotion,
        phase: f64,
    ) -> Result<Vec<ReadStroke<GeneratingMotion>>, MotionError> {
        let turning = [machine.role(Role::Worm), machine.role(Role::Work)];
        let senses = [mounts.tool.sense(), mounts.counterpart.sense()];
        let runs = self.runs(machine, |at, last: Option<&GeneratingState>, moved| {
            let bodies: Pose<Worm, Workpiece> = mounts.bodies(&machine.pose(Station::Work, at).ok()?);
            let mut near = last.copied().unwrap_or(GeneratingState {
                worm_angle: 0.0,
                work_angle: 0.0,
                shift: 0.0,
                feed: 0.0,
                delta_d: 0.0,
                delta_gamma: 0.0,
            });
            // Full turns are those of the spindles.
            if let Some((from, to)) = moved {
                let by = |k: usize| turning[k].map_or(0.0, |axis| senses[k] * (to[axis] - from[axis]));
                near.worm_angle += by(0);
                near.work_angle += by(1);
            }
            let state = nominal.chain.state_of(&bodies, &near)?;
            Some(([state.feed, state.delta_d], state))
        })?;
        let mut strokes = Vec::with_capacity(runs.len());
        for run in runs {
            // What the coupling does not explain, modulo a tooth.
            let tooth = TAU / nominal.teeth.abs();
            let correction = |s: &GeneratingState| {
                let turned = -s.worm_angle * nominal.threads
                    + phase
                    + s.shift * nominal.shift_coupling
                    + s.feed * nominal.feed_coupling;
                s.work_angle - turned / nominal.teeth
            };
            let first = &run[0].state;
            let known = nominal.delta_phi_2.value(first.feed);
            let pitches = ((correction(first) - known) / tooth).round();
            let teeth = pitches * tooth;
            let index = (pitches * nominal.teeth.signum()) as i64;
            let tabled = run.iter().any(|place| place.inner);
            let law = |value: &dyn Fn(&GeneratingState) -> f64, smooth: bool| law_of(&run, value, smooth);
            let motion = GeneratingMotion {
                shift: law(&|s| s.shift, false)?,
                delta_d: law(&|s| s.delta_d, false)?,
                delta_phi_2: law(&|s| correction(s) - teeth, tabled)?,
                delta_gamma: law(&|s| s.delta_gamma, false)?,
                ..nominal.clone()
            };
            strokes.push(stroke_of(&run, motion, index));
        }
        Ok(strokes)
    }

    /// The dressing strokes of the program: corrections against the chain, everything from the program.
    ///
    /// # Errors
    /// [`MotionError::NotFollowed`].
    pub fn dressing(
        &self,
        machine: &Machine,
        mounts: &Mounts,
        chain: &DressingChain,
    ) -> Result<Vec<ReadStroke<DressingMotion>>, MotionError> {
        let worm = machine.role(Role::Worm);
        let sense = mounts.tool.sense();
        let runs = self.runs(machine, |at, last: Option<&DressingPosition>, moved| {
            let bodies: Pose<Worm, Dresser> = mounts.bodies(&machine.pose(Station::Dresser, at).ok()?);
            // At first the worm stands in the half turn in which the crossing angle has the sign of the chain's.
            let near = match (last, moved) {
                (Some(last), Some((from, to))) => {
                    last.worm_angle + worm.map_or(0.0, |axis| sense * (to[axis] - from[axis]))
                }
                _ => {
                    let axis = bodies.rotation().column(2).into_owned() * chain.crossing_angle.signum();
                    if axis.x.hypot(axis.y) == 0.0 { 0.0 } else { axis.x.atan2(axis.y) }
                }
            };
            let position = DressingPosition::of_pose(&bodies, near)?;
            Some(([position.worm_shift, position.centre_distance], position))
        })?;
        let mut strokes = Vec::with_capacity(runs.len());
        for run in runs {
            let turned =
                |p: &DressingPosition| p.worm_angle - p.worm_shift / chain.screw_parameter - chain.worm_angle;
            // Any thread: full turns against the chain mean nothing.
            let turns = (turned(&run[0].state) / TAU).round() * TAU;
            let law = |value: &dyn Fn(&DressingPosition) -> f64| law_of(&run, value, false);
            let correction = [
                law(&|p| turned(p) - turns)?,
                law(&|p| p.crossing_angle - chain.crossing_angle)?,
                law(&|p| p.centre_distance - chain.centre_distance)?,
                law(&|p| p.offset - chain.offset)?,
            ];
            strokes.push(stroke_of(&run, DressingMotion { chain: *chain, correction }, 0));
        }
        Ok(strokes)
    }
}

fn stroke_of<S, M>(run: &[Place<S>], motion: M, index: i64) -> ReadStroke<M> {
    let (first, last) = (&run[0], &run[run.len() - 1]);
    ReadStroke {
        motion,
        range: [first.v.min(last.v), first.v.max(last.v)],
        index,
        blocks: [run.get(1).map_or(first.block, |place| place.block), last.block],
        duration: run.iter().map(|place| place.duration).sum(),
    }
}

/// A quantity over the path parameter: straight between the places, corners rounded; or a spline where a table was followed.
fn law_of<S>(run: &[Place<S>], value: &dyn Fn(&S) -> f64, smooth: bool) -> Result<MotionLaw, MotionError> {
    let falling = run[run.len() - 1].v < run[0].v;
    let apart = NEAR * (run[run.len() - 1].v - run[0].v).abs() / run.len() as f64;
    let mut kept: Vec<&Place<S>> = Vec::with_capacity(run.len());
    for place in run.iter().filter(|place| smooth || !place.inner) {
        match kept.last() {
            Some(before) if smooth && (place.v - before.v).abs() < apart => {}
            _ => kept.push(place),
        }
    }
    let order = |k: usize| if falling { kept.len() - 1 - k } else { k };
    let x: Vec<f64> = (0..kept.len()).map(|k| kept[order(k)].v).collect();
    let y: Vec<f64> = (0..kept.len()).map(|k| value(&kept[order(k)].state)).collect();
    let law = if smooth && x.len() >= 4 {
        MotionLaw::spline(&x, &y)
    } else if x.len() > 2 {
        MotionLaw::rounded_corners(&x, &y)
    } else {
        let slope = (y[1] - y[0]) / (x[1] - x[0]);
        return Ok(MotionLaw::polynomial(x[0], vec![y[0], slope]));
    };
    law.map_err(|error| MotionError::NotFollowed { block: run[0].block, reason: error.to_string() })
}
