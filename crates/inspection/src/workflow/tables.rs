//! Tables of a measured gear as CSV.

use super::result::GearInspectionResult;
use job::{Cell, Column, CsvError, CsvTable};

/// Every trace.
///
/// # Errors
/// A value that is not finite.
pub fn traces(result: &GearInspectionResult) -> Result<CsvTable, CsvError> {
    let mut table = CsvTable::new(&[
        Column::new("kind", ""),
        Column::new("tooth", ""),
        Column::new("flank", ""),
        Column::new("line", ""),
        Column::new("from", "mm"),
        Column::new("to", "mm"),
        Column::new("fH", "um"),
        Column::new("fH_length", "mm"),
        Column::new("F", "um"),
        Column::new("ff", "um"),
        Column::new("C", "um"),
        Column::new("fKo", "um"),
    ]);
    for t in &result.traces {
        table.push_cells(&[
            Cell::Word(t.kind),
            Cell::Number(f64::from(t.tooth)),
            Cell::Word(t.flank),
            Cell::Word(&t.tag),
            Cell::Number(t.range_mm[0]),
            Cell::Number(t.range_mm[1]),
            Cell::Number(t.slope_um),
            Cell::Number(t.slope_length_mm),
            Cell::Number(t.total_um),
            Cell::Number(t.form_um),
            Cell::Number(t.crowning_um),
            t.tip_relief_um.map_or(Cell::Empty, Cell::Number),
        ])?;
    }
    Ok(table)
}

/// Cumulative pitch of every tooth.
///
/// # Errors
/// A value that is not finite.
pub fn pitch(result: &GearInspectionResult) -> Result<CsvTable, CsvError> {
    let mut table =
        CsvTable::labelled("flank", &[Column::new("tooth", ""), Column::new("cumulative_pitch", "um")]);
    for (flank, of) in &result.pitch {
        for (k, f) in of.cumulative_um.iter().enumerate() {
            table.push_labelled(flank, &[(k + 1) as f64, *f])?;
        }
    }
    Ok(table)
}
