//! From work to texts: laid out for every control, written, read back, proven.

use super::course::Course;
use super::failure::{invalid, of_motion};
use super::measuring::{MeasuringCourse, Recording, measuring_course};
use super::proof::{OWN_ROUNDING, Proof, prove};
use super::scan::{ScanCourse, Scanned, scan_course};
use super::scan_proof::prove_scans;
use super::target::{Target, bound, plain, planned};
use super::task::{MeasuringWork, ScanWork, ToolMachining};
use job::tables::Program as DialectName;
use machine::Positions;
use motion::{AxisWords, track};
use nc::{Block, Checked, Dialect, Program, RoundingBound, Written, write_checked};
use run::RunFailure;
use run::program_check::{dialect_of, ending_of};

/// One program.
#[derive(Clone, Debug)]
pub struct ToolProgram {
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
    /// Blocks that move.
    pub blocks: usize,
    /// Time of all blocks, rapid ones at the greatest speeds of the axes, s.
    pub duration: f64,
    /// What is recorded at a light barrier, in the order of the text.
    pub recordings: Vec<Recording>,
    /// What is scanned by a stylus, in the order of the text.
    pub scanned: Vec<Scanned>,
    /// What rounding of the numbers does at most.
    pub rounding: RoundingBound,
    /// What was proven.
    pub proof: Proof,
    /// Angles of the axis that turns the tool as the control counts them: this times those of the machine.
    pub(super) nc_sign: f64,
}

/// Programs that measure all tracks at the light barrier, one for each dialect.
///
/// # Errors
/// [`RunFailure`]: numbers out of range; poses beyond a travel or the reach of the axes, with flank, track and axis; a beam that is not
/// free between the poses; a control that cannot say it; a text that is not proven, so that nothing is to be written.
pub fn measuring_programs(
    work: &MeasuringWork<'_>,
    machining: &ToolMachining<'_>,
) -> Result<Vec<ToolProgram>, RunFailure> {
    let made = |&name: &DialectName| {
        let (laid, target) = laid_measuring(work, machining, dialect_of(name))?;
        let heading = format!("{} MEASURING THE TOOL", plain(work.name));
        let mut made = written(&laid.course, &target, machining, (work.name, "measuring", &heading))?;
        let lever = laid.lever + work.beam.radius;
        made.rounding = bound(&made.program, &target, lever)?;
        made.proof = measured(&laid, &target, work, machining, (&made.read, made.rounding))?;
        made.recordings = laid.recordings;
        Ok(made)
    };
    machining.dialects.iter().map(made).collect()
}

/// Programs that scan the edges of some teeth with a stylus, one for each dialect.
///
/// # Errors
/// As [`measuring_programs`]; poses that the stylus does not take.
pub fn scan_programs(
    work: &ScanWork<'_>,
    machining: &ToolMachining<'_>,
) -> Result<Vec<ToolProgram>, RunFailure> {
    let made = |&name: &DialectName| {
        let (laid, target) = laid_scan(work, machining, dialect_of(name))?;
        let heading = format!("{} SCANNING THE TOOL", plain(work.name));
        let mut made = written(&laid.course, &target, machining, (work.name, "scan", &heading))?;
        let lever = laid.lever + work.stylus.radius;
        made.rounding = bound(&made.program, &target, lever)?;
        made.proof = scanned(&laid, &target, work, machining, (&made.read, made.rounding))?;
        made.scanned = laid.scanned;
        Ok(made)
    };
    machining.dialects.iter().map(made).collect()
}

/// Proves any text against a measurement.
///
/// # Errors
/// [`RunFailure`]: a text that is no program or measures something else.
pub fn prove_measuring(
    work: &MeasuringWork<'_>,
    machining: &ToolMachining<'_>,
    dialect: Dialect,
    text: &str,
) -> Result<Proof, RunFailure> {
    let (laid, target) = laid_measuring(work, machining, dialect)?;
    let program = planned(&laid.course, &target, machining, (work.name, ""))?;
    let bound = bound(&program, &target, laid.lever + work.beam.radius)?;
    measured(&laid, &target, work, machining, (&target.read(text)?.blocks, bound))
}

