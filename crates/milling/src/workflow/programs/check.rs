//! Any program of a control on the machine of a job: what it does to the axes, and the paths of the cutters on the workpiece.

use super::drive::rapid_seconds;
use super::failure::of_motion;
use super::follow::{FollowedMove, Follower};
use super::held::Held;
use super::passes::all_passes;
use super::task::{MillingMachining, MillingWork};
use foundation::kinematics::{Direction, Point};
use job::Diagnostic;
use job::tables::Program as DialectName;
use machine::Positions;
use motion::milling::{CutterPlace as Place, MillingSetup, PoleStrategy, choose};
use motion::{AxisWords, MotionError};
use nc::{Dialect, ReadProgram, read};
use referee::CutterPlace;
use run::RunFailure;
use run::program_check::control_of;
use std::io::BufRead;
use verdict::Remark;

/// What a program does. Values by the number of the machine's axis, mm or rad.
#[derive(Clone, Debug)]
pub struct CheckedMotion {
    /// The text as a reader found it.
    pub read: ReadProgram,
    /// The motions of the text on the workpiece.
    pub moves: Vec<FollowedMove>,
    /// Range of every axis; `None` for one that does not move with the others.
    pub ranges: Vec<Option<[f64; 2]>>,
    /// Whole way of every axis.
    pub ways: Vec<f64>,
    /// Greatest speed of every axis in blocks with a feed, per second.
    pub speeds: Vec<f64>,
    /// Time of all blocks, rapid ones at the greatest speeds of the axes, s.
    pub duration: f64,
    /// Words of the axes.
    pub words: AxisWords,
    /// Places under tip control that the axes do not reach.
    pub remarks: Vec<Remark>,
    /// Blocks that leave a travel or are faster than an axis: code and sentence for the worst of each axis.
    pub limits: Vec<AxisFault>,
}

/// An axis that a block takes beyond what it can.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisFault {
    /// Code.
    pub code: &'static str,
    /// Number of the first such block, from 1.
    pub block: usize,
    /// What it does.
    pub text: String,
    /// What helps.
    pub way_out: String,
}

impl MillingMachining<'_> {
    /// Reads a text and follows it; what the control does with led tips is the nearest of all positions.
    ///
    /// # Errors
    /// [`RunFailure`]: a text that is no program, blocks that no milling program has, a tool that the work does not have.
    pub fn follow_text(
        &self,
        work: &MillingWork<'_>,
        text: impl BufRead,
        dialect: Dialect,
    ) -> Result<CheckedMotion, RunFailure> {
        let name = match dialect {
            Dialect::LinuxCnc => DialectName::Linuxcnc,
            Dialect::Siemens => DialectName::Siemens,
            Dialect::Fanuc => DialectName::Fanuc,
        };
        let (setup, _) = self.setup(&all_passes(work)?)?;
        let words = self.words(&setup, control_of(self.machine, name)?)?;
        let found = read(text, dialect, &words.words).map_err(|error| {
            let text = format!("no program for {}: {error}", dialect.name());
            let finding = Diagnostic::with_code(error.code(), text).allowed(error.allowed);
            RunFailure::bad_input(finding.way_out(error.way_out()))
        })?;
        let held = Held::of(self, &setup, &words)?;
        let follower = Follower { setup: &setup, words: &words, work, held: &held, dialect };
        let refused = |error: MotionError| -> RunFailure { RunFailure::bad_input(Diagnostic::of(&error)) };
        let moves = follower.follow(&found.blocks).map_err(refused)?;
        if moves.is_empty() {
            return Err(refused(MotionError::NotFollowed { block: 1, reason: "it moves no tool".into() }));
        }
        let mut walk = Walk::new(&setup);
        for made in &moves {
            if !work.tools.iter().any(|tool| tool.tool.number == made.tool) {
                let numbers: Vec<String> =
                    work.tools.iter().map(|tool| tool.tool.number.to_string()).collect();
                let text = format!("the program takes tool {}, which the job does not have", made.tool);
                let finding = Diagnostic::with_code("unknown-tool", text).allowed(numbers.join(", "));
                let finding = finding.way_out("call the tools by the numbers of the job's cutters");
                return Err(RunFailure::bad_input(finding));
            }
            if let Some(last) = made.places.last() {
                walk.go(last, made)?;
            }
        }
        let Walk { ranges, ways, speeds, duration, remarks, limits, .. } = walk;
        Ok(CheckedMotion { read: found, moves, ranges, ways, speeds, duration, words, remarks, limits })
    }
}

