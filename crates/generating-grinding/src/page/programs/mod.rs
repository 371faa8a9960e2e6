//! The section on NC programs: proof, programs, passes and axes.

mod axes;
mod station;

use crate::workflow::programs::result::{ProgramResult, ProgramsResult, ProofResult};
use crate::workflow::programs::run_programs::RunPrograms;
use axes::axis_table;
use motion::PassReport;
use report::charts::{AxisChart, ChartError, axis_chart, format_fixed, format_significant};
use report::{Block, Column, Figure, Table, kebab};
use station::{Passes, Station, stations};
use std::borrow::Borrow;

/// The content of the section, in reading order; nothing without programs.
///
/// # Errors
/// [`ChartError`] for values that are not finite.
pub fn programs_blocks(programs: &RunPrograms) -> Result<Vec<Block>, ChartError> {
    let result = &programs.result;
    if result.programs.is_empty() {
        return Ok(Vec::new());
    }
    let mut blocks: Vec<Block> = result.proofs.iter().map(|proof| Block::Paragraph(stated(proof))).collect();
    if !result.proofs.is_empty() {
        blocks.push(Block::Paragraph(HOW_PROVEN.to_owned()));
        blocks.push(Block::Table(proof_table(&result.proofs)));
    }
    blocks.push(Block::Table(program_table(result)));
    for station in stations(programs) {
        blocks.push(Block::Heading(capital(&station.job)));
        let mut passes: Vec<Table> = station.passes.iter().map(|of| pass_table(&station, of)).collect();
        if let Some(last) = passes.last_mut() {
            last.note = pass_note(&station);
        }
        blocks.extend(passes.into_iter().map(Block::Table));
        if !station.axes.is_empty() {
            blocks.push(Block::Table(axis_table(&station)));
        }
        if !station.charts.is_empty() {
            blocks.push(Block::Paragraph(what_is_drawn(&station)));
        }
        let figure = |chart: &AxisChart| {
            let id = format!("{}-{}", kebab(&station.job), chart.id());
            Ok(Figure::new(id, axis_chart(chart)?, ""))
        };
        let figures: Vec<Figure> = station.charts.iter().map(figure).collect::<Result<_, ChartError>>()?;
        if !figures.is_empty() {
            blocks.push(Block::Figures(figures));
        }
        if !station.jumping.is_empty() {
            blocks.push(Block::Paragraph(format!(
                "Not drawn, because the machine file gives no limits and they jump: {}.",
                station.jumping.join(", ")
            )));
        }
    }
    Ok(blocks)
}

const HOW_PROVEN: &str = "A reader that shares no code with the writers read the text of each program. The axes that it found \
     were carried through the machine to the bodies, and the referee dressed and ground the flank once more with these motions \
     alone. Its largest deviation from the target stands above and, per flank, below.";

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

/// "a", "a and b", "a, b and c".
fn listed<T: Borrow<str>>(names: &[T]) -> String {
    match names {
        [] => String::new(),
        [only] => only.borrow().to_owned(),
        [before @ .., last] => format!("{} and {}", before.join(", "), last.borrow()),
    }
}

fn stated(proof: &ProofResult) -> String {
    format!("{}: {}.", listed(&proof.controls), proof.statement)
}

fn um(value: f64) -> String {
    format_fixed(value, 4)
}

fn proof_table(proofs: &[ProofResult]) -> Table {
    let rows = proofs.iter().flat_map(|proof| {
        proof.flanks.iter().map(|(name, flank)| {
            vec![
                proof.controls.join(", "),
                (*name).to_owned(),
                um(flank.max_deviation_um),
                um(flank.difference_um),
                um(proof.allowed_difference_um),
                um(proof.chords_um),
                um(proof.rounding_um),
            ]
        })
    });
    Table {
        caption: "Proven from the program text".to_owned(),
        columns: vec![
            Column::name("Controls"),
            Column::name("Flank"),
            Column::number("Deviation from the target", "µm"),
            Column::number("Difference from the run", "µm"),
            Column::number("Difference explained", "µm"),
            Column::number("Chord deviation", "µm"),
            Column::number("Rounding", "µm"),
        ],
        rows: rows.collect(),
        note: "Largest values over the flank. Difference: the flank from the text against the flank that the motions of this report \
               leave. Explained: what chords and the rounding of the numbers may do to it, dressing and grinding together; with a \
               larger difference no program would have been written."
            .to_owned(),
    }
}

