//! Traces as a table: CSV with the columns kind, tooth, flank, position, abscissa, f_um, one sample a row; a column reading
//! numbers what was measured more than once.

use std::collections::HashMap;
use std::hash::Hash;

use super::{Trace, TraceKind, Zero};
use job::table_rows::{Row, TableForm};
use job::{Cell, Column, CsvError, CsvTable, Diagnostic, Problem};

/// The columns of the table.
const FORM: TableForm<6> = TableForm {
    columns: ["kind", "tooth", "flank", "position", "abscissa", "f_um"],
    optional: Some(READING),
    row: "each sample",
};
/// The column that numbers what was measured more than once.
pub(super) const READING: &str = "reading";

/// The table of traces, as [`super::read_measured_table`] reads it back; tags of traces are not in it.
///
/// # Errors
/// [`CsvError`] for a place that is not finite.
pub fn trace_table(traces: &[Trace]) -> Result<CsvTable, CsvError> {
    let key = |t: &Trace| (t.kind, t.tooth, t.flank, place(t.position_mm));
    let readings = reading_numbers(traces.iter().map(key));
    let repeated = readings.iter().any(|reading| *reading > 1);
    let titles = FORM.columns.into_iter().chain(repeated.then_some(READING));
    let mut table = CsvTable::new(&titles.map(|name| Column::new(name, "")).collect::<Vec<_>>());
    for (trace, reading) in traces.iter().zip(readings) {
        for (abscissa, f) in trace.abscissa_mm.iter().zip(&trace.f_um) {
            let cells = [
                Cell::Word(trace.kind.name()),
                Cell::Number(f64::from(trace.tooth)),
                Cell::Word(trace.flank.name()),
                Cell::Number(trace.position_mm),
                Cell::Number(*abscissa),
                if f.is_finite() { Cell::Number(*f) } else { Cell::Empty },
                Cell::Number(f64::from(reading)),
            ];
            table.push_cells(&cells[..FORM.columns.len() + usize::from(repeated)])?;
        }
    }
    Ok(table)
}

/// Which reading of its key each one is, from 1.
pub(super) fn reading_numbers<K: Eq + Hash>(keys: impl Iterator<Item = K>) -> Vec<u32> {
    let mut times = HashMap::new();
    let numbers = keys.map(|key| {
        let reading = times.entry(key).or_insert(0);
        *reading += 1;
        *reading
    });
    numbers.collect()
}

/// The place of a line as a key: adding zero makes one of 0 and -0.
fn place(position: f64) -> u64 {
    (position + 0.0).to_bits()
}

/// Traces in the order in which they begin; the samples of each in the order of their abscissa. Positions and abscissae are w or z, mm.
pub(super) fn traces(text: &str) -> Result<Vec<Trace>, Diagnostic> {
    let mut traces: Vec<Trace> = Vec::new();
    let mut known = HashMap::new();
    for row in FORM.rows(text)? {
        let (kind, tooth, flank) = (kind(&row)?, row.tooth(1)?, row.flank(2)?);
        let (position, abscissa) = match kind {
            TraceKind::Profile => (row.number(3)?, row.length_of_roll(4)?),
            TraceKind::Helix => (row.length_of_roll(3)?, row.number(4)?),
        };
        let f = row.deviation(5)?;
        let key = (kind, tooth, flank, place(position), row.reading()?);
        let at = *known.entry(key).or_insert(traces.len());
        if at == traces.len() {
            let (tag, zero) = (String::new(), Zero::Free);
            let (abscissa_mm, f_um) = (Vec::new(), Vec::new());
            traces.push(Trace { kind, tooth, flank, tag, position_mm: position, abscissa_mm, f_um, zero });
        }
        traces[at].abscissa_mm.push(abscissa);
        traces[at].f_um.push(f);
    }
    traces.into_iter().map(sorted).collect()
}

fn kind(row: &Row<'_, 6>) -> Result<TraceKind, Diagnostic> {
    let found = [TraceKind::Profile, TraceKind::Helix].into_iter().find(|k| k.name() == row.text(0));
    found.ok_or_else(|| row.wrong(Problem::UnknownValue, 0, "profile or helix"))
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
        let finding = FORM.malformed(message).field(FORM.columns[4]).value(pair[0].0);
        return Err(
            finding.way_out("number what was measured more than once in a column `reading`: 1, 2, ...")
        );
    }
    (trace.abscissa_mm, trace.f_um) = samples.into_iter().unzip();
    Ok(trace)
}
