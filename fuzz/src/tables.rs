//! Tables of numbers: measured traces and fields; targets, tolerances and points of a blade; readings of a light barrier, stock and
//! reference pulses.

use std::fmt::Write;

use flankwright::exchange::inspection::{
    GridSize, MeasuredTable, Topography, Touched, Trace, parse_grid_table, parse_measured_table,
    topography_table, trace_table,
};
use flankwright::exchange::milling_job::{BladePoints, BladeSide, parse_point_grid};
use flankwright::exchange::{
    GridTarget, Source, parse_grid_target, parse_measured_worm, parse_points, parse_probe_values,
    parse_profile, parse_reference_train, parse_skiving_readings, parse_stock, parse_tolerances,
    parse_traces, probe_table, readings_table,
};
use flankwright::process::skiving::measuring::Reading;

use crate::complaints::taken;

/// Tracks of a skiving tool in the seeds.
const TRACKS: usize = 5;

/// Measured traces and fields; every sample of the file is in what was read.
pub fn measured_table(data: &[u8]) {
    let Some(source) = taken(Source::from_bytes("measured.csv", data)) else { return };
    let rows = rows(source.text(), &['\n', '\r']);
    grid(&source, rows);
    match taken(parse_measured_table(source)) {
        Some(MeasuredTable::Traces(traces)) => {
            assert_eq!(traces.iter().map(|trace| trace.f_um.len()).sum::<usize>() + 1, rows);
            of_traces(&traces);
        }
        Some(MeasuredTable::Fields(fields)) => {
            assert_eq!(fields.iter().map(|field| field.f_um.len()).sum::<usize>() + 1, rows);
            of_fields(&fields);
        }
        None => {}
    }
}

/// Points of a bevel gear's measuring grid.
fn grid(source: &Source, rows: usize) {
    let size = GridSize { teeth: 16, rows: 5, columns: 9 };
    let Some(points) = taken(parse_grid_table(source.clone(), size)) else { return };
    assert_eq!(points.len() + 1, rows);
    for point in points {
        assert!((1..=size.teeth).contains(&point.tooth));
        assert!((1..=size.rows).contains(&point.row) && (1..=size.columns).contains(&point.column));
        match point.found {
            Touched::Deviation(um) => assert!(!um.is_infinite()),
            Touched::At(place) => assert!(place.iter().all(|x| x.is_finite())),
        }
    }
}

/// What jobs name: targets, traces, tolerances, clouds of points, rows of points in space, readings of a light barrier, stock, reference pulses.
pub fn table(data: &[u8]) {
    let Some(source) = taken(Source::from_bytes("table.csv", data)) else { return };
    grids(&source);
    readings(&source);
    probe(&source);
    measured_worm(&source);
    stock(&source);
    taken(parse_reference_train(source));
}

/// Rows that count, the titles among them. Tables of measurements may end them by carriage returns, too.
fn rows(text: &str, ends: &[char]) -> usize {
    text.split(ends).filter(|line| !line.trim().is_empty() && !line.starts_with('#')).count()
}

fn again(text: &str) -> Source {
    Source::new("table.csv", text)
}

fn of_traces(traces: &[Trace]) {
    for trace in traces {
        assert_eq!(trace.abscissa_mm.len(), trace.f_um.len());
        assert!(trace.position_mm.is_finite() && trace.abscissa_mm.iter().all(|v| v.is_finite()));
        assert!(trace.abscissa_mm.windows(2).all(|pair| pair[0] < pair[1]));
        assert!(trace.f_um.iter().all(|v| !v.is_infinite()));
    }
    let table = trace_table(traces).expect("a table of traces");
    let back = parse_measured_table(again(table.text())).expect("the table that was written");
    // As text, since NaN is no number to compare.
    assert_eq!(format!("{back:?}"), format!("Traces({traces:?})"));
}

fn of_fields(fields: &[Topography]) {
    for field in fields {
        assert_eq!(field.points_mm.len(), field.f_um.len());
        assert!(field.points_mm.iter().flatten().all(|v| v.is_finite()));
        assert!(field.f_um.iter().all(|v| !v.is_infinite()));
    }
    let table = topography_table(fields).expect("a table of fields");
    let back = parse_measured_table(again(table.text())).expect("the table that was written");
    assert_eq!(format!("{back:?}"), format!("Fields({fields:?})"));
}

fn grids(source: &Source) {
    for parse in [parse_grid_target, parse_traces, parse_tolerances] {
        if let Some(grid) = taken(parse(source.clone())) {
            assert_eq!(grid.w_mm.len() * grid.z_mm.len() + 1, rows(source.text(), &['\n']));
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
        assert_eq!(points.len() + 1, rows(source.text(), &['\n']));
    }
    if let Some(points) = taken(parse_profile(source.clone())) {
        // Places without a value are left out.
        assert!(points.len() < rows(source.text(), &['\n']));
        assert!(points.iter().all(|[w, f]| *w >= 0.0 && f.abs() <= 1e5));
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

/// Points of a worm: every row of the file is one.
fn measured_worm(source: &Source) {
    let Some(points) = taken(parse_measured_worm(source.clone())) else { return };
    let mut all = points.left.iter().chain(&points.right).flatten();
    assert!(all.all(|x| x.is_finite()));
}

/// Stock of a gear with three spaces.
fn stock(source: &Source) {
    let Some(table) = taken(parse_stock(source.clone(), 3)) else { return };
    assert!(table.flanks.left.is_some() || table.flanks.right.is_some());
    for (flank, map) in table.flanks.iter() {
        let spaces = map.as_ref().map(|map| map.spaces());
        assert!(matches!(spaces, None | Some(1 | 3)) && table.left_out[flank] < 3);
    }
}

fn probe(source: &Source) {
    let Some(values) = taken(parse_probe_values(source.clone())) else { return };
    assert!(values.iter().all(|value| value.w.is_finite() && value.deviation.is_finite()));
    let table = probe_table(&values).expect("a table of values");
    assert_eq!(
        parse_probe_values(again(table.text())).expect("the table that was written").len(),
        values.len()
    );
}

fn readings(source: &Source) {
    let Some(readings) = taken(parse_skiving_readings(source.clone(), TRACKS)) else { return };
    assert!(readings.iter().all(|reading| reading.angle.is_finite() && reading.track < TRACKS));
    let table = readings_table(&readings).expect("a table of readings");
    let back = parse_skiving_readings(again(table.text()), TRACKS).expect("the table that was written");
    // Degrees and back leave a rounding of the last digit.
    assert_eq!(back.len(), readings.len());
    for (a, b) in back.iter().zip(&readings) {
        assert!((a.angle - b.angle).abs() <= 4.0 * f64::EPSILON * b.angle.abs(), "{a:?} {b:?}");
        assert_eq!(Reading { angle: 0.0, ..*a }, Reading { angle: 0.0, ..*b });
    }
}
