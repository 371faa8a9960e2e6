//! Tables of a run as CSV: topographies of the flanks and both motions over their strokes.

use super::executed_strokes::ExecutedStrokes;
use super::execution::ExecutedFlank;
use super::result::FlankResult;
use super::run::Outcome;
use foundation::geometry::Flank;
use foundation::kinematics::{DressingMotion, GeneratingMotion};
use foundation::numerics::equidistant;
use job::{Column, CsvError, CsvTable};

/// Rows of a motion table and points of a motion chart.
pub const ROWS: usize = 201;

/// Target, planned, simulated and deviation of every flank, um, normal.
///
/// # Errors
/// A value that is not finite.
pub fn topography<'a>(
    flanks: impl Iterator<Item = (&'a str, &'a FlankResult)>,
) -> Result<CsvTable, CsvError> {
    let columns = [
        Column::new("w", "mm"),
        Column::new("z", "mm"),
        Column::new("target", "um"),
        Column::new("planned", "um"),
        Column::new("simulated", "um"),
        Column::new("deviation", "um"),
    ];
    let mut table = CsvTable::labelled("flank", &columns);
    for (name, f) in flanks {
        for (i, &w) in f.w_mm.iter().enumerate() {
            for (j, &z) in f.z_mm.iter().enumerate() {
                let (t, p, s) = (f.target_um[i][j], f.planned_um[i][j], f.simulated_um[i][j]);
                table.push_labelled(name, &[w, z, t, p, s, s - t])?;
            }
        }
    }
    Ok(table)
}

/// Sections of the ground root; `None` where the worm's tip does not grind it.
///
/// # Errors
/// A value that is not finite.
pub fn gear_root(outcome: &Outcome) -> Result<Option<CsvTable>, CsvError> {
    let Some(root) = &outcome.result.gear_root else { return Ok(None) };
    let columns = [
        Column::new("z", "mm"),
        Column::new("x", "mm"),
        Column::new("y", "mm"),
        Column::new("diameter", "mm"),
    ];
    let mut table = CsvTable::labelled("flank", &columns);
    for (flank, fillet) in root.flanks.iter() {
        for section in fillet.iter().flat_map(|fillet| &fillet.sections) {
            for &[x, y] in &section.points_mm {
                table.push_labelled(flank.name(), &[section.z_mm, x, y, 2.0 * x.hypot(y)])?;
            }
        }
    }
    Ok(Some(table))
}

/// The grinding motion over the feed z_V2.
///
/// # Errors
/// A value that is not finite.
pub fn grinding_motion(motion: &GeneratingMotion, feed_range: [f64; 2]) -> Result<CsvTable, CsvError> {
    let mut table = CsvTable::new(&[
        Column::new("z_V2", "mm"),
        Column::new("z_V1", "mm"),
        Column::new("delta_d", "um"),
        Column::new("centre_distance", "mm"),
        Column::new("delta_phi_2", "urad"),
        Column::new("crossed_axes_angle", "deg"),
    ]);
    for v in equidistant(feed_range, ROWS) {
        let (d, phi) = (motion.delta_d.value(v), motion.delta_phi_2.value(v));
        table.push(&[
            v,
            motion.shift.value(v),
            d * 1e3,
            motion.chain.centre_distance + d,
            phi * 1e6,
            (motion.chain.crossed_axes_angle + motion.delta_gamma.value(v)).to_degrees(),
        ])?;
    }
    Ok(table)
}

/// The dressing motion of one flank over the worm position v_zS; `None` if the flank is not dressed.
///
/// # Errors
/// A value that is not finite.
pub fn dressing_motion(outcome: &Outcome, flank: Flank) -> Result<Option<CsvTable>, CsvError> {
    let executed = outcome.execution.flanks[flank].as_ref();
    if let Some(strokes) = executed.and_then(ExecutedFlank::strokes) {
        return stroke_motions(strokes).map(Some);
    }
    let Some(dressing) = executed.and_then(ExecutedFlank::dressing) else {
        return Ok(None);
    };
    let motion = &dressing.motion;
    let (from, to) = dressing.corrections[0].interval();
    let mut table = CsvTable::new(&motion_columns());
    for v in equidistant([from, to], ROWS) {
        table.push(&motion_row(motion, v))?;
    }
    Ok(Some(table))
}

