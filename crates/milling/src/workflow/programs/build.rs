//! From the work to programs: driven once for every way of leading the tip, written for every control, read back and compared with
//! what was planned.

use super::blocks::{Blocks, Control as BlocksFor, Expected};
use super::drive::{Driver, Lead};
use super::failure::{invalid, not_proven, of_motion, of_writer};
use super::follow::{FollowedMove, Follower};
use super::held::Held;
use super::held_clocking::HeldClocking;
use super::passes::{ToolPasses, all_passes};
use super::steps::{DrivenMotion, Step, StepKind};
use super::task::{MillingMachining, MillingWork, clamping};
use crate::job::Rtcp;
use foundation::kinematics::{Direction, Point};
use job::Diagnostic;
use job::machine::Control;
use job::tables::Program as DialectName;
use machine::{Positions, Station};
use motion::milling::{MillingSetup, TiltedMount};
use motion::{AxisWords, MotionError};
use nalgebra::Vector3;
use nc::{
    Block, Checked, Decimals, Dialect, FanucOptions, FeedWords, Header, NcError, Program, RoundingBound,
    WriteOptions, Written, rounding_bound, write_checked,
};
use run::RunFailure;
use run::program_check::{control_of, decimals_of, dialect_of, ending_of, words_for};
use std::sync::Arc;

/// One program.
#[derive(Clone, Debug)]
pub struct MillingProgram {
    /// The control.
    pub dialect: Dialect,
    /// Path below the directory of the run.
    pub file: String,
    /// The neutral program.
    pub program: Program,
    /// The text.
    pub written: Written,
    /// Axes and words.
    pub words: AxisWords,
    /// What an independent reader found in the text.
    pub read: Vec<Block>,
    /// What rounding of the numbers does at most.
    pub rounding: RoundingBound,
    /// Blocks that move.
    pub blocks: usize,
    /// Times, positions and figures; programs whose tips are led in the same way share them.
    pub motion: Arc<DrivenMotion>,
    /// Largest difference of a place in the text from the planned one: mm at the tip, rad of the axis.
    pub read_difference: [f64; 2],
    /// The motions of the text on the workpiece.
    pub(super) moves: Vec<FollowedMove>,
    /// What they belong to.
    pub(super) expected: Vec<Expected>,
}

/// All programs of a job.
#[derive(Clone, Debug)]
pub struct MillingPrograms {
    /// In the order of the job's dialects.
    pub programs: Vec<MillingProgram>,
    /// How the workpiece is tilted, where the pole asks for it.
    pub tilt: Option<TiltedMount>,
    /// What the control holds for the clocking angle of the workpiece, where it does.
    pub clocking: Option<HeldClocking>,
    /// Distance of a cutting point from the tip of its tool at most, mm.
    pub(super) lever: f64,
}

/// How far rounding of the comparison's own numbers goes, mm and rad: coordinates of some 1000 mm.
const OWN_ROUNDING: f64 = 1e-9;
/// Numbers of lines go in these steps.
const LINE_STEP: u32 = 10;