/// Proves any text against a scan.
///
/// # Errors
/// As [`prove_measuring`].
pub fn prove_scan(
    work: &ScanWork<'_>,
    machining: &ToolMachining<'_>,
    dialect: Dialect,
    text: &str,
) -> Result<Proof, RunFailure> {
    let (laid, target) = laid_scan(work, machining, dialect)?;
    let program = planned(&laid.course, &target, machining, (work.name, ""))?;
    let bound = bound(&program, &target, laid.lever + work.stylus.radius)?;
    scanned(&laid, &target, work, machining, (&target.read(text)?.blocks, bound))
}

pub(super) fn laid_measuring<'a>(
    work: &MeasuringWork<'_>,
    machining: &ToolMachining<'a>,
    dialect: Dialect,
) -> Result<(MeasuringCourse<'a>, Target<'a>), RunFailure> {
    machining.check()?;
    work.check()?;
    let laid = measuring_course(work, machining, dialect.stands_to_switch())?;
    let target = Target::new(machining, dialect, &laid.course)?;
    Ok((laid, target))
}

pub(super) fn laid_scan<'a>(
    work: &ScanWork<'_>,
    machining: &ToolMachining<'a>,
    dialect: Dialect,
) -> Result<(ScanCourse<'a>, Target<'a>), RunFailure> {
    machining.check()?;
    work.check()?;
    let laid = scan_course(work, machining)?;
    let target = Target::new(machining, dialect, &laid.course)?;
    Ok((laid, target))
}

fn measured(
    laid: &MeasuringCourse<'_>,
    target: &Target<'_>,
    work: &MeasuringWork<'_>,
    machining: &ToolMachining<'_>,
    (blocks, bound): (&[Block], RoundingBound),
) -> Result<Proof, RunFailure> {
    let moves = target.moves(machining, blocks)?;
    prove(laid, work, &moves, [bound.distance + OWN_ROUNDING, target.half_angle()])
}

fn scanned(
    laid: &ScanCourse<'_>,
    target: &Target<'_>,
    work: &ScanWork<'_>,
    machining: &ToolMachining<'_>,
    (blocks, bound): (&[Block], RoundingBound),
) -> Result<Proof, RunFailure> {
    let moves = target.moves(machining, blocks)?;
    prove_scans(laid, work, &moves, bound.distance + OWN_ROUNDING)
}

/// Text and read-back of a course; what its kind proves is left open.
fn written(
    course: &Course<'_>,
    target: &Target<'_>,
    machining: &ToolMachining<'_>,
    (name, kind, heading): (&str, &str, &str),
) -> Result<ToolProgram, RunFailure> {
    let machine = &machining.machine.machine;
    let program = planned(course, target, machining, (name, heading.trim_start()))?;
    let Checked { written, read } =
        write_checked(&program, target.dialect, &target.options).map_err(|error| target.refused(&error))?;
    let tracked = track(&read.blocks, machine, &target.words, &Positions::default())
        .map_err(|error| of_motion(&error))?;
    for (axis, speed) in machine.axes().iter().zip(&tracked.speeds) {
        if axis.limits.velocity.is_some_and(|limit| *speed > limit * (1.0 + 1e-6)) {
            let shown = axis.joint.shown(*speed);
            return Err(invalid("retreat.speed", shown, "speeds that every axis can"));
        }
    }
    let (name, turning) = (target.dialect.name(), course.stander.turning);
    Ok(ToolProgram {
        dialect: target.dialect,
        file: format!("programs/{kind}-{name}.{}", ending_of(target.dialect)),
        blocks: program.blocks().iter().filter(|block| block.moves()).count(),
        duration: tracked.duration,
        program,
        written,
        words: target.words.clone(),
        read: read.blocks,
        recordings: Vec::new(),
        scanned: Vec::new(),
        rounding: RoundingBound { distance: 0.0, block: 0, places: 0.0, angles: 0.0 },
        proof: Proof::new(0.0),
        nc_sign: machine.axes()[turning].nc_sign,
    })
}
