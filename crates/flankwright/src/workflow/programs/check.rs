//! `program check`: what a program does on a machine: axes, travel, speed, time, strokes, and with a job the flank that it leaves.

use super::of_grinding::OnGrinding;
use super::of_tangential::OnTangential;
use super::result::{CheckedAxis, CheckedProgram};
use crate::exchange::machine::LoadedMachine;
use crate::exchange::{AnyJob, Diagnostic, GearboxJob, LoadedSkivingJob};
use crate::machine::{Positions, Role};
use crate::motion::{AxisWords, MotionError, Tracked, axis_words, track};
use crate::nc::{Dialect, MAXIMUM_BYTES, ReadError, ReadProgram, Word, read, read_with_netlist};
use crate::numerics::Progress;
use crate::workflow::finding::{Remark, RunFailure};
use crate::workflow::milling::check_milling;
use crate::workflow::skiving::prove_text;
use std::io::{BufRead, Read as _};

/// A program that cannot be read, as a finding with its place in the message.
fn unreadable(error: &ReadError, dialect: Dialect) -> RunFailure {
    // What is allowed stands beside the message.
    let told = error.to_string();
    let place = told.split("; allowed: ").next().unwrap_or_default();
    let text = format!("no program for {}: {place}", dialect.name());
    RunFailure::bad_input(
        Diagnostic::with_code(error.code(), text).allowed(error.allowed).way_out(error.way_out()),
    )
}

/// Axes that cannot be followed, as a finding.
pub(super) fn refused(error: &MotionError) -> RunFailure {
    let finding = Diagnostic::with_code(error.code(), error.to_string());
    RunFailure::bad_input(finding.way_out(error.way_out()))
}

/// The words that a control has for the axes of a machine.
///
/// # Errors
/// [`MotionError::InvalidWord`].
pub(super) fn words_of(machine: &LoadedMachine, dialect: Dialect) -> Result<AxisWords, MotionError> {
    let file = &machine.file;
    let control = file.controls.of(super::control::name_of(dialect));
    let all: Vec<usize> = (0..machine.machine.axes().len()).collect();
    axis_words(&machine.machine, &all, |name| {
        let own = control.and_then(|control| control.words.get(name)).map(String::as_str);
        own.or_else(|| file.axes.get(name).and_then(|axis| axis.letter.as_deref()))
    })
}

/// Reads a program of a dialect and follows it on a machine; with a job also to the flank. `netlist`: the HAL netlist of a LinuxCNC
/// program whose gears are in one.
///
/// # Errors
/// [`RunFailure`]: a text that is no program, axes that the machine has not, a job that cannot be planned.
pub fn check_program(
    (text, netlist): (impl BufRead, Option<&str>),
    dialect: Dialect,
    machine: &LoadedMachine,
    job: Option<&AnyJob>,
    progress: &dyn Progress,
) -> Result<CheckedProgram, RunFailure> {
    if let Some(AnyJob::Milling(loaded)) = job {
        // Under tip control the blocks say where the tool stands, which takes the job's mount and tools.
        return check_milling(text, dialect, machine, loaded, progress);
    }
    if let Some(AnyJob::Skiving(loaded)) = job {
        return check_measuring(text, dialect, machine, loaded, progress);
    }
    if let Some(AnyJob::Gearbox(_)) = job {
        return Err(RunFailure::bad_input(GearboxJob::refused_by("program check")));
    }
    ProgramChecker::new(machine, job, progress)?.check((text, netlist), dialect)
}

/// The bodies that a program is followed on.
enum Bodies {
    Grinding(Box<OnGrinding>),
    Tangential(Box<OnTangential>),
}

/// Checks any number of programs on one machine and, of grinding and tangential dressing, on the bodies of one job, whose own run is made
/// once.
pub struct ProgramChecker<'a> {
    machine: &'a LoadedMachine,
    bodies: Option<Bodies>,
}

impl<'a> ProgramChecker<'a> {
    /// On a machine alone, or with a job of grinding or tangential dressing; jobs of other processes have no bodies here.
    ///
    /// # Errors
    /// Those of the job's own run.
    pub fn new(
        machine: &'a LoadedMachine,
        job: Option<&AnyJob>,
        progress: &dyn Progress,
    ) -> Result<Self, RunFailure> {
        let bodies = match job {
            Some(AnyJob::Grinding(loaded)) => {
                Some(Bodies::Grinding(Box::new(OnGrinding::new(loaded, progress)?)))
            }
            Some(AnyJob::Tangential(loaded)) => {
                Some(Bodies::Tangential(Box::new(OnTangential::new(loaded, progress)?)))
            }
            Some(AnyJob::Gearbox(_) | AnyJob::Milling(_) | AnyJob::Skiving(_)) | None => None,
        };
        Ok(Self { machine, bodies })
    }

