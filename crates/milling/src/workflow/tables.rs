//! Tables of a milling run as CSV: the topography of the flanks, the places of the cutter, the points at which the flanks are measured.

use super::prepare::MeasuringPoint;
use super::result::MillingResult;
use crate::MillingPlan;
use job::{Cell, Column, CsvError, CsvTable};

/// Prediction and deviation at every ray; an empty field where no cutter comes by.
///
/// # Errors
/// A value that is not finite.
pub(super) fn topography(result: &MillingResult) -> Result<CsvTable, CsvError> {
    let columns = [
        Column::new("flank", ""),
        Column::new("height", ""),
        Column::new("length", ""),
        Column::new("planned", "um"),
        Column::new("simulated", "um"),
    ];
    let mut table = CsvTable::new(&columns);
    let cell = |value: Option<f64>| value.map_or(Cell::Empty, Cell::Number);
    for (name, flank) in &result.flanks {
        let rays = flank.height.iter().flat_map(|a| flank.length.iter().map(move |b| (*a, *b)));
        for ((a, b), (planned, simulated)) in rays.zip(flank.planned_um.iter().zip(&flank.simulated_um)) {
            let row = [Cell::Word(name), Cell::Number(a), Cell::Number(b), cell(*planned), cell(*simulated)];
            table.push_cells(&row)?;
        }
    }
    Ok(table)
}

/// Every place of the cutter in the space about +y, in the order of cutting.
///
/// # Errors
/// A value that is not finite.
pub(super) fn places(plan: &MillingPlan) -> Result<CsvTable, CsvError> {
    let columns = [
        Column::new("operation", ""),
        Column::new("path", ""),
        Column::new("x", "mm"),
        Column::new("y", "mm"),
        Column::new("z", "mm"),
        Column::new("i", ""),
        Column::new("j", ""),
        Column::new("k", ""),
    ];
    let mut table = CsvTable::new(&columns);
    for operation in &plan.operations {
        let name = operation.kind.to_string();
        for (number, path) in operation.paths.iter().enumerate() {
            for place in &path.places {
                let mut row = vec![Cell::Word(&name), Cell::Number(number as f64)];
                row.extend(place.tip.iter().chain(place.axis.iter()).map(|x| Cell::Number(*x)));
                table.push_cells(&row)?;
            }
        }
    }
    Ok(table)
}

/// The points at which a measuring machine touches the flanks of the space about +y, with their normals out of the material.
///
/// # Errors
/// A value that is not finite.
pub(super) fn measuring_grid(points: &[MeasuringPoint]) -> Result<CsvTable, CsvError> {
    let columns = [
        Column::new("flank", ""),
        Column::new("row", ""),
        Column::new("column", ""),
        Column::new("roll", "mm"),
        Column::new("along", "mm"),
        Column::new("x", "mm"),
        Column::new("y", "mm"),
        Column::new("z", "mm"),
        Column::new("nx", ""),
        Column::new("ny", ""),
        Column::new("nz", ""),
    ];
    let mut table = CsvTable::new(&columns);
    for at in points {
        let mut row = vec![Cell::Word(at.flank.name())];
        row.extend([at.row, at.column].map(|number| Cell::Number(number as f64)));
        row.extend([at.roll, at.position].map(Cell::Number));
        row.extend(at.point.iter().chain(at.normal.iter()).map(|x| Cell::Number(*x)));
        table.push_cells(&row)?;
    }
    Ok(table)
}