impl MillingMachining<'_> {
    /// Drives, lays out, writes and reads back the programs of all dialects.
    ///
    /// # Errors
    /// [`RunFailure`]: a machine or a control that cannot do it, places beyond the travels, a text that does not say what was planned.
    pub fn build(&self, work: &MillingWork<'_>) -> Result<MillingPrograms, RunFailure> {
        if !(self.position_tolerance.is_finite() && self.position_tolerance > 0.0) {
            return Err(invalid("machine.position_tolerance_um", self.position_tolerance * 1e3, "above 0"));
        }
        let passes = all_passes(work)?;
        if passes.is_empty() {
            return Err(invalid("milling", 0.0, "one path or more"));
        }
        let (setup, tilt) = self.setup(&passes)?;
        let clocking = self.held_clocking.map(|angle| HeldClocking::of(&setup, angle)).transpose()?;
        let lever = lever(&passes, work);
        let mut driven: Vec<(Lead, Arc<DrivenMotion>)> = Vec::new();
        let mut programs = Vec::new();
        for &name in self.dialects {
            let control = control_of(self.machine, name)?;
            // Before what takes long.
            Held::of(self, &setup, &self.words(&setup, control)?)?;
            let lead = self.lead(name);
            let motion = match driven.iter().find(|(known, _)| *known == lead) {
                Some((_, motion)) => motion.clone(),
                None => {
                    let (tip_tolerance, at_pole) = (self.position_tolerance, self.at_pole);
                    let end = self.end_position;
                    let driver = Driver { setup: &setup, work, lead, tip_tolerance, at_pole, end };
                    let motion = Arc::new(driver.drive(&passes)?);
                    driven.push((lead, motion.clone()));
                    motion
                }
            };
            let reach = self.farthest(&setup, &motion, lever).map_err(|error| of_motion(&error, ""))?;
            let lever = [reach, lever];
            let made =
                self.program(work, &setup, (dialect_of(name), control), motion, lever, tilt.is_some())?;
            programs.push(made);
        }
        Ok(MillingPrograms { programs, tilt, clocking, lever })
    }

    /// The workpiece on the machine, tilted where the pole asks for it.
    pub(super) fn setup(
        &self,
        passes: &[ToolPasses],
    ) -> Result<(MillingSetup<'_>, Option<TiltedMount>), RunFailure> {
        let length = passes.first().map_or(0.0, |passes| passes.tool.length);
        let setup = MillingSetup::new(&self.machine.machine, clamping(&self.mount), length)
            .map_err(|error| of_motion(&error, ""))?;
        let tilt = self.at_pole.tilt(&setup, passes)?;
        Ok((tilt.map_or_else(|| setup.clone(), |tilt| setup.clamped(tilt.clamping)), tilt))
    }

    fn lead(&self, name: DialectName) -> Lead {
        let can = name != DialectName::Linuxcnc;
        Lead { by_control: can && self.rtcp != Rtcp::Off, screw_rows: self.rtcp == Rtcp::Rows }
    }

    /// The words of the five axes on a control.
    pub(super) fn words(&self, setup: &MillingSetup<'_>, control: &Control) -> Result<AxisWords, RunFailure> {
        let machine = &self.machine.machine;
        let axes = machine.axes_at(Station::Work).map_err(|error| of_motion(&error.into(), ""))?;
        let words = words_for(self.machine, Some(control), &axes).map_err(|error| of_motion(&error, ""))?;
        let five = setup.axes().rotary.into_iter().chain(setup.axes().linear);
        match five.into_iter().find(|&axis| !words.is_moved(axis)) {
            None => Ok(words),
            Some(axis) => {
                let name = &machine.axes()[axis].name;
                let finding =
                    Diagnostic::with_code("axis-not-available", format!("{name} has no word on the control"))
                        .field("machine.file")
                        .way_out(format!("give {name} a letter in the machine description"));
                Err(RunFailure::bad_input(finding))
            }
        }
    }

    fn program(
        &self,
        work: &MillingWork<'_>,
        setup: &MillingSetup<'_>,
        (dialect, control): (Dialect, &Control),
        motion: Arc<DrivenMotion>,
        [from_axes, from_tip]: [f64; 2],
        tilted: bool,
    ) -> Result<MillingProgram, RunFailure> {
        let refused = |error: NcError| of_writer(&error, Some(dialect));
        let words = self.words(setup, control)?;
        let held = Held::of(self, setup, &words)?;
        let mut blocks = Blocks::new(
            setup,
            &words,
            BlocksFor {
                dialect,
                tip_control: self.tip_control,
                held: &held,
                spindle_dwell: self.spindle_dwell,
                work,
            },
        );
        let mut lines = comments(work.name, Some(self));
        if tilted {
            lines.push("WORKPIECE TILTED ON THE TABLE AS RESULT AND REPORT SAY".into());
        }
        blocks.blocks.extend(lines.into_iter().map(|line| Block::Comment(line.into())));
        blocks.motion(&motion);
        let Blocks { blocks, expected, .. } = blocks;
        let header = Header {
            name: program_name(work.name),
            axes: words.words.clone(),
            chord_tolerance: self.position_tolerance,
        };
        let program = Program::new(header, blocks).map_err(refused)?;
        let options = write_options(control);
        let decimals = options.decimals;
        let Checked { written, read } = write_checked(&program, dialect, &options).map_err(refused)?;
        let rounding = rounding_bound(&program, &options, from_axes, from_tip).map_err(refused)?;
        let follower = Follower { setup, words: &words, work, held: &held, dialect };
        let moves = follower
            .follow(&read.blocks)
            .map_err(|error| not_proven(format!("program for {}: {error}", dialect.name())))?;
        let half = |digits: u8| 0.5 * 10f64.powi(-i32::from(digits));
        let direction = (3f64.sqrt() * half(options.tip_decimals.direction)).asin();
        let angles = 2.0 * half(decimals.deg).to_radians();
        let allowed = [rounding.distance + OWN_ROUNDING, direction.max(angles) + OWN_ROUNDING];
        let read_difference = compared(dialect, &motion, &expected, &moves, allowed)?;
        Ok(MillingProgram {
            dialect,
            file: format!("programs/milling-{}.{}", dialect.name(), ending_of(dialect)),
            blocks: expected.len(),
            program,
            written,
            words,
            read: read.blocks,
            rounding,
            motion,
            read_difference,
            moves,
            expected,
        })
    }

    /// Greatest distance of a cutting point from an axis of rotation, mm: how fast the tip moves when the axis turns, and the lever.
    fn farthest(
        &self,
        setup: &MillingSetup<'_>,
        motion: &DrivenMotion,
        lever: f64,
    ) -> Result<f64, MotionError> {
        let rotary = setup.axes().rotary;
        let mut farthest = 0.0f64;
        // All spaces are turned copies of the first.
        let steps = motion.tools.iter().flat_map(|run| run.steps.iter().map(|step| (step, run.tool.length)));
        let of_space = |step: &Step| step.space == 0 && step.kind != StepKind::End;
        for (step, length) in steps.filter(|(step, _)| of_space(step)) {
            let tip = Point::new(0.0, 0.0, -length);
            let mut speeds = vec![0.0; self.machine.machine.axes().len()];
            for unit in [Vector3::x(), Vector3::y(), Vector3::z()] {
                let normal = Direction::from_vector(unit);
                for (axis, part) in self.machine.machine.influence(Station::Work, &step.at, &tip, &normal)? {
                    speeds[axis] += part * part;
                }
            }
            farthest = rotary.into_iter().map(|axis| speeds[axis].sqrt()).fold(farthest, f64::max);
        }
        Ok(farthest + lever)
    }
}

