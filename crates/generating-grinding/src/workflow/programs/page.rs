//! Programs of a run as data of the report: figures from the result, curves from the traces. Knows no process.

use super::build::BuiltProgram;
use super::result::{AxisResult, ProgramResult, ProofResult};
use super::run_programs::RunPrograms;
use foundation::geometry::Flank;
use machine::{Axis, Machine, Role, Station};
use motion::{PassReport, TraceRow};
use nc::{Block, Word};
use report::charts::{AxisChart, AxisChartLimits};
use report::programs::{
    AxisRow, ControlWords, FlankProofRow, PassRow, PassTable, ProgramRow, ProgramsReport, ProofReport,
    RestingAxis, SpindleRow, StationReport,
};
use std::f64::consts::TAU;

/// A way below this (mm or deg) is rounding.
const STANDS_STILL: f64 = 1e-7;
/// Beyond this (mm or deg, per s, per s^2) an axis jumps.
const JUMP: f64 = 1e9;

/// A program with its figures.
type Shown<'a> = (&'a BuiltProgram, &'a ProgramResult);

/// What the report shows of the programs of a run.
pub fn programs_report(programs: &RunPrograms) -> ProgramsReport {
    let all: Vec<Shown<'_>> = programs.built.programs.iter().zip(&programs.result.programs).collect();
    ProgramsReport {
        machine: programs.result.machine.clone(),
        work_reversed: programs.result.work_reversed,
        proofs: programs.result.proofs.iter().map(proof).collect(),
        programs: all.iter().map(|(_, result)| row(result)).collect(),
        stations: [Station::Dresser, Station::Work]
            .into_iter()
            .flat_map(|station| [None, Some(Flank::Left), Some(Flank::Right)].map(|lines| (station, lines)))
            .filter_map(|(station, lines)| {
                // The programs of further areas drive the same at another place along the worm.
                let shown = |(built, _): &Shown<'_>| {
                    built.station == station && built.area == 0 && built.lines == lines
                };
                let of: Vec<Shown<'_>> = all.iter().copied().filter(shown).collect();
                station_report(&programs.machine.machine, &of)
            })
            .collect(),
    }
}

fn proof(proof: &ProofResult) -> ProofReport {
    ProofReport {
        controls: proof.controls.iter().map(|&name| name.into()).collect(),
        statement: proof.statement.clone(),
        flanks: proof
            .flanks
            .iter()
            .map(|(flank, of)| FlankProofRow {
                flank: (*flank).into(),
                max_deviation_um: of.max_deviation_um,
                difference_um: of.difference_um,
            })
            .collect(),
        chords_um: proof.chords_um,
        rounding_um: proof.rounding_um,
        allowed_difference_um: proof.allowed_difference_um,
    }
}

/// What a program does, in words.
fn job_of(result: &ProgramResult) -> String {
    match result.lines_of_flank {
        Some(flank) => format!("{} the {flank} flank by lines", result.job),
        None => result.job.into(),
    }
}

fn row(result: &ProgramResult) -> ProgramRow {
    ProgramRow {
        file: result.file.clone(),
        control: result.control.into(),
        job: job_of(result),
        blocks: result.blocks,
        time_s: result.duration_s,
    }
}

