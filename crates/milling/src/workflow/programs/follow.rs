//! Blocks as a reader found them, followed: positions of the axes or places of the tip -> where the cutter stands on the workpiece.

use super::held::{Held, length_number};
use super::task::MillingWork;
use crate::workflow::prepare::ToolData;
use foundation::kinematics::{Direction, Point};
use machine::{Positions, Station};
use motion::milling::MillingSetup;
use motion::{AxisWords, MotionError};
use nalgebra::Vector3;
use nc::{Block, Coolant, Dialect, Orientation, Pace, Targets};
use referee::CutterPlace;

/// One motion that ends where all is known.
#[derive(Clone, Debug, PartialEq)]
pub struct FollowedMove {
    /// Number of the block, from 1.
    pub block: usize,
    /// Number of the tool.
    pub tool: u32,
    /// Speed of its spindle, rad/s; none before a block says it.
    pub spindle: Option<f64>,
    /// Supplies of coolant that are on: the first, the second.
    pub coolant: [bool; 2],
    /// Whether it is rapid.
    pub rapid: bool,
    /// Places of the cutter, workpiece coordinates: begin (if it is known) and end; of a block of axis values so many between that
    /// straight pieces are within 10 nm.
    pub places: Vec<CutterPlace>,
    /// The axes at its end; `None` under tip control.
    pub at: Option<Positions>,
    /// Time that the block states, s.
    pub seconds: Option<f64>,
}

/// Deviation of a straight piece, mm.
const PIECE: f64 = 1e-5;
/// Distance from the tip at which the turn of the axis counts for that, mm.
const LEVER: f64 = 50.0;
/// Most pieces of a block.
const MOST_PIECES: f64 = 4096.0;

/// Follows blocks.
pub(super) struct Follower<'a> {
    pub setup: &'a MillingSetup<'a>,
    pub words: &'a AxisWords,
    /// The tools, for their lengths.
    pub work: &'a MillingWork<'a>,
    /// What the control adds to positions.
    pub held: &'a Held,
    pub dialect: Dialect,
}

/// Where everything is.
#[derive(Default)]
struct State {
    tool: u32,
    spindle: Option<f64>,
    coolant: [bool; 2],
    /// Whether the control adds the length of the tool to positions, and whether its work offset is in force.
    lengthened: bool,
    shifted: bool,
    at: Positions,
    /// Places of the program's axes that have a value.
    known: u16,
    place: Option<CutterPlace>,
    speed: Option<f64>,
}

impl State {
    /// A motion of a block, in this state: whether it is rapid and what time it states, its places, the axes at its end.
    fn moved(
        &self,
        block: usize,
        (rapid, seconds): (bool, Option<f64>),
        places: Vec<CutterPlace>,
        at: Option<Positions>,
    ) -> FollowedMove {
        let Self { tool, spindle, coolant, .. } = *self;
        FollowedMove { block, tool, spindle, coolant, rapid, places, at, seconds }
    }
}

