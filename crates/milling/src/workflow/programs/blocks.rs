//! From the steps of a motion to the blocks of a neutral program, and which place every block of it leads to.

use super::held::{Held, length_number};
use super::passes::name_of;
use super::steps::{DrivenMotion, Step, StepKind, ToolRun};
use super::task::MillingWork;
use crate::job::CutterCoolant;
use crate::workflow::prepare::ToolData;
use foundation::kinematics::{Direction, Point};
use machine::Positions;
use motion::AxisWords;
use motion::milling::MillingSetup;
use nalgebra::Vector3;
use nc::{Angles, Block, Coolant, Dialect, Orientation, Pace, TipControl, TipMotion};

/// What the motions of a program shall be when it is read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Expected {
    /// Number of the tool run and of the step that the motion ends.
    pub step: [usize; 2],
    /// Whether it only tells the axes where they stand.
    pub stands: bool,
}

/// Speeds of the tip that a block may have, mm/s; one beyond has a time instead.
const SPEEDS: [f64; 2] = [0.2 / 60.0, 9e5 / 60.0];

/// The blocks that switch a tool's coolant on.
pub(super) fn coolant_blocks(coolant: CutterCoolant) -> impl Iterator<Item = Block> {
    let [flood, mist] = coolant.supplies();
    [(mist, Coolant::Mist), (flood, Coolant::Flood)]
        .into_iter()
        .filter_map(|(on, supply)| on.then_some(Block::Coolant(supply)))
}

/// The block that switches it off.
pub(super) fn coolant_off(coolant: CutterCoolant) -> Option<Block> {
    (coolant != CutterCoolant::Off).then_some(Block::Coolant(Coolant::Off))
}

/// A control, and how a program leads it.
#[derive(Clone, Copy)]
pub(super) struct Control<'a> {
    /// Its dialect.
    pub dialect: Dialect,
    /// How it receives the axis of the tool.
    pub tip_control: TipControl,
    /// What it adds to positions.
    pub held: &'a Held,
    /// Time for the spindle to come to its speed, s.
    pub spindle_dwell: f64,
    /// Names of the operations.
    pub work: &'a MillingWork<'a>,
}

/// Blocks and what their motions lead to.
pub(super) struct Blocks<'a> {
    setup: &'a MillingSetup<'a>,
    words: &'a AxisWords,
    control: Control<'a>,
    /// The tool in the spindle.
    tool: Option<ToolData>,
    pub blocks: Vec<Block>,
    pub expected: Vec<Expected>,
    guided: bool,
    /// Speed of the tip as the text has it, tenths of mm/min.
    pace: Option<i64>,
    last: Option<Step>,
}

impl<'a> Blocks<'a> {
    pub fn new(setup: &'a MillingSetup<'a>, words: &'a AxisWords, control: Control<'a>) -> Self {
        let (blocks, expected) = (Vec::new(), Vec::new());
        Self { setup, words, control, tool: None, blocks, expected, guided: false, pace: None, last: None }
    }

    /// Puts in a whole motion, with its tools.
    pub fn motion(&mut self, motion: &DrivenMotion) {
        self.blocks.extend(self.control.held.offset.map(|offset| Block::WorkOffset(offset.number)));
        for (number, run) in motion.tools.iter().enumerate() {
            self.change(run);
            for (k, step) in run.steps.iter().enumerate() {
                self.step(step, [number, k]);
            }
        }
        self.guide(false);
        self.blocks.extend(self.tool.and_then(|tool| coolant_off(tool.coolant)));
        self.blocks.push(Block::Spindle { spindle: 0, speed: 0.0 });
        self.blocks.push(Block::End);
    }

    /// The next tool, its spindle and its coolant.
    fn change(&mut self, run: &ToolRun) {
        self.guide(false);
        self.blocks.extend(self.tool.and_then(|tool| coolant_off(tool.coolant)));
        let ToolRun { tool, steps } = run;
        self.tool = Some(*tool);
        let mut named: Vec<usize> = steps.iter().map(|step| step.operation).collect();
        named.sort_unstable();
        named.dedup();
        let names: Vec<String> = named
            .iter()
            .filter_map(|number| self.control.work.tools.get(*number))
            .map(|work| name_of(work.kind))
            .collect();
        let text = format!("TOOL {} {}", tool.number, names.join(" ").to_uppercase());
        self.blocks.push(Block::Comment(text.into()));
        // Under tip control the control has to know the length of the tool.
        let guided = steps.iter().any(|step| step.guided);
        let length_offset = guided.then(|| length_number(tool, self.control.dialect));
        self.blocks.push(Block::Tool { number: tool.number, length_offset });
        let speed = tool.spindle_rpm * std::f64::consts::PI / 30.0;
        self.blocks.push(Block::Spindle { spindle: 0, speed });
        if self.control.spindle_dwell > 0.0 {
            self.blocks.push(Block::Dwell(self.control.spindle_dwell));
        }
        self.blocks.extend(coolant_blocks(tool.coolant));
        self.lengthen(true);
        self.last = None;
    }

