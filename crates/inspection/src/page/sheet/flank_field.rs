//! The field of one flank: lanes with traces, mean lines and bands, lines across, the bar of the scale. Material lies to the outside.

use super::book::{Book, DASHED_LIMIT, GRID, LABEL, LIMIT, THIN, TRACE, centred, from_left, from_right};
use super::flank_place::FlankPlace;
use super::laid_row::{DIAGRAM, FIELD, PLOT, PlacedRow};
use super::reach::{beside, zero_of};
use super::traces_data::{LineLook, SheetTrace};
use foundation::geometry::Flank;
use report::charts::magnification;
use report::charts::{INK, MUTED, Stroke, format_significant};

/// Outline of a band.
const BAND: Stroke = Stroke::solid("#8b9097", 0.3);
/// Below the traces: the number of the tooth, then the bar of the scale.
const TOOTH_LINE: f64 = 51.2;
const BAR_LINE: f64 = 54.4;

/// Draws the lanes of a flank with everything that belongs to them.
pub(super) fn draw_field(book: &mut Book, row: &PlacedRow, place: &FlankPlace) {
    let [from, to] = PLOT.map(|y| row.top + y);
    for line in &row.laid.row.flanks[place.flank].lines {
        let stroke = match line.look {
            LineLook::End => GRID,
            LineLook::Limit => LIMIT,
            LineLook::Relief => DASHED_LIMIT,
        };
        let y = row.ordinate.y(line.at_mm);
        book.page().line([place.left(), y], [place.left() + FIELD, y], stroke);
    }
    let mut mean_lines = Vec::new();
    for (k, lane) in row.lanes.iter().enumerate() {
        let Some(trace) = lane.traces[place.flank] else { continue };
        let axis = row.laid.pitch * (k + 1) as f64;
        let x = place.outward(axis);
        book.page().line([x, from], [x, to], GRID);
        let zero = zero_of(trace);
        let at = |[a, f]: [f64; 2]| [place.outward(axis + row.drawn(f - zero)), row.ordinate.y(a)];
        draw_band(book, trace, &at);
        mean_lines.extend(trace.mean_line.map(|ends| ends.map(at).to_vec()));
        book.page().polylines(&curves(trace, at), TRACE);
        let y = row.top + TOOTH_LINE;
        book.text([x, y], &trace.tooth.to_string(), centred(LABEL));
        if let Some(band) = &trace.band {
            draw_mark(book, [x + 3.4, y - 0.8], band.passed);
        }
    }
    book.page().polylines(&mean_lines, THIN);
    draw_bars(book, row, place);
}

/// The samples of a trace without its gaps.
fn curves(trace: &SheetTrace, at: impl Fn([f64; 2]) -> [f64; 2]) -> Vec<Vec<[f64; 2]>> {
    let mut lines = Vec::new();
    let mut line = Vec::with_capacity(trace.f_um.len());
    for (&a, &f) in trace.abscissa_mm.iter().zip(&trace.f_um) {
        if f.is_finite() {
            line.push(at([a, f]));
        } else if !line.is_empty() {
            lines.push(std::mem::take(&mut line));
        }
    }
    lines.push(line);
    // A line of one point draws nothing: it becomes a dot.
    for line in &mut lines {
        if let [[x, y]] = line[..] {
            line.push([x, y + 0.1]);
        }
    }
    lines
}

fn draw_band(book: &mut Book, trace: &SheetTrace, at: &impl Fn([f64; 2]) -> [f64; 2]) {
    let limits: Vec<[f64; 3]> = beside(trace).collect();
    let lower = limits.iter().map(|[a, lo, _]| at([*a, *lo]));
    let upper = limits.iter().rev().map(|[a, _, hi]| at([*a, *hi]));
    book.page().loops(&[lower.chain(upper).collect()], "none", Some(BAND));
}

/// A tick for passed, a cross for not.
fn draw_mark(book: &mut Book, [x, y]: [f64; 2], passed: bool) {
    let lines = if passed {
        vec![vec![[x - 0.9, y], [x - 0.3, y + 0.7], [x + 0.9, y - 0.9]]]
    } else {
        vec![vec![[x - 0.8, y - 0.8], [x + 0.8, y + 0.8]], vec![[x - 0.8, y + 0.8], [x + 0.8, y - 0.8]]]
    };
    book.page().polylines(&lines, Stroke::solid(INK, 0.35));
}

/// Bars of round lengths in the outer corner: deviation below the traces, the coordinate beside them.
fn draw_bars(book: &mut Book, row: &PlacedRow, place: &FlankPlace) {
    let (um, across) = magnification::bar(10.0, row.drawn(1.0), 2.5);
    let (mm, along) = magnification::bar(1.0, row.ordinate.magnification(), 3.0);
    let [outer, inner] = [FIELD - 1.2, FIELD - 1.2 - across].map(|d| place.outward(d));
    let y = row.top + BAR_LINE;
    let bar = Stroke::solid(INK, 0.25);
    let end = |x: f64| vec![[x, y - 0.6], [x, y + 0.6]];
    let upper = y - along;
    let corner = vec![[inner, y], [outer, y], [outer, upper]];
    let cap = vec![[outer - 0.6, upper], [outer + 0.6, upper]];
    book.page().polylines(&[corner, end(inner), cap], bar);
    let style = if place.flank == Flank::Left { from_left(LABEL) } else { from_right(LABEL) };
    let text = format!("{} µm", format_significant(um, 3));
    book.text([place.outward(FIELD - 1.8 - across), y + 0.7], &text, style);
    let text = format!("{} mm", format_significant(mm, 3));
    let x = place.outward(FIELD - 1.9) + if place.flank == Flank::Left { 1.4 } else { 0.0 };
    let upright = report::charts::TextStyle { color: MUTED, ..from_left(LABEL) }.turned(-90.0);
    let from = (y - 0.9).min(row.top + DIAGRAM);
    book.text([x, from], &text, upright);
}
