//! From work to texts: laid out for every control, written, read back, proven.

use super::calibration::{CalibrationCourse, MandrelWay, calibration_course};
use super::calibration_proof;
use super::course::Course;
use super::failure::{invalid, not_proven, of_motion};
use super::judge::follow;
use super::measuring::{MeasuringCourse, Recording, measuring_course};
use super::probe::{ProbeCourse, ProbedProfile, probe_course};
use super::probe_proof;
use super::proof::{OWN_ROUNDING, Proof, prove};
use super::scan::{ScanCourse, Scanned, scan_course};
use super::scan_proof::prove_scans;
use super::skive::{SkivingCourse, skiving_course};
use super::skive_proof;
use super::target::{Target, bound, plain, planned};
use super::task::{CalibrationWork, MeasuringWork, ProbeWork, ScanWork, SkivingWork, ToolMachining};
use job::tables::Program as DialectName;
use machine::Positions;
use motion::{AxisWords, track};
use nc::{Block, Checked, Dialect, Program, RoundingBound, Written, write_checked};
use run::RunFailure;
use run::program_check::{dialect_of, ending_of};

/// What two runs of the referee with nearly the same motion differ by, mm.
const REFEREE: f64 = 1e-7;

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
    /// Profiles of the workpiece that a probe scans, in the order of the text.
    pub probed: Vec<ProbedProfile>,
    /// Ways of a mandrel in the light barrier, in the order of the text.
    pub mandrel_ways: Vec<MandrelWay>,
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

/// Programs that drive a mandrel into the light barrier, one for each dialect.
///
/// # Errors
/// As [`measuring_programs`]; a mandrel that does not meet the beam.
pub fn calibration_programs(
    work: &CalibrationWork<'_>,
    machining: &ToolMachining<'_>,
) -> Result<Vec<ToolProgram>, RunFailure> {
    let made = |&name: &DialectName| {
        let (laid, target) = laid_calibration(work, machining, dialect_of(name))?;
        let heading = format!("{} CALIBRATING THE LIGHT BARRIER", plain(work.name));
        let mut made = written(&laid.course, &target, machining, (work.name, "calibration", &heading))?;
        made.rounding = bound(&made.program, &target, laid.lever)?;
        let allowed = made.rounding.distance + OWN_ROUNDING;
        let axes = &laid.course.stander.axes;
        let followed =
            follow(&made.read, (&machining.machine.machine, axes), &target.words, machining.output);
        let judged = calibration_proof::judged(&laid, work, &followed, allowed)?;
        if let Some(fault) = judged.faults.first() {
            return Err(not_proven(fault.text.clone()));
        }
        made.proof = Proof {
            difference: judged.difference,
            axis_distance: judged.axis_distance,
            ..Proof::new(allowed)
        };
        made.mandrel_ways = laid.ways;
        Ok(made)
    };
    machining.dialects.iter().map(made).collect()
}

/// Programs that scan the machined workpiece with a probe, one for each dialect.
///
/// # Errors
/// As [`measuring_programs`]; a ball that does not fit into the tooth space.
pub fn probe_programs(
    work: &ProbeWork<'_>,
    machining: &ToolMachining<'_>,
) -> Result<Vec<ToolProgram>, RunFailure> {
    let made = |&name: &DialectName| {
        let (laid, target) = laid_probe(work, machining, dialect_of(name))?;
        let heading = format!("{} MEASURING THE WORKPIECE", plain(work.name));
        let mut made = written(&laid.course, &target, machining, (work.name, "workpiece", &heading))?;
        made.rounding = bound(&made.program, &target, laid.lever)?;
        let allowed = made.rounding.distance + OWN_ROUNDING;
        let axes = &laid.course.stander.axes;
        let followed =
            follow(&made.read, (&machining.machine.machine, axes), &target.words, machining.output);
        let (judged, between) = probe_proof::judged(&laid, work, &followed, allowed)?;
        if let Some(fault) = judged.faults.first() {
            return Err(not_proven(fault.text.clone()));
        }
        made.proof = Proof {
            difference: judged.difference,
            axis_distance: judged.axis_distance,
            between_places: Some(between),
            ..Proof::new(4.0 * allowed)
        };
        made.probed = laid.profiles;
        Ok(made)
    };
    machining.dialects.iter().map(made).collect()
}

/// Programs of a finishing stroke, one for each dialect.
///
/// # Errors
/// As [`measuring_programs`]; a flank from the text that is not the planned one.
pub fn skiving_programs(
    work: &SkivingWork<'_>,
    machining: &ToolMachining<'_>,
) -> Result<Vec<ToolProgram>, RunFailure> {
    let made = |&name: &DialectName| {
        let (laid, target) = laid_skiving(work, machining, dialect_of(name))?;
        let heading = format!("{} SKIVING STROKE", plain(work.name));
        let mut made = written(&laid.course, &target, machining, (work.name, "skiving", &heading))?;
        made.rounding = bound(&made.program, &target, laid.lever)?;
        let allowed = made.rounding.distance + OWN_ROUNDING;
        let axes = &laid.course.stander.axes;
        let followed =
            follow(&made.read, (&machining.machine.machine, axes), &target.words, machining.output);
        let stroke = skive_proof::judged(&laid, work, &followed, allowed)?;
        if let Some(fault) = stroke.judged.faults.first() {
            return Err(not_proven(fault.text.clone()));
        }
        let flank = stroke.flank_difference(work)?;
        // Tooth by tooth the flank follows the axes about one to one.
        let explained = 2.0 * (stroke.between + 4.0 * allowed) + REFEREE;
        if let Some(difference) = flank.filter(|difference| difference.is_nan() || *difference > explained) {
            return Err(not_proven(format!(
                "the flank that the text leaves differs by {:.6} um from the planned one; straight blocks and digits explain {:.6} um",
                1e3 * difference,
                1e3 * explained
            )));
        }
        made.proof = Proof {
            difference: stroke.judged.difference,
            axis_distance: stroke.judged.axis_distance,
            between_places: Some(stroke.between),
            flank,
            ..Proof::new(4.0 * allowed)
        };
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

pub(super) fn laid_calibration<'a>(
    work: &CalibrationWork<'_>,
    machining: &ToolMachining<'a>,
    dialect: Dialect,
) -> Result<(CalibrationCourse<'a>, Target<'a>), RunFailure> {
    machining.check()?;
    work.check()?;
    let laid = calibration_course(work, machining)?;
    let target = Target::new(machining, dialect, &laid.course)?;
    Ok((laid, target))
}

pub(super) fn laid_probe<'a>(
    work: &ProbeWork<'_>,
    machining: &ToolMachining<'a>,
    dialect: Dialect,
) -> Result<(ProbeCourse<'a>, Target<'a>), RunFailure> {
    machining.check()?;
    work.check()?;
    let laid = probe_course(work, machining)?;
    let target = Target::new(machining, dialect, &laid.course)?;
    Ok((laid, target))
}

pub(super) fn laid_skiving<'a>(
    work: &SkivingWork<'_>,
    machining: &ToolMachining<'a>,
    dialect: Dialect,
) -> Result<(SkivingCourse<'a>, Target<'a>), RunFailure> {
    machining.check()?;
    let laid = skiving_course(work, machining)?;
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
        mandrel_ways: Vec::new(),
        probed: Vec::new(),
        rounding: RoundingBound { distance: 0.0, block: 0, places: 0.0, angles: 0.0 },
        proof: Proof::new(0.0),
        nc_sign: machine.axes()[turning].nc_sign,
    })
}
