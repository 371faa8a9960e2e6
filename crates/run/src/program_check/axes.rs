//! What a program does on a machine: axes, travel, speed, time, whatever process it is of.

use super::control::{name_of, words_for};
use super::result::{CheckedAxis, CheckedProgram};
use crate::finding::RunFailure;
use job::Diagnostic;
use job::machine::LoadedMachine;
use machine::{Positions, Role};
use motion::{AxisWords, MotionError, Tracked, track};
use nc::{Block, Dialect, ReadError, ReadProgram, Word, read, read_with_netlist};
use std::io::BufRead;
use verdict::Remark;

/// By which share a speed may be above the limit because its block is rounded: times of blocks have six digits.
pub const SPEED_ROUNDING: f64 = 1e-3;

/// A program that cannot be read, as a finding with its place in the message.
pub fn unreadable(error: &ReadError, dialect: Dialect) -> RunFailure {
    // What is allowed stands beside the message.
    let told = error.to_string();
    let place = told.split("; allowed: ").next().unwrap_or_default();
    let text = format!("no program for {}: {place}", dialect.name());
    RunFailure::bad_input(
        Diagnostic::with_code(error.code(), text).allowed(error.allowed).way_out(error.way_out()),
    )
}

/// Axes that cannot be followed, as a finding.
pub fn refused(error: &MotionError) -> RunFailure {
    RunFailure::bad_input(Diagnostic::of(error))
}

/// The words that a control has for the axes of a machine.
///
/// # Errors
/// [`MotionError::InvalidWord`].
pub fn words_of(machine: &LoadedMachine, dialect: Dialect) -> Result<AxisWords, MotionError> {
    let all: Vec<usize> = (0..machine.machine.axes().len()).collect();
    words_for(machine, machine.file.controls.of(name_of(dialect)), &all)
}

/// Reads a program of a dialect and follows its axes on a machine: figures, words of the axes, blocks.
///
/// # Errors
/// [`RunFailure`]: a text that is no program, axes that the machine has not.
pub fn checked_axes(
    text: impl BufRead,
    dialect: Dialect,
    machine: &LoadedMachine,
) -> Result<(CheckedProgram, AxisWords, Vec<Block>), RunFailure> {
    let words = words_of(machine, dialect).map_err(|e| refused(&e))?;
    let found = read(text, dialect, &words.words).map_err(|e| unreadable(&e, dialect))?;
    let tracked =
        track(&found.blocks, &machine.machine, &words, &Positions::default()).map_err(|e| refused(&e))?;
    let checked = figures(&found, dialect, machine, &words, &Moved::of(&tracked));
    Ok((checked, words, found.blocks))
}

/// What the axes of a machine do, by their numbers: mm or rad, s.
pub struct Moved<'a> {
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
    /// The motion itself, to name the block of what does not fit; `None` where that is reported elsewhere.
    pub tracked: Option<&'a Tracked>,
}

impl<'a> Moved<'a> {
    fn of(tracked: &'a Tracked) -> Self {
        let Tracked { ranges, ways, speeds, duration, .. } = tracked;
        Self { ranges, ways, speeds, duration: *duration, rounding: SPEED_ROUNDING, tracked: Some(tracked) }
    }

    /// "block N: " of the greatest speed of an axis above a limit.
    fn block_of_speed(&self, axis: usize, limit: f64) -> String {
        let faster = self.tracked.map(|tracked| tracked.faster(axis, limit)).unwrap_or_default();
        let worst = faster.into_iter().max_by(|a, b| a.1.total_cmp(&b.1));
        worst.map_or_else(String::new, |(block, _)| format!("block {block}: "))
    }

    /// "block N: " of the first place at which an axis stands so.
    fn block_at(&self, axis: usize, value: f64) -> String {
        let mut moves = self.tracked.into_iter().flat_map(Tracked::moves);
        let first = moves.find(|(_, ends)| ends.iter().any(|at| at[axis] == value));
        first.map_or_else(String::new, |(block, _)| format!("block {block}: "))
    }
}

/// The figures of a program without a job: axes, times, and what does not fit the machine.
pub fn figures(
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
                    text: format!("{}{error}", moved.block_at(number, value)),
                    way_out: error.way_out().into(),
                });
                break;
            }
        }
        if let Some(most) = axis.limits.velocity.filter(|most| speed > most * (1.0 + moved.rounding)) {
            remarks.push(Remark {
                code: "axis-too-fast",
                text: format!(
                    "{}{} would move at {:.4} {unit}/s; the machine allows {:.4} {unit}/s",
                    moved.block_of_speed(number, most),
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
            word: named.map_or_else(String::new, shown_word),
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
        bodies: Vec::new(),
        part: None,
        measuring: None,
        remarks,
    }
}

/// A word as people write it.
pub fn shown_word(word: &Word) -> String {
    match word {
        Word::Letter(letter) => letter.to_string(),
        Word::Named(name) => name.clone(),
        Word::Spindle(spindle) => format!("spindle {spindle}"),
    }
}

/// Reads a program and follows its axes on a machine; also what the axes did, for bodies that follow them.
///
/// # Errors
/// [`RunFailure`]: a text that is no program, axes that the machine has not.
pub fn checked_program(
    text: impl BufRead,
    netlist: Option<&str>,
    dialect: Dialect,
    machine: &LoadedMachine,
) -> Result<(CheckedProgram, Tracked), RunFailure> {
    let words = words_of(machine, dialect).map_err(|e| refused(&e))?;
    let found = match netlist.filter(|_| dialect == Dialect::LinuxCnc) {
        Some(netlist) => read_with_netlist(text, netlist, &words.words),
        None => read(text, dialect, &words.words),
    };
    let found = found.map_err(|e| unreadable(&e, dialect))?;
    let tracked =
        track(&found.blocks, &machine.machine, &words, &Positions::default()).map_err(|e| refused(&e))?;
    let checked = figures(&found, dialect, machine, &words, &Moved::of(&tracked));
    Ok((checked, tracked))
}
