//! Traces as a table: CSV with the columns kind, tooth, flank, position, abscissa, f_um, one sample a row.

use std::ops::Range;
use std::path::Path;

use super::{Trace, TraceKind, Zero};
use crate::exchange::csv::{Cell, Column, CsvError, CsvTable};
use crate::exchange::diagnostic::{Diagnostic, JobError, Problem};
use crate::exchange::source::Source;
use crate::geometry::Flank;

const COLUMNS: [&str; 6] = ["kind", "tooth", "flank", "position", "abscissa", "f_um"];
const HEADER: &str = "kind,tooth,flank,position,abscissa,f_um";
/// Longest piece of a cell in a message, characters.
const SHOWN: usize = 60;

/// Reads a table of traces. The first line names the columns in any order; lines that begin with `#` are comments. `kind` is profile or
/// helix, `flank` left or right; `position` is z of a profile and w of a helix, `abscissa` w of a profile and z of a helix, mm, z from the
/// middle of the face width; `f_um` is the deviation, positive = material, empty or `nan` where it is undefined. Rows of one kind,
/// tooth, flank and position are one trace, wherever they stand; its samples are put in the order of their abscissa.
///
/// # Errors
/// Those of [`Source::read`]; `invalid-table`, `unknown-value`, `invalid-number` with line, column and value.
pub fn read_trace_table(path: &Path) -> Result<Vec<Trace>, JobError> {
    parse_trace_table(Source::read(path)?)
}

/// As [`read_trace_table`], from a text.
///
/// # Errors
/// As [`read_trace_table`].
pub fn parse_trace_table(source: Source) -> Result<Vec<Trace>, JobError> {
    rows(source.text()).map_err(|finding| JobError::single(source, finding))
}

/// The table of traces, as [`read_trace_table`] reads it back; tags of traces are not in it.
///
/// # Errors
/// [`CsvError`] for a place that is not finite.
pub fn trace_table(traces: &[Trace]) -> Result<CsvTable, CsvError> {
    let mut table = CsvTable::new(&COLUMNS.map(|name| Column::new(name, "")));
    for trace in traces {
        for (abscissa, f) in trace.abscissa_mm.iter().zip(&trace.f_um) {
            table.push_cells(&[
                Cell::Word(trace.kind.name()),
                Cell::Number(f64::from(trace.tooth)),
                Cell::Word(trace.flank.name()),
                Cell::Number(trace.position_mm),
                Cell::Number(*abscissa),
                if f.is_finite() { Cell::Number(*f) } else { Cell::Empty },
            ])?;
        }
    }
    Ok(table)
}

fn rows(text: &str) -> Result<Vec<Trace>, Diagnostic> {
    let mut traces: Vec<Trace> = Vec::new();
    let mut known = std::collections::HashMap::new();
    let mut order: Option<[usize; 6]> = None;
    let mut offset = 0;
    for line in text.split_inclusive('\n') {
        let start = offset;
        offset += line.len();
        let line = line.trim_end();
        if line.trim().is_empty() || line.starts_with('#') {
            continue;
        }
        let span = start..start + line.len();
        let cells: Vec<&str> = line.split(',').map(str::trim).collect();
        let Some(places) = order else {
            order = Some(columns(&cells, span)?);
            continue;
        };
        if cells.len() != COLUMNS.len() {
            return Err(malformed(format!("a row of {} values", cells.len()))
                .value(shortened(line))
                .way_out("give six values with a decimal point, separated by commas")
                .span(Some(span)));
        }
        let row = Row { cells: places.map(|place| cells[place]), span };
        let (kind, tooth, flank) = (row.kind()?, row.tooth()?, row.flank()?);
        let [position, abscissa] = [3, 4].map(|column| row.number(column));
        let (position, abscissa, f) = (position?, abscissa?, row.deviation()?);
        // Adding zero makes one key of 0 and -0.
        let key = (kind, tooth, flank, (position + 0.0).to_bits());
        let at = *known.entry(key).or_insert(traces.len());
        if at == traces.len() {
            let (tag, zero) = (String::new(), Zero::Free);
            let (abscissa_mm, f_um) = (Vec::new(), Vec::new());
            traces.push(Trace { kind, tooth, flank, tag, position_mm: position, abscissa_mm, f_um, zero });
        }
        traces[at].abscissa_mm.push(abscissa);
        traces[at].f_um.push(f);
    }
    if traces.is_empty() {
        return Err(malformed("the table has no trace")
            .value("an empty table")
            .way_out(format!("begin it with the line `{HEADER}`, followed by one row for each sample")));
    }
    traces.into_iter().map(sorted).collect()
}