/// Programs of one station; axes are those of the first control.
fn station_report(machine: &Machine, programs: &[Shown<'_>]) -> Option<StationReport> {
    let (&(built, result), others) = programs.split_first()?;
    let trace = &built.layout.trace;
    let moves = |axis: &&AxisResult| axis.way > STANDS_STILL;
    let (alike, different): (Vec<&Shown<'_>>, Vec<&Shown<'_>>) =
        others.iter().partition(|(other, _)| &other.layout.trace == trace);
    let controls =
        |of: Vec<&Shown<'_>>| of.into_iter().map(|(_, result)| result.control.to_owned()).collect();
    let mut charts = Vec::new();
    let mut jumping = Vec::new();
    for axis in result.axes.iter().filter(moves) {
        let Some(number) = machine.axis_named(&axis.axis) else { continue };
        match chart(&machine.axes()[number], &axis.word, number, &trace.rows) {
            Some(chart) => charts.push(chart),
            None => jumping.push(axis.axis.clone()),
        }
    }
    Some(StationReport {
        job: job_of(result),
        parameter: match built.station {
            Station::Dresser if built.lines.is_some() => {
                "worm position v_zS, the speed being the least along a line".into()
            }
            Station::Dresser => "worm position v_zS".into(),
            Station::Work => "feed z_V2".into(),
        },
        control: result.control.into(),
        alike: controls(alike),
        different: controls(different),
        passes: passes(programs),
        axes: result.axes.iter().filter(moves).map(|axis| axis_row(machine, axis, programs)).collect(),
        resting: resting(machine, built, result),
        spindles: spindles(built),
        charts,
        jumping,
    })
}

/// The passes of all controls; equal ones once.
fn passes(programs: &[Shown<'_>]) -> Vec<PassTable> {
    let mut tables: Vec<PassTable> = Vec::new();
    for (built, result) in programs {
        let rows: Vec<PassRow> = built.layout.passes.iter().map(pass).collect();
        match tables.iter_mut().find(|table| table.rows == rows) {
            Some(table) => table.controls.push(result.control.into()),
            None => tables.push(PassTable { controls: vec![result.control.into()], rows }),
        }
    }
    tables
}

fn pass(pass: &PassReport) -> PassRow {
    PassRow {
        name: pass.name.clone(),
        driven_mm: pass.driven,
        blocks: pass.blocks,
        speed_mm_per_s: pass.speed,
        braked: pass.braked.as_ref().map(|b| (b.share, format!("{} {}", b.axis, b.limit))),
        chords_um: pass.chord_deviation * 1e3,
        rounding_um: pass.rounding * 1e3,
        time_s: pass.time,
    }
}

fn axis_row(machine: &Machine, axis: &AxisResult, programs: &[Shown<'_>]) -> AxisRow {
    let mut words: Vec<ControlWords> = Vec::new();
    for (_, result) in programs {
        let Some(same) = result.axes.iter().find(|other| other.axis == axis.axis) else { continue };
        match words.iter_mut().find(|known| known.word == same.word) {
            Some(known) => known.controls.push(result.control.into()),
            None => {
                words.push(ControlWords { word: same.word.clone(), controls: vec![result.control.into()] })
            }
        }
    }
    let number = machine.axis_named(&axis.axis);
    let role = Role::ALL.into_iter().find(|&role| number.is_some() && machine.role(role) == number);
    AxisRow {
        axis: axis.axis.clone(),
        role: role.map_or(String::new(), |role| role.key().into()),
        words,
        reversed: number.is_some_and(|number| machine.axes()[number].nc_sign < 0.0),
        unit: axis.unit.into(),
        range: [axis.from, axis.to],
        way: axis.way,
        velocity: (axis.velocity, axis.max_velocity),
        acceleration: (axis.acceleration, axis.max_acceleration),
    }
}

/// Axes with a word that do not move, and those without a word; no spindles.
fn resting(machine: &Machine, built: &BuiltProgram, result: &ProgramResult) -> Vec<RestingAxis> {
    let named = |axis: &&AxisResult| machine.axis_named(&axis.axis).is_some_and(|k| built.words.is_moved(k));
    let still = result.axes.iter().filter(named).filter(|axis| axis.way <= STANDS_STILL);
    let still =
        still.map(|axis| RestingAxis { axis: axis.axis.clone(), at: axis.from, unit: axis.unit.into() });
    let unnamed = built.layout.at_rest.iter().filter(|(number, _)| built.words.place(*number).is_none());
    let unnamed = unnamed.map(|&(number, at)| {
        let axis = &machine.axes()[number];
        RestingAxis { axis: axis.name.clone(), at: axis.joint.shown(at), unit: axis.joint.unit().into() }
    });
    still.chain(unnamed).collect()
}

/// Axes that the program starts as spindles, with the first speed of each.
fn spindles(built: &BuiltProgram) -> Vec<SpindleRow> {
    let first = |wanted: u8| {
        built.layout.program.blocks().iter().find_map(|block| match block {
            Block::Spindle { spindle, speed } if *spindle == wanted && *speed != 0.0 => Some(*speed),
            _ => None,
        })
    };
    let of = |axis: &nc::AxisWord| {
        let Word::Spindle(number) = axis.word else { return None };
        let speed_per_min = first(number)? * 60.0 / TAU;
        Some(SpindleRow { axis: axis.name.clone(), word: format!("spindle {number}"), speed_per_min })
    };
    built.words.words.iter().filter_map(of).collect()
}

/// Curves of an axis in mm or deg; `None` if it jumps, as one without limits does.
pub fn chart(axis: &Axis, word: &str, number: usize, rows: &[TraceRow]) -> Option<AxisChart> {
    let shown = |x: f64| axis.joint.shown(x);
    let curve = |of: &dyn Fn(&TraceRow) -> f64| -> Option<Vec<f64>> {
        rows.iter().map(|row| Some(shown(of(row))).filter(|x| x.abs() < JUMP)).collect()
    };
    Some(AxisChart {
        axis: axis.name.clone(),
        word: word.to_owned(),
        unit: axis.joint.unit().into(),
        time_s: rows.iter().map(|row| row.t).collect(),
        position: curve(&|row| row.at[number])?,
        velocity: curve(&|row| row.velocity[number])?,
        acceleration: curve(&|row| row.acceleration[number])?,
        limits: AxisChartLimits {
            travel: axis.travel.map(|ends| ends.map(shown)),
            velocity: axis.limits.velocity.map(shown),
            acceleration: axis.limits.acceleration.map(shown),
        },
    })
}