fn motion_columns() -> [Column; 9] {
    [
        Column::new("v_zS", "mm"),
        Column::new("d_phi_S", "deg"),
        Column::new("d_gamma", "deg"),
        Column::new("d_d", "mm"),
        Column::new("d_v_yA", "mm"),
        Column::new("phi_S", "deg"),
        Column::new("gamma_A", "deg"),
        Column::new("d_A", "mm"),
        Column::new("v_yA", "mm"),
    ]
}

fn motion_row(motion: &DressingMotion, v: f64) -> [f64; 9] {
    let dk = motion.correction_at(v);
    let at = motion.position(v);
    [
        v,
        dk[0].to_degrees(),
        dk[1].to_degrees(),
        dk[2],
        dk[3],
        at.worm_angle.to_degrees(),
        at.crossing_angle.to_degrees(),
        at.centre_distance,
        at.offset,
    ]
}

/// The motions of all strokes one after the other, with the numbers of stroke and dresser before each row.
fn stroke_motions(strokes: &ExecutedStrokes) -> Result<CsvTable, CsvError> {
    let numbers = [Column::new("stroke", ""), Column::new("dresser", "")];
    let columns: Vec<Column> = numbers.into_iter().chain(motion_columns()).collect();
    let mut table = CsvTable::new(&columns);
    for (k, stroke) in strokes.strokes.iter().enumerate() {
        let (from, to) = stroke.corrections[0].interval();
        for v in equidistant([from, to], ROWS) {
            let numbers = [(k + 1) as f64, (stroke.place.dresser + 1) as f64];
            let row: Vec<f64> = numbers.into_iter().chain(motion_row(&stroke.motion, v)).collect();
            table.push(&row)?;
        }
    }
    Ok(table)
}

/// The flank of a tool that is not dressed: its modification over (w_1, z_1); `None` for a dressed one.
///
/// # Errors
/// A value that is not finite.
pub fn tool_flank(outcome: &Outcome, flank: Flank) -> Result<Option<CsvTable>, CsvError> {
    let Some(made) = outcome.execution.flanks[flank].as_ref().and_then(ExecutedFlank::made) else {
        return Ok(None);
    };
    let mut table =
        CsvTable::new(&[Column::new("w_1", "mm"), Column::new("z_1", "mm"), Column::new("f_n1", "um")]);
    for (&w, row) in made.w.iter().zip(&made.f) {
        for (&z, f) in made.z.iter().zip(row) {
            table.push(&[w, z, f * 1e3])?;
        }
    }
    Ok(Some(table))
}

/// Lines are many: their numbers stand to a ten-millionth of a mm or degree, which moves a worm of 300 mm by less than 1e-6 mm.
const LINE_DIGITS: f64 = 1e7;

/// The motion of a disc in point contact along all lines of one thread, in the order in which they are driven; `None` if the flank is
/// not written so.
///
/// # Errors
/// A value that is not finite.
pub fn dressing_lines(outcome: &Outcome, flank: Flank) -> Result<Option<CsvTable>, CsvError> {
    let Some(written) = &outcome.written[flank] else { return Ok(None) };
    let mut table = CsvTable::new(&[
        Column::new("line", ""),
        Column::new("X_1", "mm"),
        Column::new("w_1", "mm"),
        Column::new("z_1", "mm"),
        Column::new("phi_S", "deg"),
        Column::new("v_zS", "mm"),
        Column::new("d_A", "mm"),
        Column::new("gamma_A", "deg"),
        Column::new("v_yA", "mm"),
    ]);
    for (k, (line, positions)) in written.plan.lines.iter().zip(&written.positions).enumerate() {
        for (t, at) in positions {
            let (w, z) = line.point(*t);
            let row = [
                k as f64,
                line.coordinate,
                w,
                z,
                at.worm_angle.to_degrees(),
                at.worm_shift,
                at.centre_distance,
                at.crossing_angle.to_degrees(),
                at.offset,
            ];
            table.push(&row.map(|x| (x * LINE_DIGITS).round() / LINE_DIGITS))?;
        }
    }
    Ok(Some(table))
}
