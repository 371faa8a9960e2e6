//! The programs of one kind, dressing or grinding, seen together: which controls drive alike, their passes, their axes.

use crate::workflow::programs::axis_curves::chart;
use crate::workflow::programs::build::BuiltProgram;
use crate::workflow::programs::result::{AxisResult, ProgramResult};
use crate::workflow::programs::run_programs::RunPrograms;
use foundation::geometry::Flank;
use machine::{Machine, Role, Station as Place};
use motion::PassReport;
use nc::{Block, Word};
use report::charts::AxisChart;
use std::f64::consts::TAU;

/// A way below this (mm or deg) is rounding.
const STANDS_STILL: f64 = 1e-7;

/// A program with its figures.
type Shown<'a> = (&'a BuiltProgram, &'a ProgramResult);

/// What the programs of one kind do.
pub(super) struct Station<'a> {
    /// "dressing" or "grinding".
    pub job: String,
    /// What the path parameter of its passes is, for example "feed z_V2".
    pub parameter: &'static str,
    /// Control whose program rows and charts of the axes are taken from.
    pub control: &'static str,
    /// Other controls whose programs drive the axes in the same way.
    pub alike: Vec<&'static str>,
    /// Other controls whose programs drive the axes otherwise.
    pub different: Vec<&'static str>,
    /// The passes; controls with the same ones share a table.
    pub passes: Vec<Passes<'a>>,
    /// Axes that move.
    pub axes: Vec<Moving<'a>>,
    /// Axes that stand still.
    pub resting: Vec<Resting>,
    /// Axes that turn as spindles.
    pub spindles: Vec<Turning>,
    /// Axes over time.
    pub charts: Vec<AxisChart>,
    /// Axes that move but cannot be drawn, because they have no limits and jump.
    pub jumping: Vec<&'a str>,
}

/// Passes of the programs of some controls.
pub(super) struct Passes<'a> {
    /// The controls.
    pub controls: Vec<&'static str>,
    /// The passes in their order.
    pub rows: &'a [PassReport],
}

/// An axis over a program.
pub(super) struct Moving<'a> {
    /// Its figures.
    pub axis: &'a AxisResult,
    /// What it does, if it plays a role.
    pub role: Option<Role>,
    /// Its words, each with the controls that use it.
    pub words: Vec<(&'a str, Vec<&'static str>)>,
    /// Whether the control counts it against the machine's sense.
    pub reversed: bool,
}

/// An axis that stands still.
pub(super) struct Resting {
    /// Name on the machine.
    pub axis: String,
    /// Where it stands, mm or deg.
    pub at: f64,
    /// "mm" or "deg".
    pub unit: &'static str,
}

/// An axis that turns as a spindle.
pub(super) struct Turning {
    /// Name on the machine.
    pub axis: String,
    /// Word in the program.
    pub word: String,
    /// Speed, revolutions per minute.
    pub speed_per_min: f64,
}

/// The kinds of programs of a run.
pub(super) fn stations(programs: &RunPrograms) -> Vec<Station<'_>> {
    let all: Vec<Shown<'_>> = programs.built.programs.iter().zip(&programs.result.programs).collect();
    [Place::Dresser, Place::Work]
        .into_iter()
        .flat_map(|station| [None, Some(Flank::Left), Some(Flank::Right)].map(|lines| (station, lines)))
        .filter_map(|(station, lines)| {
            // The programs of further areas drive the same at another place along the worm.
            let shown =
                |(built, _): &Shown<'_>| built.station == station && built.area == 0 && built.lines == lines;
            let of: Vec<Shown<'_>> = all.iter().copied().filter(shown).collect();
            station_of(&programs.machine.machine, &of)
        })
        .collect()
}

/// What a program does, in words.
pub(super) fn job_of(result: &ProgramResult) -> String {
    match result.lines_of_flank {
        Some(flank) => format!("{} the {flank} flank by lines", result.job),
        None => result.job.into(),
    }
}