fn program_table(result: &ProgramsResult) -> Table {
    let row = |p: &ProgramResult| {
        vec![
            p.file.clone(),
            p.control.to_owned(),
            station::job_of(p),
            p.blocks.to_string(),
            format_fixed(p.duration_s, 2),
            minutes(p.duration_s),
        ]
    };
    let clamped = if result.work_reversed {
        " The workpiece is clamped with its +z into the −z of its spindle (datum face down; the datum face is face II, at upper z)."
    } else {
        " The workpiece is clamped with its +z along that of its spindle (datum face up; the datum face is face II, at upper z)."
    };
    Table {
        caption: format!("Programs for the machine {}", result.machine.replace('_', " ")),
        columns: vec![
            Column::name("File"),
            Column::text("Control"),
            Column::text("Job"),
            Column::number("Blocks", ""),
            Column::number("Cycle time", "s"),
            Column::number("", "min:s"),
        ],
        rows: result.programs.iter().map(row).collect(),
        note: format!(
            "Blocks: those that move axes. Cycle time: all moves with their ramps within the limits of the axes, without loading \
             and changing tools.{clamped}"
        ),
    }
}

/// "2:05" for 125 s.
fn minutes(time_s: f64) -> String {
    if !(time_s.is_finite() && time_s >= 0.0) {
        return "–".to_owned();
    }
    let seconds = time_s.round() as u64;
    format!("{}:{:02}", seconds / 60, seconds % 60)
}

fn pass_table(station: &Station<'_>, passes: &Passes<'_>) -> Table {
    let rows = passes.rows.iter().map(|pass: &PassReport| {
        let [from, to] = pass.driven;
        vec![
            pass.name.clone(),
            format!("{} .. {}", format_fixed(from, 3), format_fixed(to, 3)),
            pass.blocks.to_string(),
            format_significant(pass.speed, 4),
            pass.braked
                .as_ref()
                .map_or("–".to_owned(), |b| format!("to {}, {} {}", percent(b.share), b.axis, b.limit)),
            um(pass.chord_deviation * 1e3),
            um(pass.rounding * 1e3),
            format_fixed(pass.time, 2),
        ]
    });
    Table {
        caption: format!("Passes of {}: {}", station.job, listed(&passes.controls)),
        columns: vec![
            Column::text("Pass"),
            Column { unit: "mm".into(), ..Column::name("Driven from .. to") },
            Column::number("Blocks", ""),
            Column::number("Speed", "mm/s"),
            Column::text("Braked"),
            Column::number("Chord deviation", "µm"),
            Column::number("Rounding", "µm"),
            Column::number("Time", "s"),
        ],
        rows: rows.collect(),
        note: String::new(),
    }
}

fn pass_note(station: &Station<'_>) -> String {
    format!(
        "From .. to and speed are those of the {}, run-in and run-out included; time is that of one drive. Braked: share of the wanted \
         speed, and the limit that forbids more. Chord deviation: how far the straight blocks leave the course, seen on the flank. \
         Rounding: what the digits of the numbers may add.",
        station.parameter
    )
}

/// "12.3 %" for 0.123.
fn percent(share: f64) -> String {
    format!("{} %", format_significant(100.0 * share, 3))
}

fn what_is_drawn(station: &Station<'_>) -> String {
    let mut text = format!("Drawn and listed: the program of {}.", station.control);
    if !station.alike.is_empty() {
        let verb = if station.alike.len() == 1 { "that" } else { "those" };
        text.push_str(&format!(" {} of {} drive the axes alike.", capital(verb), listed(&station.alike)));
    }
    if !station.different.is_empty() {
        text.push_str(&format!(
            " {} drive the same axes with blocks of their own; their times stand above.",
            capital(&format!("the programs of {}", listed(&station.different)))
        ));
    }
    text
}
