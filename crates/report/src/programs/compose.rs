//! Arranges proof, programs, passes and axes.

use super::data::{
    AxisRow, PassTable, ProgramRow, ProgramsReport, ProofReport, RestingAxis, SpindleRow, StationReport,
};
use crate::charts::{AxisChart, ChartError, axis_chart, format_fixed, format_significant, share_of_limit};
use crate::data::{Block, Column, Figure, Table};
use crate::ids::kebab;

impl ProgramsReport {
    /// The content of the section, in reading order; nothing without programs.
    ///
    /// # Errors
    /// [`ChartError`] for values that are not finite.
    pub fn blocks(&self) -> Result<Vec<Block>, ChartError> {
        if self.programs.is_empty() {
            return Ok(Vec::new());
        }
        let mut blocks: Vec<Block> =
            self.proofs.iter().map(|proof| Block::Paragraph(stated(proof))).collect();
        if !self.proofs.is_empty() {
            blocks.push(Block::Paragraph(HOW_PROVEN.to_owned()));
            blocks.push(Block::Table(proof_table(&self.proofs)));
        }
        blocks.push(Block::Table(program_table(self)));
        for station in &self.stations {
            blocks.push(Block::Heading(capital(&station.job)));
            let mut passes: Vec<Table> = station.passes.iter().map(|of| pass_table(station, of)).collect();
            if let Some(last) = passes.last_mut() {
                last.note = pass_note(station);
            }
            blocks.extend(passes.into_iter().map(Block::Table));
            if !station.axes.is_empty() {
                blocks.push(Block::Table(axis_table(station)));
            }
            if !station.charts.is_empty() {
                blocks.push(Block::Paragraph(what_is_drawn(station)));
            }
            let figure = |chart: &AxisChart| {
                let id = format!("{}-{}", kebab(&station.job), chart.id());
                Ok(Figure::new(id, axis_chart(chart)?, ""))
            };
            let figures: Vec<Figure> =
                station.charts.iter().map(figure).collect::<Result<_, ChartError>>()?;
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
}

const HOW_PROVEN: &str = "A reader that shares no code with the writers read the text of each program. The axes that it found \
     were carried through the machine to the bodies, and the referee dressed and ground the flank once more with these motions \
     alone. Its largest deviation from the target stands above and, per flank, below.";

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

/// "a", "a and b", "a, b and c".
fn listed(names: &[String]) -> String {
    match names {
        [] => String::new(),
        [only] => only.clone(),
        [before @ .., last] => format!("{} and {last}", before.join(", ")),
    }
}

fn stated(proof: &ProofReport) -> String {
    format!("{}: {}.", listed(&proof.controls), proof.statement)
}

fn um(value: f64) -> String {
    format_fixed(value, 4)
}

fn proof_table(proofs: &[ProofReport]) -> Table {
    let rows = proofs.iter().flat_map(|proof| {
        proof.flanks.iter().map(|flank| {
            vec![
                proof.controls.join(", "),
                flank.flank.clone(),
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

fn program_table(report: &ProgramsReport) -> Table {
    let row = |p: &ProgramRow| {
        vec![
            p.file.clone(),
            p.control.clone(),
            p.job.clone(),
            p.blocks.to_string(),
            format_fixed(p.time_s, 2),
            minutes(p.time_s),
        ]
    };
    let clamped = if report.work_reversed {
        " The workpiece is clamped with its +z into the −z of its spindle (datum face down; the datum face is face II, at upper z)."
    } else {
        " The workpiece is clamped with its +z along that of its spindle (datum face up; the datum face is face II, at upper z)."
    };
    Table {
        caption: format!("Programs for the machine {}", report.machine.replace('_', " ")),
        columns: vec![
            Column::name("File"),
            Column::text("Control"),
            Column::text("Job"),
            Column::number("Blocks", ""),
            Column::number("Cycle time", "s"),
            Column::number("", "min:s"),
        ],
        rows: report.programs.iter().map(row).collect(),
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

fn pass_table(station: &StationReport, passes: &PassTable) -> Table {
    let rows = passes.rows.iter().map(|pass| {
        let [from, to] = pass.driven_mm;
        vec![
            pass.name.clone(),
            format!("{} .. {}", format_fixed(from, 3), format_fixed(to, 3)),
            pass.blocks.to_string(),
            format_significant(pass.speed_mm_per_s, 4),
            pass.braked
                .as_ref()
                .map_or("–".to_owned(), |(share, by)| format!("to {}, {by}", percent(*share))),
            um(pass.chords_um),
            um(pass.rounding_um),
            format_fixed(pass.time_s, 2),
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

fn pass_note(station: &StationReport) -> String {
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

fn axis_table(station: &StationReport) -> Table {
    let of = |(value, most): (f64, Option<f64>)| {
        let share = most.map_or("–".to_owned(), |most| share_of_limit(value / most));
        [format_significant(value, 4), share]
    };
    let row = |a: &AxisRow| {
        let role = if a.role.is_empty() { String::new() } else { format!(", {}", a.role) };
        let mut cells = vec![format!("{}{role}", a.axis), words(a), a.unit.clone()];
        let decimals = decimals_of_way(a.way);
        cells.extend([a.range[0], a.range[1], a.way].map(|x| format_fixed(x, decimals)));
        cells.extend(of(a.velocity));
        cells.extend(of(a.acceleration));
        cells
    };
    let mut notes = vec!["The share is that of the machine's limit.".to_owned()];
    let reversed: Vec<String> = station.axes.iter().filter(|a| a.reversed).map(|a| a.axis.clone()).collect();
    if !reversed.is_empty() {
        notes.push(format!(
            "Positions count as the machine file does; the control counts {} the other way.",
            listed(&reversed)
        ));
    }
    let at = |r: &RestingAxis| format!("{} at {} {}", r.axis, format_fixed(r.at, 4), r.unit);
    if !station.resting.is_empty() {
        notes.push(format!(
            "Standing still: {}.",
            listed(&station.resting.iter().map(at).collect::<Vec<_>>())
        ));
    }
    let turning = |s: &SpindleRow| {
        format!("{} ({}) at {} 1/min", s.axis, s.word, format_significant(s.speed_per_min, 5))
    };
    if !station.spindles.is_empty() {
        let all: Vec<String> = station.spindles.iter().map(turning).collect();
        notes.push(format!("Turning as a spindle: {}.", listed(&all)));
    }
    Table {
        caption: format!("Axes that move in {}", station.job),
        columns: vec![
            Column::name("Axis"),
            Column::text("Word"),
            Column::text("Unit"),
            Column::number("From", ""),
            Column::number("To", ""),
            Column::number("Way", ""),
            Column::number("Largest velocity", "per s"),
            Column::number("Share", "%"),
            Column::number("Largest acceleration", "per s²"),
            Column::number("Share", "%"),
        ],
        rows: station.axes.iter().map(row).collect(),
        note: notes.join(" "),
    }
}

/// Decimals that show a way (mm or deg) to four digits, at least three and at most six.
fn decimals_of_way(way: f64) -> usize {
    match way {
        way if way >= 1.0 => 3,
        way if way >= 0.1 => 4,
        way if way >= 0.01 => 5,
        _ => 6,
    }
}

/// The word of an axis; with the controls where they differ.
fn words(axis: &AxisRow) -> String {
    match axis.words.as_slice() {
        [only] => only.word.clone(),
        several => several
            .iter()
            .map(|w| format!("{} ({})", w.word, w.controls.join(", ")))
            .collect::<Vec<_>>()
            .join("; "),
    }
}

fn what_is_drawn(station: &StationReport) -> String {
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
