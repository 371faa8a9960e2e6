//! `series.csv`: a row for each part and characteristic.

use super::result::InspectionSeriesResult;
use job::{Cell, Column, CsvError, CsvTable};

/// The table.
///
/// # Errors
/// A value that is not finite.
pub(super) fn values(result: &InspectionSeriesResult) -> Result<CsvTable, CsvError> {
    let names = [
        "series",
        "number",
        "part",
        "file",
        "time",
        "characteristic",
        "value",
        "unit",
        "lower_limit",
        "upper_limit",
    ];
    let mut table = CsvTable::new(&names.map(|name| Column::new(name, "")));
    let optional = |value: Option<f64>| value.map_or(Cell::Empty, Cell::Number);
    for group in &result.groups {
        // By part: the rows of a part stand together.
        for part in &group.parts {
            for of in &group.characteristics {
                let Ok(place) = of.parts.binary_search(&part.number) else { continue };
                table.push_cells(&[
                    Cell::Word(&group.series),
                    Cell::Number(part.number as f64),
                    Cell::Word(&part.part),
                    Cell::Word(&part.file),
                    part.time.as_deref().map_or(Cell::Empty, Cell::Word),
                    Cell::Word(&of.key),
                    Cell::Number(of.values[place]),
                    Cell::Word(&of.unit),
                    optional(of.lower_limit),
                    optional(of.upper_limit),
                ])?;
            }
        }
    }
    Ok(table)
}
