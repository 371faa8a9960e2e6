//! Measured fields as a table: CSV with the columns tooth, flank, w_mm, z_mm, f_um, one point a row.

use std::collections::HashMap;

use super::Topography;
use super::trace_table::{READING, reading_numbers};
use job::table_rows::TableForm;
use job::{Cell, Column, CsvError, CsvTable, Diagnostic};

/// The columns of the table.
pub(super) const FORM: TableForm<5> = TableForm {
    columns: ["tooth", "flank", "w_mm", "z_mm", "f_um"],
    optional: Some(READING),
    row: "each point",
};

/// The table of fields, as [`super::read_measured_table`] reads it back: w_mm length of roll, z_mm from the middle of the face width, f_um
/// deviation, positive = material, empty where it is undefined.
///
/// # Errors
/// [`CsvError`] for a place that is not finite.
pub fn topography_table(fields: &[Topography]) -> Result<CsvTable, CsvError> {
    let readings = reading_numbers(fields.iter().map(|field| (field.tooth, field.flank)));
    let repeated = readings.iter().any(|reading| *reading > 1);
    let titles = FORM.columns.into_iter().chain(repeated.then_some(READING));
    let mut table = CsvTable::new(&titles.map(|name| Column::new(name, "")).collect::<Vec<_>>());
    for (field, reading) in fields.iter().zip(readings) {
        for ([w, z], f) in field.points_mm.iter().zip(&field.f_um) {
            let cells = [
                Cell::Number(f64::from(field.tooth)),
                Cell::Word(field.flank.name()),
                Cell::Number(*w),
                Cell::Number(*z),
                if f.is_finite() { Cell::Number(*f) } else { Cell::Empty },
                Cell::Number(f64::from(reading)),
            ];
            table.push_cells(&cells[..FORM.columns.len() + usize::from(repeated)])?;
        }
    }
    Ok(table)
}

/// Fields of all teeth and flanks in the order in which they begin.
pub(super) fn fields(text: &str) -> Result<Vec<Topography>, Diagnostic> {
    let mut fields: Vec<Topography> = Vec::new();
    let mut known = HashMap::new();
    for row in FORM.rows(text)? {
        let (tooth, flank) = (row.tooth(0)?, row.flank(1)?);
        let (point, f) = ([row.length_of_roll(2)?, row.number(3)?], row.deviation(4)?);
        let at = *known.entry((tooth, flank, row.reading()?)).or_insert(fields.len());
        if at == fields.len() {
            fields.push(Topography { tooth, flank, points_mm: Vec::new(), f_um: Vec::new() });
        }
        fields[at].points_mm.push(point);
        fields[at].f_um.push(f);
    }
    Ok(fields)
}