/// Programs of one station; axes are those of the first control.
fn station_of<'a>(machine: &Machine, programs: &[Shown<'a>]) -> Option<Station<'a>> {
    let (&(built, result), others) = programs.split_first()?;
    let trace = &built.layout.trace;
    let moves = |axis: &&AxisResult| axis.way > STANDS_STILL;
    let (alike, different): (Vec<&Shown<'a>>, Vec<&Shown<'a>>) =
        others.iter().partition(|(other, _)| &other.layout.trace == trace);
    let controls = |of: Vec<&Shown<'a>>| of.into_iter().map(|(_, result)| result.control).collect();
    let mut charts = Vec::new();
    let mut jumping = Vec::new();
    for axis in result.axes.iter().filter(moves) {
        let Some(number) = machine.axis_named(&axis.axis) else { continue };
        match chart(&machine.axes()[number], &axis.word, number, &trace.rows) {
            Some(chart) => charts.push(chart),
            None => jumping.push(axis.axis.as_str()),
        }
    }
    Some(Station {
        job: job_of(result),
        parameter: match built.station {
            Place::Dresser if built.lines.is_some() => {
                "worm position v_zS, the speed being the least along a line"
            }
            Place::Dresser => "worm position v_zS",
            Place::Work => "feed z_V2",
        },
        control: result.control,
        alike: controls(alike),
        different: controls(different),
        passes: passes(programs),
        axes: result.axes.iter().filter(moves).map(|axis| moving(machine, axis, programs)).collect(),
        resting: resting(machine, built, result),
        spindles: spindles(built),
        charts,
        jumping,
    })
}

/// The passes of all controls; equal ones once.
fn passes<'a>(programs: &[Shown<'a>]) -> Vec<Passes<'a>> {
    let mut tables: Vec<Passes<'a>> = Vec::new();
    for (built, result) in programs {
        let rows = &built.layout.passes[..];
        match tables.iter_mut().find(|table| same_rows(table.rows, rows)) {
            Some(table) => table.controls.push(result.control),
            None => tables.push(Passes { controls: vec![result.control], rows }),
        }
    }
    tables
}

/// Whether two lists of passes say the same; their paths are not looked at.
fn same_rows(a: &[PassReport], b: &[PassReport]) -> bool {
    let figures = |p: &PassReport| {
        [p.driven[0], p.driven[1], p.speed, p.chord_deviation * 1e3, p.rounding * 1e3, p.time]
    };
    let same = |(a, b): (&PassReport, &PassReport)| {
        a.name == b.name && a.blocks == b.blocks && a.braked == b.braked && figures(a) == figures(b)
    };
    a.len() == b.len() && a.iter().zip(b).all(same)
}

fn moving<'a>(machine: &Machine, axis: &'a AxisResult, programs: &[Shown<'a>]) -> Moving<'a> {
    let mut words: Vec<(&str, Vec<&'static str>)> = Vec::new();
    for (_, result) in programs {
        let Some(same) = result.axes.iter().find(|other| other.axis == axis.axis) else { continue };
        match words.iter_mut().find(|(known, _)| *known == same.word) {
            Some((_, controls)) => controls.push(result.control),
            None => words.push((&same.word, vec![result.control])),
        }
    }
    let number = machine.axis_named(&axis.axis);
    Moving {
        axis,
        role: Role::ALL.into_iter().find(|&role| number.is_some() && machine.role(role) == number),
        words,
        reversed: number.is_some_and(|number| machine.axes()[number].nc_sign < 0.0),
    }
}

/// Axes with a word that do not move, and those without a word; no spindles.
fn resting(machine: &Machine, built: &BuiltProgram, result: &ProgramResult) -> Vec<Resting> {
    let named = |axis: &&AxisResult| machine.axis_named(&axis.axis).is_some_and(|k| built.words.is_moved(k));
    let still = result.axes.iter().filter(named).filter(|axis| axis.way <= STANDS_STILL);
    let still = still.map(|axis| Resting { axis: axis.axis.clone(), at: axis.from, unit: axis.unit });
    let unnamed = built.layout.at_rest.iter().filter(|(number, _)| built.words.place(*number).is_none());
    let unnamed = unnamed.map(|&(number, at)| {
        let axis = &machine.axes()[number];
        Resting { axis: axis.name.clone(), at: axis.joint.shown(at), unit: axis.joint.unit() }
    });
    still.chain(unnamed).collect()
}

/// Axes that the program starts as spindles, with the first speed of each.
fn spindles(built: &BuiltProgram) -> Vec<Turning> {
    let first = |wanted: u8| {
        built.layout.program.blocks().iter().find_map(|block| match block {
            Block::Spindle { spindle, speed } if *spindle == wanted && *speed != 0.0 => Some(*speed),
            _ => None,
        })
    };
    let of = |axis: &nc::AxisWord| {
        let Word::Spindle(number) = axis.word else { return None };
        let speed_per_min = first(number)? * 60.0 / TAU;
        Some(Turning { axis: axis.name.clone(), word: format!("spindle {number}"), speed_per_min })
    };
    built.words.words.iter().filter_map(of).collect()
}