    /// The control begins or ends to add the length of the tool to positions.
    fn lengthen(&mut self, on: bool) {
        let Some(tool) = self.tool.filter(|_| self.control.held.lengthened.is_some()) else { return };
        let number = on.then(|| length_number(&tool, self.control.dialect));
        self.blocks.push(Block::LengthOffset(number));
    }

    fn targets(&self, at: &Positions, which: impl Fn(usize) -> bool) -> nc::Targets {
        let positions = self.words.targets(self.setup.machine(), at, which);
        self.control.held.written(self.words, &positions, self.tool.map_or(0.0, |tool| tool.length))
    }

    fn guide(&mut self, on: bool) {
        if on != self.guided {
            self.guided = on;
            self.pace = None;
            if on {
                self.lengthen(false);
                self.blocks.push(Block::TipControlOn(self.control.tip_control));
            } else {
                self.blocks.push(Block::TipControlOff);
                self.lengthen(true);
            }
        }
    }

    fn step(&mut self, step: &Step, number: [usize; 2]) {
        if self.guided && !step.guided {
            self.guide(false);
            // The control has moved the axes on its own: they are told where they stand before they go on.
            if let Some(at) = self.last.as_ref().map(|last| last.at) {
                self.blocks.push(Block::Rapid(self.targets(&at, |_| true)));
                let stand = [number[0], number[1] - 1];
                self.expected.push(Expected { step: stand, stands: true });
            }
        }
        self.guide(step.guided);
        let all = self.targets(&step.at, |_| true);
        match step.kind {
            _ if step.guided => self.tip(step),
            StepKind::Position => {
                // First the rotary axes, while the tool is still away from the workpiece.
                let rotary = self.setup.axes().rotary;
                let turned = self.targets(&step.at, |axis| rotary.contains(&axis));
                self.blocks.push(Block::Rapid(turned));
                self.blocks.push(Block::Rapid(all));
            }
            StepKind::Link | StepKind::Unwind | StepKind::End => self.blocks.push(Block::Rapid(all)),
            _ => self.blocks.push(Block::Linear { target: all, duration: step.seconds }),
        }
        self.expected.push(Expected { step: number, stands: false });
        self.last = Some(step.clone());
    }

    fn tip(&mut self, step: &Step) {
        let clamping = self.setup.clamping();
        let tip: Point<_> = clamping.point(&step.place.tip);
        let axis: Direction<_> = clamping.direction(&step.place.axis);
        let orientation = match self.control.tip_control {
            TipControl::Directions => Orientation::Direction(axis.xyz.into()),
            TipControl::Angles => self.angles(&step.at),
        };
        let way = self.last.as_ref().map_or(0.0, |last| (step.place.tip.xyz - last.place.tip.xyz).norm());
        let speed = way / step.seconds;
        let pace = if step.kind == StepKind::Link {
            Pace::Rapid
        } else if (SPEEDS[0]..=SPEEDS[1]).contains(&speed) {
            let tenths = (speed * 600.0).round() as i64;
            if self.pace.replace(tenths) == Some(tenths) { Pace::Kept } else { Pace::Speed(speed) }
        } else {
            self.pace = None;
            Pace::Duration(step.seconds)
        };
        let origin = self.control.held.offset.map_or([0.0; 3], |offset| offset.position);
        let tip = (tip.xyz - Vector3::from(origin)).into();
        self.blocks.push(Block::Tip(TipMotion { tip, orientation, pace }));
    }

    fn angles(&self, at: &Positions) -> Orientation {
        let rotary = self.setup.axes().rotary;
        let targets: Vec<(usize, f64)> =
            self.words.targets(self.setup.machine(), at, |axis| rotary.contains(&axis)).iter().collect();
        Angles::new(&targets).map_or(Orientation::Kept, Orientation::Angles)
    }
}