impl MillingProgram {
    /// The motions of the text on the workpiece.
    pub fn moves(&self) -> &[FollowedMove] {
        &self.moves
    }

    /// The axes at the ends of all blocks of the first space, with the time, s.
    pub fn first_space(&self) -> Vec<(f64, Positions)> {
        let mut time = 0.0;
        let steps = self.motion.tools.iter().flat_map(|run| &run.steps);
        let with_time = steps.map(|step: &Step| {
            time += step.seconds;
            (step, time)
        });
        let own = with_time.filter(|(step, _)| step.space == 0 && step.kind != StepKind::End);
        own.map(|(step, time)| (time, step.at)).collect()
    }
}

/// Compares the places of the text with the planned ones.
fn compared(
    dialect: Dialect,
    motion: &DrivenMotion,
    expected: &[Expected],
    moves: &[FollowedMove],
    allowed: [f64; 2],
) -> Result<[f64; 2], RunFailure> {
    let name = dialect.name();
    if expected.len() != moves.len() {
        let text =
            format!("program for {name}: {} motions in the text, {} planned", moves.len(), expected.len());
        return Err(not_proven(text));
    }
    let mut worst = [0.0f64; 2];
    for (k, (wanted, found)) in expected.iter().zip(moves).enumerate() {
        let [run, number] = wanted.step;
        let run = &motion.tools[run];
        let (step, last) = (&run.steps[number], found.places.last());
        let Some(last) = last.filter(|_| run.tool.number == found.tool) else {
            return Err(not_proven(format!("program for {name}: motion {} belongs to another tool", k + 1)));
        };
        let tip = (last.tip - step.place.tip.xyz).norm();
        let axis = last.axis.cross(&step.place.axis.xyz).norm().atan2(last.axis.dot(&step.place.axis.xyz));
        // Written so that NaN fails.
        let same = tip <= allowed[0] && axis <= allowed[1];
        if !same {
            return Err(not_proven(format!(
                "program for {name}: motion {} ends {:.4} um and {:.2e} deg away from the planned place; digits explain {:.4} um and \
                 {:.2e} deg",
                k + 1,
                tip * 1e3,
                axis.to_degrees(),
                allowed[0] * 1e3,
                allowed[1].to_degrees()
            )));
        }
        worst = [worst[0].max(tip), worst[1].max(axis)];
    }
    Ok(worst)
}

