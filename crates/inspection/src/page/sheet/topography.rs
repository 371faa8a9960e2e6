//! Pages of measured fields: two nets beside each other, their features below.

use super::book::{BOTTOM, Book, LABEL, MARGIN, TEXT, THIN, WIDTH, centred, from_left};
use super::data::{SheetData, SheetTopography};
use super::foot::{LINE, draw_value};
use super::head;
use super::text_fit::wrapped;
use super::topography_net::Net;
use foundation::geometry::Flank;
use report::charts::magnification::{bar, drawn, of_traces, words};
use report::charts::{INK, Stroke, format_significant};

/// Fields on a page: columns and rows.
const COLUMNS: usize = 2;
const ROWS: usize = 2;
/// Distance of the fields.
const GAP: f64 = 2.0;
/// Size of a nominal flank and its place in the field of the page.
const NET: [f64; 2] = [54.0, 52.0];
const CORNER: [f64; 2] = [20.0, 74.0];
/// How far deviations may reach beyond it on paper.
const REACH: f64 = 13.0;
/// Where the features begin.
const FEATURES: f64 = 93.0;

/// Adds the pages; none without fields.
pub(super) fn draw(book: &mut Book, sheet: &SheetData) {
    let top = MARGIN + head::HEIGHT + GAP;
    let width = (WIDTH - GAP) / COLUMNS as f64;
    let height = (BOTTOM - LINE - top - GAP) / ROWS as f64;
    for row in pairs(&sheet.topographies).chunks(ROWS) {
        book.turn("topography");
        head::draw(book, sheet, "topography");
        for (k, fields) in row.iter().enumerate() {
            let y = top + k as f64 * (height + GAP);
            for (column, field) in fields.iter().enumerate() {
                let x = MARGIN + column as f64 * (width + GAP);
                book.page().rect([x, y], [width, height], "none", Some(THIN));
                match field {
                    Some(field) => draw_field(book, field, [x, y], [width, height]),
                    None => {
                        let at = [x + 0.5 * width, y + 0.5 * height];
                        book.text(at, "not measured", centred(TEXT));
                    }
                }
            }
        }
    }
}

/// Left and right flank of a tooth beside each other, in the order of the teeth.
fn pairs(fields: &[SheetTopography]) -> Vec<[Option<&SheetTopography>; 2]> {
    let mut pairs: Vec<(u32, [Option<&SheetTopography>; 2])> = Vec::new();
    for field in fields {
        let column = usize::from(field.flank == Flank::Right);
        let free = pairs.iter_mut().find(|(tooth, pair)| *tooth == field.tooth && pair[column].is_none());
        match free {
            Some((_, pair)) => pair[column] = Some(field),
            None => {
                let mut pair = [None; 2];
                pair[column] = Some(field);
                pairs.push((field.tooth, pair));
            }
        }
    }
    pairs.sort_by_key(|(tooth, _)| *tooth);
    pairs.into_iter().map(|(_, pair)| pair).collect()
}

fn draw_field(book: &mut Book, field: &SheetTopography, [x, y]: [f64; 2], [width, height]: [f64; 2]) {
    let largest = field.f_um.iter().flatten().filter(|f| f.is_finite()).fold(0.0, |m: f64, f| m.max(f.abs()));
    let magnification = of_traces(largest / std::f64::consts::SQRT_2, REACH);
    let title = format!("Topography, tooth {}, {} flank", field.tooth, field.flank);
    book.fitted([x + 2.0, y + 4.0], 0.7 * width, &title, from_left(TEXT).bold());
    let text = format!("f {}", words(magnification));
    book.fitted([x + 0.76 * width, y + 4.0], 0.22 * width, &text, from_left(TEXT).bold());
    scale_bar(book, [x + 2.0, y + 8.0], magnification, field.flank);
    let corner = [x + CORNER[0], y + CORNER[1]];
    Net { field, corner, size: NET, magnification }.draw(book);
    let lines = wrapped(&field.note, LABEL, width - 4.0);
    let rows = field.features.len().div_ceil(2).max(1) as f64;
    let room = height - FEATURES - 2.6 * lines.len() as f64 - 1.0;
    let pitch = (room / rows).clamp(0.5, 3.2);
    let half = 0.5 * (width - 4.0);
    for (k, value) in field.features.iter().enumerate() {
        let at = [x + 2.0 + half * (k % 2) as f64, y + FEATURES + pitch * ((k / 2) as f64 + 0.8)];
        draw_value(book, at, half, value, TEXT.min(0.82 * pitch));
    }
    let note = y + FEATURES + pitch * rows + 1.0;
    for (k, line) in lines.iter().enumerate() {
        book.page().text([x + 2.0, note + 2.6 * (k as f64 + 0.8)], line, from_left(LABEL).verbatim());
    }
}

/// A bar in the direction in which deviations are drawn.
fn scale_bar(book: &mut Book, [x, y]: [f64; 2], magnification: f64, flank: Flank) {
    let (um, _) = bar(10.0, drawn(1.0, magnification), 3.0);
    let d = drawn(um, magnification) / std::f64::consts::SQRT_2;
    let (from, to) = match flank {
        Flank::Left => ([x, y + d], [x + d, y]),
        Flank::Right => ([x + d, y + d], [x, y]),
    };
    book.page().line(from, to, Stroke::solid(INK, 0.35));
    let text = format!("{} µm material", format_significant(um, 3));
    book.text([x + d + 1.5, y + 0.5 * d + 0.8], &text, from_left(LABEL));
}
