//! From passes to the neutral program: approach, infeed, stroke, retraction, repetition, coupling, time (`docs/mathematics/programs.md`).

use super::path::AxisPath;
use super::speed::Braked;
use super::trace::AxisTrace;
use super::{AxisWords, Course, LineCourse, MotionError};
use machine::{Machine, Station};
use nc::Program;

mod gear;
mod passes;

pub use passes::in_words;

/// One pass of the tool.
#[derive(Clone, Debug)]
pub struct Pass {
    /// Its name, as comments have it: capital letters, digits, blanks.
    pub name: String,
    /// What the bodies do.
    pub course: Course,
    /// Path parameter at the start and the end of the working part, in driving order, mm.
    pub range: [f64; 2],
    /// Least way before and behind the working part, mm.
    pub room: [f64; 2],
    /// Speed of the path parameter, mm/s.
    pub speed: f64,
    /// How far the tool stands off before and after, mm of centre distance.
    pub clearance: f64,
    /// Pause after it, s.
    pub dwell: f64,
}

/// All lines of a disc on one thread of the worm, one after the other.
pub struct LinePass<'a> {
    /// Its name, as comments have it.
    pub name: String,
    /// How many lines, at least one.
    pub count: usize,
    /// A line by its number in driving order, from 0.
    pub line: &'a (dyn Fn(usize) -> Result<LineCourse, MotionError> + Sync),
    /// Screw parameter of the worm, mm/rad.
    pub screw: f64,
    /// Greatest speed of the disc on its way against the worm, mm/s.
    pub speed: f64,
    /// Lift with which the disc goes over from one line to the next inside the thread space, mm of centre distance.
    pub hop: f64,
    /// Lift that brings the disc out of the thread space, mm, above `hop`.
    pub clearance: f64,
}

/// The gear of an electronic gearbox that leads the workpiece.
#[derive(Clone, Debug, PartialEq)]
pub struct WorkGear {
    /// Couplings of the bodies.
    pub coupling: machine::GearCoupling,
    /// Numbers of the axes that it can take as leading ones; empty: all.
    pub leaders: Vec<usize>,
}

/// How the rotations of tool and workpiece are kept together.
#[derive(Clone, Debug, PartialEq)]
pub enum Coupling {
    /// Every axis is given in every block.
    Blocks,
    /// The control's gearbox leads the workpiece.
    Gearbox(WorkGear),
}

/// How a program is laid out.
#[derive(Clone, Debug)]
pub struct LayoutOptions {
    /// Name of the program: [A-Z0-9_]{1,24}.
    pub name: String,
    /// Comments at its head.
    pub comments: Vec<String>,
    /// Largest deviation of straight blocks, on the flank, mm.
    pub tolerance: f64,
    /// Angle of the dresser's swivel, rad.
    pub swivel: f64,
    /// Coupling of the workpiece.
    pub coupling: Coupling,
    /// Speed of the dresser's spindle, rad/s; 0 for none.
    pub dresser_speed: f64,
    /// Half a unit of the last digit of lengths (mm) and angles (rad).
    pub half_unit: [f64; 2],
}

/// What became of a pass.
#[derive(Clone, Debug, PartialEq)]
pub struct PassReport {
    /// Its name.
    pub name: String,
    /// Path parameter from where to where it is driven, run-in and run-out included, mm.
    pub driven: [f64; 2],
    /// Straight blocks of the stroke.
    pub blocks: usize,
    /// Speed of the path parameter, mm/s.
    pub speed: f64,
    /// What slowed it down, if anything.
    pub braked: Option<Braked>,
    /// Largest deviation of the blocks from the course, on the flank, mm.
    pub chord_deviation: f64,
    /// Blocks of the working part that a control without look-ahead over several blocks takes longer for: shorter than twice the time
    /// in which an axis reaches its speed (`docs/mathematics/programs.md#the-independent-reader`).
    pub short_blocks: usize,
    /// What the rounding of the numbers may add, mm.
    pub rounding: f64,
    /// Time with the pause after it, s.
    pub time: f64,
    /// Path of the stroke.
    pub path: AxisPath,
}

/// A program with what it does.
#[derive(Clone, Debug)]
pub struct Layout {
    /// The program.
    pub program: Program,
    /// Its axes over time.
    pub trace: AxisTrace,
    /// The passes.
    pub passes: Vec<PassReport>,
    /// Axes without a word, at rest: number and position.
    pub at_rest: Vec<(usize, f64)>,
}

/// An axis that moves by less than this (mm or rad) over a program stands still.
const STANDS_STILL: f64 = 1e-9;

/// Lays out all passes of a station one after the other.
///
/// # Errors
/// [`MotionError`].
pub fn lay_out(
    machine: &Machine,
    words: &AxisWords,
    passes: &[Pass],
    options: &LayoutOptions,
) -> Result<Layout, MotionError> {
    let mut writer = passes::Writer::new(machine, words, options)?;
    for pass in passes {
        writer.pass(pass)?;
    }
    writer.finish(passes.first().map(|pass| pass.course.station()))
}

/// Lays out the lines of a disc on all threads one after the other.
///
/// # Errors
/// [`MotionError`].
pub fn lay_out_lines(
    machine: &Machine,
    words: &AxisWords,
    passes: &[LinePass<'_>],
    options: &LayoutOptions,
) -> Result<Layout, MotionError> {
    let mut writer = passes::Writer::new(machine, words, options)?;
    for pass in passes {
        writer.lines(pass)?;
    }
    writer.finish((!passes.is_empty()).then_some(Station::Dresser))
}
