//! From the steps of a motion to the blocks of a neutral program, and which place every block of it leads to.

use super::steps::{DrivenMotion, Step, StepKind};
use foundation::kinematics::{Direction, Point};
use machine::Positions;
use motion::AxisWords;
use motion::milling::MillingSetup;
use nc::{Angles, Block, Orientation, Pace, TipControl, TipMotion};

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
/// Length offsets that controls have.
const MOST_OFFSETS: u32 = 999;

/// Blocks and what their motions lead to.
pub(super) struct Blocks<'a> {
    setup: &'a MillingSetup<'a>,
    words: &'a AxisWords,
    tip_control: TipControl,
    pub blocks: Vec<Block>,
    pub expected: Vec<Expected>,
    guided: bool,
    /// Speed of the tip as the text has it, tenths of mm/min.
    pace: Option<i64>,
    last: Option<Step>,
}

impl<'a> Blocks<'a> {
    pub fn new(setup: &'a MillingSetup<'a>, words: &'a AxisWords, tip_control: TipControl) -> Self {
        let (blocks, expected) = (Vec::new(), Vec::new());
        Self { setup, words, tip_control, blocks, expected, guided: false, pace: None, last: None }
    }

    /// Puts in a whole motion, with its tools.
    pub fn motion(&mut self, motion: &DrivenMotion) {
        for (number, run) in motion.tools.iter().enumerate() {
            self.guide(false);
            // Under tip control the control has to know the length of the tool.
            let guided = run.steps.iter().any(|step| step.guided);
            let length_offset = guided.then(|| run.number.clamp(1, MOST_OFFSETS));
            self.blocks.push(Block::Tool { number: run.number, length_offset });
            let speed = run.spindle_rpm * std::f64::consts::PI / 30.0;
            self.blocks.push(Block::Spindle { spindle: 0, speed });
            self.last = None;
            for (k, step) in run.steps.iter().enumerate() {
                self.step(step, [number, k]);
            }
        }
        self.guide(false);
        self.blocks.push(Block::Spindle { spindle: 0, speed: 0.0 });
        self.blocks.push(Block::End);
    }

    fn targets(&self, at: &Positions, which: impl Fn(usize) -> bool) -> nc::Targets {
        self.words.targets(self.setup.machine(), at, which)
    }

    fn guide(&mut self, on: bool) {
        if on != self.guided {
            self.guided = on;
            self.pace = None;
            self.blocks.push(if on { Block::TipControlOn(self.tip_control) } else { Block::TipControlOff });
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
            StepKind::Link | StepKind::Unwind => self.blocks.push(Block::Rapid(all)),
            _ => self.blocks.push(Block::Linear { target: all, duration: step.seconds }),
        }
        self.expected.push(Expected { step: number, stands: false });
        self.last = Some(step.clone());
    }

    fn tip(&mut self, step: &Step) {
        let clamping = self.setup.clamping();
        let tip: Point<_> = clamping.point(&step.place.tip);
        let axis: Direction<_> = clamping.direction(&step.place.axis);
        let orientation = match self.tip_control {
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
        self.blocks.push(Block::Tip(TipMotion { tip: tip.xyz.into(), orientation, pace }));
    }

    fn angles(&self, at: &Positions) -> Orientation {
        let rotary = self.setup.axes().rotary;
        let targets: Vec<(usize, f64)> = self.targets(at, |axis| rotary.contains(&axis)).iter().collect();
        Angles::new(&targets).map_or(Orientation::Kept, Orientation::Angles)
    }
}