/// The axes along the motions of a text.
struct Walk<'a> {
    setup: &'a MillingSetup<'a>,
    at: Option<Positions>,
    ranges: Vec<Option<[f64; 2]>>,
    ways: Vec<f64>,
    speeds: Vec<f64>,
    duration: f64,
    remarks: Vec<Remark>,
    limits: Vec<AxisFault>,
    /// Axes with a fault: beyond the travel, too fast.
    faulty: Vec<[bool; 2]>,
}

/// Blocks of a hundredth of a millimetre with the usual four decimals: by so much of its speed an axis seems too fast where the plan
/// is at its limit.
pub const ROUNDING: f64 = 0.01;

impl<'a> Walk<'a> {
    fn new(setup: &'a MillingSetup<'a>) -> Self {
        let count = setup.machine().axes().len();
        Self {
            setup,
            at: None,
            ranges: vec![None; count],
            ways: vec![0.0; count],
            speeds: vec![0.0; count],
            duration: 0.0,
            remarks: Vec::new(),
            limits: Vec::new(),
            faulty: vec![[false; 2]; count],
        }
    }

    /// To the end of a motion.
    fn go(&mut self, end: &CutterPlace, made: &FollowedMove) -> Result<(), RunFailure> {
        let (at, seconds) = (made.at, made.seconds);
        let from = self.at;
        let to = match at {
            Some(at) => at,
            None => {
                let tip = Point::from_vector(end.tip);
                let place = Place { contact: tip, tip, axis: Direction::from_vector(end.axis.normalize()) };
                match choose(self.setup, &[place], &from.unwrap_or_default(), PoleStrategy::Slow) {
                    Ok(course) => course.nodes[0],
                    Err(MotionError::Place { error, .. }) => {
                        // One remark says it; the next hundred places would say the same.
                        if self.remarks.is_empty() {
                            self.remarks.push(Remark {
                                code: error.code(),
                                text: format!("under tip control: {error}"),
                                way_out: error.way_out().into(),
                            });
                        }
                        return Ok(());
                    }
                    Err(error) => return Err(of_motion(&error, "")),
                }
            }
        };
        let taken = match (seconds, &from) {
            (Some(seconds), _) => seconds,
            (None, Some(from)) => rapid_seconds(self.setup, from, &to),
            (None, None) => 0.0,
        };
        self.duration += taken;
        let axes = self.setup.axes();
        for axis in axes.rotary.into_iter().chain(axes.linear) {
            let [low, high] = self.ranges[axis].unwrap_or([to[axis]; 2]);
            self.ranges[axis] = Some([low.min(to[axis]), high.max(to[axis])]);
            let way = from.map_or(0.0, |from| (to[axis] - from[axis]).abs());
            self.ways[axis] += way;
            if let Some(seconds) = seconds.filter(|seconds| *seconds > 0.0) {
                self.speeds[axis] = self.speeds[axis].max(way / seconds);
                self.too_fast(axis, way / seconds, made.block);
            }
            self.beyond(axis, to[axis], made.block);
        }
        self.at = Some(to);
        Ok(())
    }

    fn beyond(&mut self, number: usize, value: f64, block: usize) {
        let axis = &self.setup.machine().axes()[number];
        let Some(error) = axis.beyond(value).filter(|_| !self.faulty[number][0]) else { return };
        self.faulty[number][0] = true;
        let text = error.to_string();
        self.limits.push(AxisFault { code: error.code(), block, text, way_out: error.way_out().into() });
    }

    fn too_fast(&mut self, number: usize, speed: f64, block: usize) {
        let axis = &self.setup.machine().axes()[number];
        let most = axis.limits.velocity.filter(|most| speed > most * (1.0 + ROUNDING));
        let Some(most) = most.filter(|_| !self.faulty[number][1]) else { return };
        self.faulty[number][1] = true;
        let [moves, allows] = [speed, most].map(|value| axis.joint.shown(value));
        let (name, unit) = (&axis.name, axis.joint.unit());
        let text =
            format!("{name} would move at {moves:.4} {unit}/s; the machine allows {allows:.4} {unit}/s");
        let way_out = "give the block more time: the control slows down all axes of it".into();
        self.limits.push(AxisFault { code: "axis-too-fast", block, text, way_out });
    }
}
