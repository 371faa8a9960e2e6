//! Any text of any origin held against a measurement or a scan of a job: followed, and judged by what the axes do.

use super::build::{laid_calibration, laid_measuring, laid_probe, laid_scan, laid_skiving};
use super::calibration_proof;
use super::judge::{Between, Judged, beside, follow, limits, recordings, scans};
use super::probe_proof;
use super::proof::OWN_ROUNDING;
use super::skive::work_turning;
use super::skive_proof;
use super::target::{bound, planned};
use super::task::{CalibrationWork, MeasuringWork, ProbeWork, ScanWork, SkivingWork, ToolMachining};
use machine::Joint;
use motion::AxisWords;
use nc::{Block, Dialect};
use run::RunFailure;
use verdict::Remark;

/// A text as read, with the words of its axes.
#[derive(Clone, Copy, Debug)]
pub struct TextBlocks<'a> {
    /// Its control.
    pub dialect: Dialect,
    /// Words of the machine's axes on it.
    pub words: &'a AxisWords,
    /// What a reader found.
    pub blocks: &'a [Block],
}

/// What a text does for a job. mm.
#[derive(Clone, Debug)]
pub struct TextJudgement {
    /// Recordings or edges that are as the job wants them, and how many it wants.
    pub sound: [usize; 2],
    /// Greatest way of the flank between where the ideal tool touches and its nominal place.
    pub difference: f64,
    /// Greatest distance of the beam's axis from where the contacts want it.
    pub axis_distance: f64,
    /// What digits explain of both.
    pub allowed: f64,
    /// What is wrong, each with its block.
    pub faults: Vec<Remark>,
}

impl TextJudgement {
    fn new(judged: Judged, wanted: usize, allowed: f64, beside: Vec<Remark>) -> Self {
        let Judged { sound, difference, axis_distance, mut faults } = judged;
        faults.extend(beside);
        Self { sound: [sound, wanted], difference, axis_distance, allowed, faults }
    }
}

/// Holds a text against a measurement.
///
/// # Errors
/// [`RunFailure`]: a job whose measurement the machine cannot make.
pub fn check_measuring(
    work: &MeasuringWork<'_>,
    machining: &ToolMachining<'_>,
    text: &TextBlocks<'_>,
) -> Result<TextJudgement, RunFailure> {
    let (laid, target) = laid_measuring(work, machining, text.dialect)?;
    let program = planned(&laid.course, &target, machining, (work.name, ""))?;
    let allowed = bound(&program, &target, laid.lever + work.beam.radius)?.distance + OWN_ROUNDING;
    let followed = follow(
        text.blocks,
        (&machining.machine.machine, &laid.course.stander.axes),
        text.words,
        machining.output,
    );
    let digits = [allowed, target.half_angle()];
    let judged = recordings(&laid, work, &followed, digits, text.dialect.stands_to_switch())?;
    let poses = work.flanks.iter().flat_map(|(_, of)| of.tracks.iter().map(|(_, pose)| *pose)).collect();
    let between = Between { course: &laid.course, poses, stylus: false };
    let beside = beside(&followed, &laid.course.stander, &between)?;
    Ok(TextJudgement::new(judged, laid.recordings.len(), allowed, beside))
}

/// Holds a text against a scan.
///
/// # Errors
/// As [`check_measuring`].
pub fn check_scan(
    work: &ScanWork<'_>,
    machining: &ToolMachining<'_>,
    text: &TextBlocks<'_>,
) -> Result<TextJudgement, RunFailure> {
    let (laid, target) = laid_scan(work, machining, text.dialect)?;
    let program = planned(&laid.course, &target, machining, (work.name, ""))?;
    let allowed = bound(&program, &target, laid.lever + work.stylus.radius)?.distance + OWN_ROUNDING;
    let followed = follow(
        text.blocks,
        (&machining.machine.machine, &laid.course.stander.axes),
        text.words,
        machining.output,
    );
    let judged = scans(&laid, work, &followed, allowed)?;
    let poses = laid.scanned.iter().flat_map(|of| of.places.iter().map(|place| place.pose)).collect();
    let between = Between { course: &laid.course, poses, stylus: true };
    let beside = beside(&followed, &laid.course.stander, &between)?;
    Ok(TextJudgement::new(judged, laid.scanned.len(), allowed, beside))
}