impl Follower<'_> {
    /// All motions of a program.
    ///
    /// # Errors
    /// [`MotionError::NotFollowed`] for blocks that no milling program has.
    pub fn follow(&self, blocks: &[Block]) -> Result<Vec<FollowedMove>, MotionError> {
        let five: Vec<usize> = self.setup.axes().rotary.into_iter().chain(self.setup.axes().linear).collect();
        let all = five
            .iter()
            .filter_map(|&axis| self.words.place(axis))
            .fold(0u16, |mask, place| mask | 1 << place);
        let mut state = State::default();
        let mut moves = Vec::new();
        for (k, block) in blocks.iter().enumerate() {
            let refused = |reason: &str| MotionError::NotFollowed { block: k + 1, reason: reason.into() };
            match block {
                Block::Tool { number, .. } => {
                    let State { coolant, shifted, .. } = state;
                    state = State { tool: *number, coolant, shifted, ..State::default() };
                }
                Block::Coolant(Coolant::Off) => state.coolant = [false; 2],
                Block::Coolant(Coolant::Flood) => state.coolant[0] = true,
                Block::Coolant(Coolant::Mist) => state.coolant[1] = true,
                Block::WorkOffset(number) => {
                    if self.held.offset.is_none_or(|offset| offset.number != *number) {
                        return Err(refused("another work offset than that of the job"));
                    }
                    state.shifted = true;
                    state.known = 0;
                }
                Block::LengthOffset(number) => {
                    let own = self.tool(state.tool).map(|tool| length_number(&tool, self.dialect));
                    if number.is_some() && *number != own {
                        return Err(refused("another length offset than that of the job's tool"));
                    }
                    if number.is_some() && self.held.lengthened.is_none() {
                        return Err(refused(
                            "a length that the control adds to positions; the job has it in them (machine.tool_length_in)",
                        ));
                    }
                    state.lengthened = number.is_some();
                    state.known = 0;
                }
                Block::TipControlOff => state.known = 0,
                Block::TipSpeed(speed) => state.speed = Some(*speed),
                Block::Rapid(target) | Block::Linear { target, .. } => {
                    let seconds =
                        if let Block::Linear { duration, .. } = block { Some(*duration) } else { None };
                    if state.shifted != self.held.offset.is_some() {
                        return Err(refused("no work offset before its first motion, and the job has one"));
                    }
                    let target = &self.of_machine(&state, target);
                    let to = self.words.positions(self.setup.machine(), &state.at, target);
                    let from = (state.known & all == all).then_some(state.at);
                    state.known |= target.mask();
                    state.at = to;
                    if state.known & all != all {
                        continue;
                    }
                    let length = self.tool(state.tool).map_or(0.0, |tool| tool.length);
                    let setup = &self.setup.with_tool_length(length);
                    let places = self
                        .axes((setup, length), from.as_ref(), &to)
                        .map_err(|_| refused("the axes stand nowhere"))?;
                    state.place = places.last().copied();
                    moves.push(state.moved(k + 1, (seconds.is_none(), seconds), places, Some(to)));
                }
                Block::Tip(motion) => {
                    let axis = match motion.orientation {
                        Orientation::Direction(parts) => {
                            let axis = Direction::from_vector(Vector3::from(parts).normalize());
                            self.setup.clamping().inverse().direction(&axis).xyz
                        }
                        Orientation::Angles(angles) => {
                            for (place, value) in angles.iter() {
                                let number = *self
                                    .words
                                    .numbers
                                    .get(place)
                                    .ok_or_else(|| refused("an unknown axis"))?;
                                state.at[number] = self.setup.machine().axes()[number].nc_sign * value;
                            }
                            let stands = self.setup.stands(&state.at);
                            stands.map_err(|_| refused("the axes stand nowhere"))?.1.xyz
                        }
                        Orientation::Kept => match state.place {
                            Some(place) => place.axis,
                            None => return Err(refused("the tool points nowhere")),
                        },
                    };
                    let origin =
                        self.held.offset.filter(|_| state.shifted).map_or([0.0; 3], |offset| offset.position);
                    let tip = Vector3::from(motion.tip) + Vector3::from(origin);
                    let tip = self.setup.clamping().inverse().point(&Point::from_vector(tip)).xyz;
                    let to = CutterPlace { tip, axis };
                    let way = state.place.map_or(0.0, |from| (from.tip - tip).norm());
                    let seconds = match motion.pace {
                        Pace::Rapid => None,
                        Pace::Duration(seconds) => Some(seconds),
                        Pace::Speed(speed) => {
                            state.speed = Some(speed);
                            Some(way / speed)
                        }
                        Pace::Kept => state.speed.map(|speed| way / speed),
                    };
                    let places = state.place.into_iter().chain([to]).collect();
                    moves.push(state.moved(k + 1, (motion.pace == Pace::Rapid, seconds), places, None));
                    state.place = Some(to);
                }
                Block::Spindle { spindle: 0, speed } => state.spindle = Some(*speed),
                Block::Comment(_)
                | Block::Spindle { .. }
                | Block::Dwell(_)
                | Block::Stop
                | Block::TipControlOn(_)
                | Block::End => {}
                _ => return Err(refused("no block of a milling program")),
            }
        }
        Ok(moves)
    }

    /// The job's tool of this number.
    fn tool(&self, number: u32) -> Option<ToolData> {
        self.work.tools.iter().map(|tool| tool.tool).find(|tool| tool.number == number)
    }

    /// Positions of a text as those of the machine's axes.
    fn of_machine(&self, state: &State, target: &Targets) -> Targets {
        let length = self.tool(state.tool).filter(|_| state.lengthened).map_or(0.0, |tool| tool.length);
        self.held.meant(self.words, target, length)
    }

    /// Places of the cutter on a straight block of the axes.
    fn axes(
        &self,
        (setup, length): (&MillingSetup<'_>, f64),
        from: Option<&Positions>,
        to: &Positions,
    ) -> Result<Vec<CutterPlace>, machine::MachineError> {
        let place = |at: &Positions| {
            let (tip, axis) = setup.stands(at)?;
            Ok(CutterPlace { tip: tip.xyz, axis: axis.xyz.normalize() })
        };
        let Some(from) = from else { return Ok(vec![place(to)?]) };
        let reach = Point::new(0.0, 0.0, -length);
        let bound = setup.machine().straight_bound(Station::Work, [from, to], &reach)?;
        let bend = bound.chord() + LEVER * bound.turn.powi(2) / 8.0;
        let pieces = (bend / PIECE).sqrt().ceil().clamp(1.0, MOST_PIECES) as usize;
        let at = |k: usize| between(setup, from, to, k as f64 / pieces as f64);
        (0..=pieces).map(|k| place(&at(k))).collect()
    }
}

/// Positions on a straight block.
pub(super) fn between(setup: &MillingSetup<'_>, from: &Positions, to: &Positions, share: f64) -> Positions {
    let mut at = *from;
    for k in 0..setup.machine().axes().len() {
        at[k] = from[k] + (to[k] - from[k]) * share;
    }
    at
}
