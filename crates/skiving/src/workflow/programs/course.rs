//! The neutral steps of a measuring program, from place to place. Knows no dialect.

use super::room::Room;
use super::stand::Stander;
use super::task::{Retreat, ToolMachining};
use crate::VirtualEdge;
use crate::measuring::{Beam, MeasuringPose};
use foundation::geometry::Sides;
use job::Diagnostic;
use machine::{Joint, Positions};
use motion::AxisWords;
use nalgebra::Vector3;
use nc::{Block, Targets};
use run::RunFailure;

/// One step.
#[derive(Clone, Debug)]
pub(super) enum Step {
    Comment(String),
    Rapid(Positions),
    /// In so many seconds.
    Straight(Positions, f64),
    Output(bool),
}

/// Steps, and where the axes stand after them.
#[derive(Clone, Debug)]
pub(super) struct Course<'m> {
    pub stander: Stander<'m>,
    pub retreat: Retreat,
    pub steps: Vec<Step>,
    pub at: Option<Positions>,
    /// Where the tool stands drawn back.
    back: Option<Positions>,
    pub room: Room,
}

/// An axis that would go less, mm or rad, stands: that is what inverse kinematics leave of an axis that does not move.
const SAME: f64 = 1e-10;

impl<'m> Course<'m> {
    /// An empty course of a tool with these edges before a beam.
    ///
    /// # Errors
    /// A machine whose tool limb has no spindle; an edge without contact at its ends.
    pub fn new(
        machining: &ToolMachining<'m>,
        edges: &Sides<&VirtualEdge>,
        beam: &Beam,
    ) -> Result<Self, RunFailure> {
        Self::in_room(machining, Room::new(machining.retreat.direction, edges, beam)?)
    }

    /// An empty course in a room.
    ///
    /// # Errors
    /// A machine whose tool limb has no spindle.
    pub fn in_room(machining: &ToolMachining<'m>, room: Room) -> Result<Self, RunFailure> {
        Ok(Self {
            stander: Stander::new(machining)?,
            retreat: machining.retreat,
            steps: Vec::new(),
            at: None,
            back: None,
            room,
        })
    }

    /// Goes by rapid.
    pub fn rapid(&mut self, to: Positions) {
        self.steps.push(Step::Rapid(to));
        self.at = Some(to);
    }

    pub fn comment(&mut self, text: &str) {
        self.steps.push(Step::Comment(text.to_ascii_uppercase()));
    }

    pub fn output(&mut self, on: bool) {
        self.steps.push(Step::Output(on));
    }

    pub fn straight(&mut self, to: Positions, seconds: f64) {
        self.steps.push(Step::Straight(to, seconds));
        self.at = Some(to);
    }

    /// Goes by rapid to the place that is drawn back from a pose and then straight into it. `turned` says whether the tool has to take
    /// the turn of the pose as well; else it keeps the one that it has, if it has one.
    ///
    /// # Errors
    /// A place that the axes do not reach; a beam that is not free on the way.
    pub fn approach(
        &mut self,
        pose: &MeasuringPose,
        turned: bool,
        place: &str,
    ) -> Result<Positions, RunFailure> {
        let direction = self.room.direction(pose)?;
        let drawn = MeasuringPose { position: pose.position + direction * self.retreat.distance, ..*pose };
        let near = self.at;
        let stand = self.stander.stand(pose, near.as_ref(), place)?;
        let found = self.stander.stand(&drawn, Some(&stand), &format!("{place}, drawn back"))?;
        let mut back = self.slid(&stand, &found);
        let (mut into, turning) = (stand, self.stander.turning);
        if let (false, Some(now)) = (turned, near) {
            (back[turning], into[turning]) = (now[turning], now[turning]);
        }
        self.room.free(&self.stander, [self.back.as_ref().unwrap_or(&back), &back], place)?;
        if self.back.is_none() {
            self.bring(&back, place)?;
        }
        self.steps.push(Step::Rapid(back));
        self.back = Some(back);
        self.straight(into, self.retreat.distance / self.retreat.speed);
        Ok(stand)
    }

    /// Brings the light barrier and the tool together: the tool to where it is drawn back, and only then the carrier out of its parking
    /// place.
    ///
    /// # Errors
    /// A beam that is not free on the way of the carrier.
    pub fn bring(&mut self, back: &Positions, place: &str) -> Result<(), RunFailure> {
        let Some(carrier) = self.stander.carrier().copied() else { return Ok(()) };
        let mut parked = *back;
        parked[carrier.axis] = carrier.parked;
        self.room.free(&self.stander, [&parked, back], place)?;
        self.comment("carrier to its measuring place");
        self.steps.push(Step::Rapid(parked));
        Ok(())
    }

    /// How near the beam comes to the tool's axis while the carrier brings it, with the other axes here, mm.
    ///
    /// # Errors
    /// Positions that are not finite.
    pub fn nearest_of_carrier(&self, at: &Positions) -> Result<f64, RunFailure> {
        let Some(carrier) = self.stander.carrier() else { return Ok(f64::INFINITY) };
        let mut parked = *at;
        parked[carrier.axis] = carrier.parked;
        self.room.nearest(&self.stander, [&parked, at])
    }