/// Holds a text against a calibration.
///
/// # Errors
/// As [`check_measuring`].
pub fn check_calibration(
    work: &CalibrationWork<'_>,
    machining: &ToolMachining<'_>,
    text: &TextBlocks<'_>,
) -> Result<TextJudgement, RunFailure> {
    let (laid, target) = laid_calibration(work, machining, text.dialect)?;
    let program = planned(&laid.course, &target, machining, (work.name, ""))?;
    let allowed = bound(&program, &target, laid.lever)?.distance + OWN_ROUNDING;
    let machine = &machining.machine.machine;
    let followed = follow(text.blocks, (machine, &laid.course.stander.axes), text.words, machining.output);
    let judged = calibration_proof::judged(&laid, work, &followed, allowed)?;
    Ok(TextJudgement::new(judged, laid.ways.len(), allowed, limits(&followed, machine)))
}

/// Holds a text against a measurement of the workpiece.
///
/// # Errors
/// As [`check_measuring`].
pub fn check_probe(
    work: &ProbeWork<'_>,
    machining: &ToolMachining<'_>,
    text: &TextBlocks<'_>,
) -> Result<TextJudgement, RunFailure> {
    let (laid, target) = laid_probe(work, machining, text.dialect)?;
    let program = planned(&laid.course, &target, machining, (work.name, ""))?;
    let allowed = bound(&program, &target, laid.lever)?.distance + OWN_ROUNDING;
    let machine = &machining.machine.machine;
    let followed = follow(text.blocks, (machine, &laid.course.stander.axes), text.words, machining.output);
    let (judged, _) = probe_proof::judged(&laid, work, &followed, allowed)?;
    Ok(TextJudgement::new(judged, laid.profiles.len(), 4.0 * allowed, limits(&followed, machine)))
}

/// Whether a text turns the workpiece while its output is on, as a probe does.
pub fn looks_like_probe(machining: &ToolMachining<'_>, text: &TextBlocks<'_>) -> bool {
    let machine = &machining.machine.machine;
    let Ok((turning, _)) = work_turning(machine) else { return false };
    let mut axes = machine.tool().axes.clone();
    axes.push(turning);
    let followed = follow(text.blocks, (machine, &axes), text.words, machining.output);
    let mut recorded =
        followed.stretches.iter().flat_map(|stretch| &followed.motions[stretch.motions.clone()]);
    recorded.any(|motion| motion.from.is_some_and(|from| from[turning] != motion.to[turning]))
}

/// Holds a text against a stroke. The flank that it leaves is not rolled again.
///
/// # Errors
/// As [`check_measuring`].
pub fn check_skiving(
    work: &SkivingWork<'_>,
    machining: &ToolMachining<'_>,
    text: &TextBlocks<'_>,
) -> Result<TextJudgement, RunFailure> {
    let (laid, target) = laid_skiving(work, machining, text.dialect)?;
    let program = planned(&laid.course, &target, machining, (work.name, ""))?;
    let allowed = bound(&program, &target, laid.lever)?.distance + OWN_ROUNDING;
    let machine = &machining.machine.machine;
    let followed = follow(text.blocks, (machine, &laid.course.stander.axes), text.words, machining.output);
    let stroke = skive_proof::judged(&laid, work, &followed, allowed)?;
    Ok(TextJudgement::new(stroke.judged, 1, 4.0 * allowed, limits(&followed, machine)))
}

/// Whether a text moves linear axes alone while its output is on, one at a time, as a calibration does.
pub fn looks_like_calibration(machining: &ToolMachining<'_>, text: &TextBlocks<'_>) -> bool {
    let machine = &machining.machine.machine;
    let followed = follow(text.blocks, (machine, &machine.tool().axes), text.words, machining.output);
    let (mut alone, mut others) = (0, 0);
    let recorded = followed.stretches.iter().flat_map(|stretch| &followed.motions[stretch.motions.clone()]);
    for motion in recorded {
        let Some(from) = motion.from else { continue };
        let moved: Vec<usize> =
            (0..machine.axes().len()).filter(|&axis| motion.to[axis] != from[axis]).collect();
        let linear = moved.iter().all(|&axis| machine.axes()[axis].joint == Joint::Linear);
        *(if linear && moved.len() == 1 { &mut alone } else { &mut others }) += 1;
    }
    alone > others
}

/// Whether a text moves more than the spindle while its output is on, as a scan does.
pub fn looks_like_scan(machining: &ToolMachining<'_>, text: &TextBlocks<'_>) -> bool {
    let machine = &machining.machine.machine;
    let Ok((turning, _)) = machine.tool_turning() else { return false };
    let followed = follow(text.blocks, (machine, &machine.tool().axes), text.words, machining.output);
    let of_stretches =
        followed.stretches.iter().flat_map(|stretch| &followed.motions[stretch.motions.clone()]);
    let (mut alone, mut together) = (0, 0);
    for motion in of_stretches {
        let Some(from) = motion.from else { continue };
        let others = machine.tool().axes.iter().any(|&axis| axis != turning && motion.to[axis] != from[axis]);
        *(if others { &mut together } else { &mut alone }) += 1;
    }
    together > alone
}
