//! Tables of a measured bevel gear as CSV.

use super::result::BevelInspectionResult;
use job::{Cell, Column, CsvError, CsvTable};

/// Target, simulated and measured flank at every point of the grid.
///
/// # Errors
/// A value that is not finite.
pub(super) fn flanks(result: &BevelInspectionResult) -> Result<CsvTable, CsvError> {
    let mut table = CsvTable::new(&[
        Column::new("flank", ""),
        Column::new("row", ""),
        Column::new("column", ""),
        Column::new("roll", "mm"),
        Column::new("along", "mm"),
        Column::new("target", "um"),
        Column::new("simulated", "um"),
        Column::new("measured", "um"),
    ]);
    for (name, of) in result.rounds.iter().flat_map(|round| &round.flanks) {
        for (i, w) in of.w_mm.iter().enumerate() {
            for (j, z) in of.z_mm.iter().enumerate() {
                table.push_cells(&[
                    Cell::Word(name),
                    Cell::Number((i + 1) as f64),
                    Cell::Number((j + 1) as f64),
                    Cell::Number(*w),
                    Cell::Number(*z),
                    Cell::Number(of.target_um[i][j]),
                    Cell::Number(of.simulated_um[i][j]),
                    of.measured_um[i][j].map_or(Cell::Empty, Cell::Number),
                ])?;
            }
        }
    }
    Ok(table)
}

/// Cumulative pitch of every tooth.
///
/// # Errors
/// A value that is not finite.
pub(super) fn pitch(result: &BevelInspectionResult) -> Result<CsvTable, CsvError> {
    let columns = [Column::new("tooth", ""), Column::new("cumulative_pitch", "um")];
    let mut table = CsvTable::labelled("flank", &columns);
    for (flank, of) in &result.pitch {
        for (k, f) in of.cumulative_um.iter().enumerate() {
            table.push_labelled(flank, &[(k + 1) as f64, *f])?;
        }
    }
    Ok(table)
}