    /// Reads a program of a dialect and follows it; `netlist`: the HAL netlist of a LinuxCNC program whose gears are in one.
    ///
    /// # Errors
    /// [`RunFailure`]: a text that is no program, axes that the machine has not, no stroke on these bodies.
    pub fn check(
        &self,
        (text, netlist): (impl BufRead, Option<&str>),
        dialect: Dialect,
    ) -> Result<CheckedProgram, RunFailure> {
        let machine = self.machine;
        let words = words_of(machine, dialect).map_err(|e| refused(&e))?;
        let found = match netlist.filter(|_| dialect == Dialect::LinuxCnc) {
            Some(netlist) => read_with_netlist(text, netlist, &words.words),
            None => read(text, dialect, &words.words),
        };
        let found = found.map_err(|e| unreadable(&e, dialect))?;
        let tracked =
            track(&found.blocks, &machine.machine, &words, &Positions::default()).map_err(|e| refused(&e))?;
        let mut checked = figures(&found, dialect, machine, &words, &Moved::of(&tracked));
        let followed = match &self.bodies {
            Some(Bodies::Grinding(on)) => on.follow(&machine.machine, &tracked)?,
            Some(Bodies::Tangential(on)) => on.follow(&machine.machine, &tracked)?,
            None => return Ok(checked),
        };
        checked.kind = Some(followed.kind);
        checked.strokes = followed.strokes;
        checked.flanks = Some(followed.flanks);
        checked.threads = followed.threads;
        checked.remarks.extend(followed.faults);
        Ok(checked)
    }
}

/// The same of a program that measures a skiving tool, and whether it measures that of the job.
fn check_measuring(
    mut text: impl BufRead,
    dialect: Dialect,
    machine: &LoadedMachine,
    loaded: &LoadedSkivingJob,
    progress: &dyn Progress,
) -> Result<CheckedProgram, RunFailure> {
    let mut whole = String::new();
    text.by_ref().take(MAXIMUM_BYTES as u64 + 1).read_to_string(&mut whole).map_err(|error| {
        let finding =
            Diagnostic::with_code("unreadable-file", format!("the program cannot be read: {error}"));
        RunFailure::bad_input(finding.way_out("give a text file"))
    })?;
    let mut checked = check_program((whole.as_bytes(), None), dialect, machine, None, progress)?;
    let (kind, _) = prove_text(loaded, machine, dialect, &whole)?;
    checked.kind = Some(kind);
    Ok(checked)
}

/// What the axes of a machine do, by their numbers: mm or rad, s.
pub(in crate::workflow) struct Moved<'a> {
    /// Range of each; `None` for one that is not named.
    pub ranges: &'a [Option<[f64; 2]>],
    /// Whole way of each.
    pub ways: &'a [f64],
    /// Greatest speed of each.
    pub speeds: &'a [f64],
    /// Time of all blocks.
    pub duration: f64,
    /// By which share a speed may be above the limit because its block is rounded.
    pub rounding: f64,
}

impl<'a> Moved<'a> {
    fn of(tracked: &'a Tracked) -> Self {
        let Tracked { ranges, ways, speeds, duration, .. } = tracked;
        Self { ranges, ways, speeds, duration: *duration, rounding: 1e-9 }
    }
}

/// The figures of a program without a job: axes, times, and what does not fit the machine.
pub(in crate::workflow) fn figures(
    found: &ReadProgram,
    dialect: Dialect,
    machine: &LoadedMachine,
    words: &AxisWords,
    moved: &Moved<'_>,
) -> CheckedProgram {
    let mut remarks = Vec::new();
    let mut axes = Vec::new();
    for (number, axis) in machine.machine.axes().iter().enumerate() {
        let Some([from, to]) = moved.ranges[number] else { continue };
        let speed = moved.speeds[number];
        let stands = to <= from && speed <= 0.0;
        let named = words.place(number).map(|k| &words.words[k].word);
        if stands && matches!(named, Some(Word::Spindle(_))) {
            continue;
        }
        let shown = |x: f64| axis.joint.shown(x);
        for value in [from, to] {
            if let Some(error) = axis.beyond(value) {
                remarks.push(Remark {
                    code: error.code(),
                    text: error.to_string(),
                    way_out: error.way_out(),
                });
                break;
            }
        }
        if let Some(most) = axis.limits.velocity.filter(|most| speed > most * (1.0 + moved.rounding)) {
            remarks.push(Remark {
                code: "axis-too-fast",
                text: format!(
                    "{} would move at {:.4} {unit}/s; the machine allows {:.4} {unit}/s",
                    axis.name,
                    shown(speed),
                    shown(most),
                    unit = axis.joint.unit()
                ),
                way_out: "give the block more time: the control slows down all axes of it".into(),
            });
        }
        axes.push(CheckedAxis {
            axis: axis.name.clone(),
            word: named.map_or_else(String::new, super::result::shown_word),
            unit: axis.joint.unit(),
            from: shown(from),
            to: shown(to),
            way: shown(moved.ways[number]),
            velocity: shown(speed),
            min: axis.travel.map(|[min, _]| shown(min)),
            max: axis.travel.map(|[_, max]| shown(max)),
            max_velocity: axis.limits.velocity.map(shown),
        });
    }
    let turning = machine.machine.role(Role::Work).and_then(|axis| moved.ranges[axis]);
    let kind = match turning {
        Some([from, to]) if to > from => Some("grinding"),
        _ if machine.machine.role(Role::Worm).is_some() => Some("dressing"),
        _ => None,
    };
    CheckedProgram {
        control: dialect.name(),
        machine: machine.file.name.clone(),
        name: found.name.clone(),
        kind,
        blocks: found.blocks.len(),
        duration_s: moved.duration,
        axes,
        strokes: Vec::new(),
        flanks: None,
        threads: Vec::new(),
        part: None,
        remarks,
    }
}