/// Greatest distance of a contact from the tip; where paths have no contact the tool's own size.
fn lever(tools: &[ToolPasses], work: &MillingWork<'_>) -> f64 {
    let first = tools.iter().flat_map(|tool| &tool.passes).filter(|pass| pass.space == 0);
    let mut lever = 0.0f64;
    for pass in first {
        let places = &pass.places[pass.cut()];
        let touched = places.iter().map(|at| (at.contact.xyz - at.tip.xyz).norm()).fold(0.0, f64::max);
        let length = work.tools.get(pass.operation).map_or(0.0, |tool| tool.cutter.cutting_length());
        lever = lever.max(if touched > 0.0 { touched } else { length });
    }
    lever
}

/// How programs of a control are written.
pub(super) fn write_options(control: &Control) -> WriteOptions {
    WriteOptions {
        decimals: decimals_of(control).unwrap_or(Decimals::MILLING),
        feed_words: FeedWords::AxisBlocks,
        line_numbers: Some(LINE_STEP),
        incremental_rotary: control.modulo,
        fanuc: FanucOptions {
            program_number: control.program_number.unwrap_or(1),
            contour_mode: control.contour_mode,
        },
        ..WriteOptions::default()
    }
}

/// [A-Z0-9_]{1,24} of the job's name and M.
pub(super) fn program_name(name: &str) -> String {
    let letter = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_uppercase() } else { '_' };
    let word: String = name.chars().map(letter).take(22).collect();
    format!("{word}_M")
}

/// What the head of a program says.
pub(super) fn comments(name: &str, machining: Option<&MillingMachining<'_>>) -> Vec<String> {
    let plain = |text: &str| -> String {
        let kept = text.to_ascii_uppercase();
        let letters = kept.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { ' ' });
        letters.take(60).collect::<String>().split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let mut lines = vec![format!("{} MILLING", plain(name)).trim().to_owned()];
    match machining {
        None => lines.push("COORDINATES OF THE WORKPIECE".into()),
        Some(machining) => {
            lines.push(format!("MACHINE {}", plain(&machining.machine.file.name)));
            if machining.mount.turned_over {
                lines.push("WORKPIECE CLAMPED UPSIDE DOWN".into());
            }
            match machining.work_offset {
                None => lines.push("COORDINATES OF THE TABLE".into()),
                Some(offset) => {
                    lines
                        .push(format!("COORDINATES FROM WORK OFFSET {} AS THE REPORT HAS IT", offset.number));
                }
            }
            lines.push("TOOLS COME AND GO FROM OUTSIDE".into());
        }
    }
    lines
}
