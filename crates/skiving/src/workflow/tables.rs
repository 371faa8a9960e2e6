//! Tables of a measured skiving tool as CSV.

use super::result::{MeasurementResult, MonteCarloResult, ScanResult, SkivingResult};
use job::{Cell, Column, CsvError, CsvTable};

/// A number, or nothing where a tooth did not switch.
fn known(value: Option<f64>) -> Cell<'static> {
    value.map_or(Cell::Empty, Cell::Number)
}

/// Tracks and poses.
///
/// # Errors
/// A value that is not finite.
pub fn poses(result: &SkivingResult) -> Result<CsvTable, CsvError> {
    let mut table = CsvTable::labelled(
        "flank",
        &[
            Column::new("track", ""),
            Column::new("x", ""),
            Column::new("w", "mm"),
            Column::new("phi_1", "deg"),
            Column::new("R", "mm"),
            Column::new("height", "mm"),
            Column::new("theta", "deg"),
            Column::new("lever", "mm_per_rad"),
            Column::new("A", "deg"),
            Column::new("B", "deg"),
            Column::new("X", "mm"),
            Column::new("Y", "mm"),
            Column::new("Z", "mm"),
            Column::new("off_flank", "deg"),
            Column::new("gap", "mm"),
        ],
    );
    for (flank, tracks) in &result.tracks {
        for t in tracks {
            let [x, y, z] = t.position_mm;
            table.push_labelled(
                flank,
                &[
                    t.track as f64,
                    t.place,
                    t.w_mm,
                    t.tool_angle_deg,
                    t.radius_mm,
                    t.height_mm,
                    t.contact_angle_deg,
                    t.lever_mm_per_rad,
                    t.a_deg,
                    t.b_deg,
                    x,
                    y,
                    z,
                    t.off_flank_deg,
                    t.other_flank_gap_mm,
                ],
            )?;
        }
    }
    Ok(table)
}

/// The workpiece to come.
///
/// # Errors
/// A value that is not finite.
pub fn profile(result: &SkivingResult) -> Result<CsvTable, CsvError> {
    let mut table = CsvTable::new(&[
        Column::new("flank", ""),
        Column::new("w", "mm"),
        Column::new("target", "um"),
        Column::new("planned", "um"),
        Column::new("simulated", "um"),
        Column::new("corrected", "um"),
    ]);
    for (name, f) in &result.flanks {
        for (i, w) in f.w_mm.iter().enumerate() {
            table.push_cells(&[
                Cell::Word(name),
                Cell::Number(*w),
                Cell::Number(f.target_um[i][0]),
                Cell::Number(f.planned_um[i][0]),
                Cell::Number(f.simulated_um[i][0]),
                Cell::Number(f.corrected_um[i]),
            ])?;
        }
    }
    Ok(table)
}

/// Deviations of every tooth on every track.
///
/// # Errors
/// A value that is not finite.
pub fn deviations(measurement: &MeasurementResult) -> Result<CsvTable, CsvError> {
    let mut table = CsvTable::new(&[
        Column::new("flank", ""),
        Column::new("track", ""),
        Column::new("tooth", ""),
        Column::new("deviation", "um"),
        Column::new("remaining", "um"),
    ]);
    for (flank, tracks) in &measurement.deviation_um {
        for (track, teeth) in tracks.iter().enumerate() {
            for (tooth, f) in teeth.iter().enumerate() {
                let remaining = measurement.remaining_um[flank][track][tooth];
                table.push_cells(&[
                    Cell::Word(flank),
                    Cell::Number((track + 1) as f64),
                    Cell::Number(tooth as f64),
                    known(*f),
                    known(remaining),
                ])?;
            }
        }
    }
    Ok(table)
}

/// Pitch and thickness of every tooth.
///
/// # Errors
/// A value that is not finite.
pub fn pitch(measurement: &MeasurementResult) -> Result<CsvTable, CsvError> {
    let mut table = CsvTable::new(&[
        Column::new("tooth", ""),
        Column::new("single", "um"),
        Column::new("cumulative", "um"),
        Column::new("thickness", "um"),
        Column::new("centre", "deg"),
    ]);
    let p = &measurement.pitch;
    for tooth in 0..p.single_um.len() {
        table.push_cells(&[
            Cell::Number(tooth as f64),
            known(p.single_um[tooth]),
            known(p.cumulative_um[tooth]),
            known(p.thickness_um[tooth]),
            known(p.centre_deg[tooth]),
        ])?;
    }
    Ok(table)
}

/// Places of the scan; what each tooth shows in a row of its own.
///
/// # Errors
/// A value that is not finite.
pub fn scan(scan: &ScanResult) -> Result<CsvTable, CsvError> {
    let mut table = CsvTable::new(&[
        Column::new("flank", ""),
        Column::new("x", ""),
        Column::new("w", "mm"),
        Column::new("A", "deg"),
        Column::new("B", "deg"),
        Column::new("X", "mm"),
        Column::new("Y", "mm"),
        Column::new("Z", "mm"),
        Column::new("tooth", ""),
        Column::new("deviation", "um"),
    ]);
    for place in &scan.places {
        let [x, y, z] = place.position_mm;
        let numbers = [place.place, place.w_mm, place.a_deg, place.b_deg, x, y, z];
        let begin = || {
            let mut row = vec![Cell::Word(place.flank)];
            row.extend(numbers.map(Cell::Number));
            row
        };
        if place.deviation_um.is_empty() {
            let mut row = begin();
            row.extend([Cell::Empty, Cell::Empty]);
            table.push_cells(&row)?;
        }
        for (tooth, f) in scan.teeth.iter().zip(&place.deviation_um) {
            let mut row = begin();
            row.extend([Cell::Number(*tooth as f64), Cell::Number(*f)]);
            table.push_cells(&row)?;
        }
    }
    Ok(table)
}

/// How results scatter.
///
/// # Errors
/// A value that is not finite.
pub fn monte_carlo(result: &MonteCarloResult) -> Result<CsvTable, CsvError> {
    let mut table = CsvTable::new(&[
        Column::new("result", ""),
        Column::new("unit", ""),
        Column::new("mean", ""),
        Column::new("sigma", ""),
        Column::new("stated_sigma", ""),
        Column::new("from", ""),
        Column::new("to", ""),
    ]);
    for r in &result.results {
        table.push_cells(&[
            Cell::Word(&r.name),
            Cell::Word(r.unit),
            Cell::Number(r.mean),
            Cell::Number(r.sigma),
            r.stated_sigma.map_or(Cell::Empty, Cell::Number),
            Cell::Number(r.interval[0]),
            Cell::Number(r.interval[1]),
        ])?;
    }
    Ok(table)
}
