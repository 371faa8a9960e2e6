//! Tables of numbers: traces, fields, targets, tolerances, readings of a light barrier, reference pulses, points of a blade.

use std::fmt::Write;

use flankwright::exchange::inspection::{parse_topography, parse_trace_table, trace_table};
use flankwright::exchange::milling_job::{BladePoints, BladeSide, parse_point_grid};
use flankwright::exchange::{
    GridTarget, JobError, Source, parse_grid_target, parse_points, parse_reference_train,
    parse_skiving_readings, parse_tolerances, parse_traces, readings_table,
};
use flankwright::geometry::Flank;

use crate::complaints::of_text;

/// Tracks of a skiving tool in the seeds.
const TRACKS: usize = 5;

/// Every reader of tables takes the text or says why not.
pub fn table(data: &[u8]) {
    let source = match Source::from_bytes("table.csv", data) {
        Ok(source) => source,
        Err(error) => return of_text(&error),
    };
    traces(&source);
    grids(&source);
    readings(&source);
    taken(parse_reference_train(source.clone()));
}

fn taken<T>(found: Result<T, JobError>) -> Option<T> {
    found.inspect_err(of_text).ok()
}

fn again(text: &str) -> Source {
    Source::new("table.csv", text)
}

fn traces(source: &Source) {
    let Some(traces) = taken(parse_trace_table(source.clone())) else { return };
    for trace in &traces {
        assert_eq!(trace.abscissa_mm.len(), trace.f_um.len());
        assert!(trace.position_mm.is_finite() && trace.abscissa_mm.iter().all(|v| v.is_finite()));
        assert!(trace.abscissa_mm.windows(2).all(|pair| pair[0] < pair[1]));
        assert!(trace.f_um.iter().all(|v| !v.is_infinite()));
    }
    let table = trace_table(&traces).expect("a table of traces");
    let back = parse_trace_table(again(table.text())).expect("the table that was written");
    // As text, since NaN is no number to compare.
    assert_eq!(format!("{back:?}"), format!("{traces:?}"));
}

fn grids(source: &Source) {
    for parse in [parse_grid_target, parse_traces, parse_tolerances] {
        if let Some(grid) = taken(parse(source.clone())) {
            assert!(grid.w_mm.windows(2).all(|pair| pair[0] < pair[1]));
            assert!(grid.z_mm.windows(2).all(|pair| pair[0] < pair[1]));
            assert_eq!(grid.f_um.len(), grid.w_mm.len());
            assert!(grid.f_um.iter().all(|row| row.len() == grid.z_mm.len()));
            assert!(grid.f_um.iter().flatten().all(|v| v.is_finite()));
            let value = if source.text().contains("tolerance_um") { "tolerance_um" } else { "f_um" };
            assert_eq!(parse(again(&grid_text(&grid, value))).expect("the grid that was written"), grid);
        }
    }
    if let Some(points) = taken(parse_points(source.clone())) {
        assert!(points.iter().flatten().all(|v| v.is_finite()));
        let field = parse_topography(source.clone(), 1, Flank::Left).expect("a field of the same points");
        assert_eq!((field.points_mm.len(), field.f_um.len()), (points.len(), points.len()));
    }
    let wanted = BladePoints { file: "points.csv".into(), rows: 4, columns: 4, side: BladeSide::Left };
    if let Some(grid) = taken(parse_point_grid(source.clone(), &wanted)) {
        assert_eq!(grid.points.iter().map(Vec::len).sum::<usize>(), 16);
    }
}

fn grid_text(grid: &GridTarget, value: &str) -> String {
    let mut text = format!("w_mm,z_mm,{value}\n");
    for (w, row) in grid.w_mm.iter().zip(&grid.f_um) {
        for (z, f) in grid.z_mm.iter().zip(row) {
            writeln!(text, "{w},{z},{f}").expect("a text takes all");
        }
    }
    text
}

fn readings(source: &Source) {
    let Some(readings) = taken(parse_skiving_readings(source.clone(), TRACKS)) else { return };
    assert!(readings.iter().all(|reading| reading.angle.is_finite() && reading.track < TRACKS));
    let table = readings_table(&readings).expect("a table of readings");
    let back = parse_skiving_readings(again(table.text()), TRACKS).expect("the table that was written");
    assert_eq!(back, readings);
}