    /// Parks the carrier again, with the tool drawn back.
    ///
    /// # Errors
    /// A beam that is not free on the way.
    pub fn park(&mut self) -> Result<(), RunFailure> {
        let (Some(carrier), Some(at)) = (self.stander.carrier().copied(), self.at) else { return Ok(()) };
        let mut parked = at;
        parked[carrier.axis] = carrier.parked;
        self.room.free(&self.stander, [&at, &parked], "the way of the carrier")?;
        self.comment("carrier to its parking place");
        self.rapid(parked);
        Ok(())
    }

    /// Draws the tool back from a pose as it stands.
    ///
    /// # Errors
    /// As [`Course::approach`].
    pub fn draw_back(&mut self, pose: &MeasuringPose, place: &str) -> Result<(), RunFailure> {
        let direction = self.room.direction(pose)?;
        let drawn = MeasuringPose { position: pose.position + direction * self.retreat.distance, ..*pose };
        let near = self.at;
        let found = self.stander.stand(&drawn, near.as_ref(), &format!("{place}, drawn back"))?;
        let back = near.map_or(found, |now| self.slid(&now, &found));
        self.room.free(&self.stander, [self.back.as_ref().unwrap_or(&back), &back], place)?;
        self.back = Some(back);
        self.straight(back, self.retreat.distance / self.retreat.speed);
        Ok(())
    }

    /// The linear axes as they are found, the others as they stand.
    fn slid(&self, stand: &Positions, found: &Positions) -> Positions {
        let machine = self.stander.machine;
        let mut at = *stand;
        let held = self.stander.carrier().map(|carrier| carrier.axis);
        let linear = self
            .stander
            .axes
            .iter()
            .filter(|&&axis| machine.axes()[axis].joint == Joint::Linear && Some(axis) != held);
        linear.for_each(|&axis| at[axis] = found[axis]);
        at
    }

    /// The blocks on a control: every block names the axes that go elsewhere.
    pub fn blocks(&self, words: &AxisWords, output: u8) -> Vec<Block> {
        let machine = self.stander.machine;
        let mut at: Option<Positions> = None;
        let mut blocks = Vec::with_capacity(self.steps.len() + 1);
        let targets = |at: &mut Option<Positions>, to: &Positions| -> Targets {
            let goes = |axis: usize| at.is_none_or(|from| (from[axis] - to[axis]).abs() > SAME);
            let target = words.targets(machine, to, goes);
            *at = Some(words.positions(machine, &at.unwrap_or_default(), &target));
            target
        };
        for step in &self.steps {
            match step {
                Step::Comment(text) => blocks.push(Block::Comment(text.as_str().into())),
                Step::Output(on) => blocks.push(Block::Output { number: output, on: *on }),
                Step::Rapid(to) => {
                    let target = targets(&mut at, to);
                    blocks.extend((!target.is_empty()).then_some(Block::Rapid(target)));
                }
                Step::Straight(to, seconds) => {
                    let target = targets(&mut at, to);
                    let block = Block::Linear { target, duration: *seconds };
                    blocks.extend((!target.is_empty()).then_some(block));
                }
            }
        }
        blocks.push(Block::End);
        blocks
    }

    /// Whether a speed (per second) is within what an axis can, and the way that it takes to get there.
    ///
    /// # Errors
    /// A speed beyond the axis.
    pub fn run_up(&self, axis: usize, speed: f64) -> Result<f64, RunFailure> {
        let described = &self.stander.machine.axes()[axis];
        if let Some(limit) = described.limits.velocity.filter(|limit| speed > *limit) {
            let shown = |value: f64| described.joint.shown(value);
            let text = format!(
                "axis {} = {:.4} {unit}/s is faster than the {:.4} {unit}/s that it can",
                described.name,
                shown(speed),
                shown(limit),
                unit = described.joint.unit()
            );
            let finding = Diagnostic::with_code("axis-too-fast", text).field("measuring.speed_rpm");
            return Err(RunFailure::not_producible(finding.way_out("turn the tool more slowly")));
        }
        Ok(described.limits.acceleration.map_or(0.0, |most| speed * speed / (2.0 * most)))
    }

    /// Greatest distance of points of the tool from the rotary axes at a place, mm.
    pub fn lever(&self, at: &Positions, point: &Vector3<f64>) -> Result<f64, RunFailure> {
        self.stander.axis_lever(at, point)
    }

    /// A finding on an axis that no word of the control moves.
    pub fn moved(&self, words: &AxisWords) -> Result<(), RunFailure> {
        match self.stander.axes.iter().find(|&&axis| !words.is_moved(axis)) {
            None => Ok(()),
            Some(&axis) => {
                let name = &self.stander.machine.axes()[axis].name;
                let finding =
                    Diagnostic::with_code("axis-not-available", format!("{name} has no word on the control"))
                        .field("machine.file")
                        .way_out(format!("give {name} a letter in the machine description"));
                Err(RunFailure::bad_input(finding))
            }
        }
    }
}