/// The samples in ascending order; no place twice.
fn sorted(mut trace: Trace) -> Result<Trace, Diagnostic> {
    let mut samples: Vec<(f64, f64)> = trace.abscissa_mm.iter().copied().zip(trace.f_um).collect();
    samples.sort_by(|a, b| a.0.total_cmp(&b.0));
    if let Some(pair) = samples.windows(2).find(|pair| pair[0].0 == pair[1].0) {
        let message = format!(
            "the {} of tooth {}, {} flank, at {} mm has two samples at {} mm",
            trace.kind.name(),
            trace.tooth,
            trace.flank,
            trace.position_mm,
            pair[0].0
        );
        let finding = malformed(message).field(COLUMNS[4]).value(pair[0].0);
        return Err(finding.way_out("give repeated measurements other tooth numbers, or files of their own"));
    }
    (trace.abscissa_mm, trace.f_um) = samples.into_iter().unzip();
    Ok(trace)
}

/// A row in the order of [`COLUMNS`].
struct Row<'a> {
    cells: [&'a str; 6],
    span: Range<usize>,
}

impl Row<'_> {
    fn wrong(&self, problem: Problem, column: usize, allowed: &str) -> Diagnostic {
        let cell = shortened(self.cells[column]);
        Diagnostic::new(problem, format!("`{}` cannot be {cell}", COLUMNS[column]))
            .field(COLUMNS[column])
            .value(cell)
            .allowed(allowed)
            .way_out("correct the cell")
            .span(Some(self.span.clone()))
    }

    fn kind(&self) -> Result<TraceKind, Diagnostic> {
        let found = [TraceKind::Profile, TraceKind::Helix].into_iter().find(|k| k.name() == self.cells[0]);
        found.ok_or_else(|| self.wrong(Problem::UnknownValue, 0, "profile or helix"))
    }

    fn tooth(&self) -> Result<u32, Diagnostic> {
        let found = self.cells[1].parse().ok().filter(|tooth| *tooth <= 65_535);
        found.ok_or_else(|| self.wrong(Problem::InvalidNumber, 1, "a whole number from 0 to 65535"))
    }

    fn flank(&self) -> Result<Flank, Diagnostic> {
        let found = Flank::BOTH.into_iter().find(|flank| flank.name() == self.cells[2]);
        found.ok_or_else(|| self.wrong(Problem::UnknownValue, 2, "left or right"))
    }

    fn number(&self, column: usize) -> Result<f64, Diagnostic> {
        let found = self.cells[column].parse().ok().filter(|v: &f64| v.is_finite());
        found
            .ok_or_else(|| self.wrong(Problem::InvalidNumber, column, "a finite number with a decimal point"))
    }

    fn deviation(&self) -> Result<f64, Diagnostic> {
        if self.cells[5].is_empty() || self.cells[5].eq_ignore_ascii_case("nan") {
            return Ok(f64::NAN);
        }
        self.number(5)
    }
}

/// Positions of the columns.
fn columns(titles: &[&str], span: Range<usize>) -> Result<[usize; 6], Diagnostic> {
    let mut order = [0; 6];
    for (place, column) in order.iter_mut().zip(COLUMNS) {
        *place = titles.iter().position(|title| *title == column).ok_or_else(|| {
            malformed(format!("the table has no column `{column}`"))
                .field(column)
                .value(shortened(&titles.join(",")))
                .way_out(format!("begin the table with the line `{HEADER}`"))
                .span(Some(span.clone()))
        })?;
    }
    if titles.len() != COLUMNS.len() {
        return Err(malformed(format!("the table has {} columns", titles.len()))
            .value(shortened(&titles.join(",")))
            .way_out("remove the other columns")
            .span(Some(span)));
    }
    Ok(order)
}

fn malformed(message: impl Into<Box<str>>) -> Diagnostic {
    Diagnostic::new(Problem::InvalidTable, message)
        .allowed(format!("the columns {HEADER}, one row for each sample"))
}

/// Cells come from the file and may be of any length.
fn shortened(text: &str) -> String {
    format!("`{}`", text.chars().take(SHOWN).collect::<String>())
}
