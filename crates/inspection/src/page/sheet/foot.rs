//! The foot of the first page: sizes, the result with its classes, warnings.

use super::book::{BOTTOM, Book, LABEL, MARGIN, TEXT, THIN, from_left, from_right};
use super::data::{SheetFoot, SheetSize, SheetValue};
use super::text_fit::{number, wrapped};
use super::value_table::{draw_judged, limit_words};

/// Below the content: product and page number.
pub(super) const LINE: f64 = 3.4;
/// Columns from the left border: sizes, results, warnings.
const COLUMNS: [[f64; 2]; 3] = [[0.0, 72.0], [74.0, 56.0], [132.0, 58.0]];
const HEADING: f64 = 4.0;
const ROW: f64 = 3.05;
/// Height of a line of the warnings, and its size.
const FINE: f64 = 2.45;

/// Draws the foot with its top at y, down to the last line of the page.
pub(super) fn draw(book: &mut Book, foot: &SheetFoot, top: f64) {
    let bottom = BOTTOM - LINE;
    for ([left, width], title) in COLUMNS.iter().zip(["Sizes", "Result", "Warnings"]) {
        let left = MARGIN + left;
        book.page().rect([left, top], [*width, bottom - top], "none", Some(THIN));
        book.text([left + 1.0, top + 3.0], title, from_left(TEXT).bold());
    }
    sizes(book, &foot.sizes, top, bottom);
    results(book, foot, top, bottom);
    warnings(book, &foot.warnings, top, bottom);
}

fn sizes(book: &mut Book, sizes: &[SheetSize], top: f64, bottom: f64) {
    let [left, width] = COLUMNS[0];
    let left = MARGIN + left;
    let ends = [40.5, 55.5, 70.5].map(|x| left + x);
    if sizes.is_empty() {
        book.text([left + 1.0, top + 8.0], "not measured", from_left(TEXT));
        return;
    }
    for (x, word) in ends.iter().zip(["mean mm", "min mm", "max mm"]) {
        book.text([x - 0.8, top + 3.0], word, from_right(LABEL).muted());
    }
    let pitch = ROW.min((bottom - top - HEADING) / sizes.len() as f64);
    let size = TEXT.min(0.82 * pitch);
    for (k, of) in sizes.iter().enumerate() {
        let y = top + HEADING + pitch * (k as f64 + 0.8);
        book.fitted([left + 1.0, y], 0.37 * width, &of.name, from_left(size));
        for (x, value) in ends.iter().zip([of.mean_mm, of.least_mm, of.largest_mm]) {
            book.fitted([x - 0.8, y], 13.0, &number(value, 3), from_right(size));
        }
    }
}

fn results(book: &mut Book, foot: &SheetFoot, top: f64, bottom: f64) {
    let [left, width] = COLUMNS[1];
    let left = MARGIN + left;
    let overall = if foot.overall.is_empty() { "not judged" } else { &foot.overall };
    book.fitted([left + 12.0, top + 3.0], width - 13.0, overall, from_left(TEXT).bold());
    let pitch = ROW.min((bottom - top - HEADING) / foot.results.len().max(1) as f64);
    let size = TEXT.min(0.82 * pitch);
    for (k, value) in foot.results.iter().enumerate() {
        draw_value(book, [left, top + HEADING + pitch * (k as f64 + 0.8)], width, value, size);
    }
}

/// A value in a line: symbol, number with unit, limit, class.
pub(super) fn draw_value(book: &mut Book, [left, y]: [f64; 2], width: f64, value: &SheetValue, size: f64) {
    let at = |share: f64| left + share * width;
    book.fitted([left + 1.0, y], 0.25 * width - 1.5, &value.symbol, from_left(size));
    let exceeded = value.value.is_some_and(|v| value.limits.exceeded_by(v));
    let figure = number(value.value, value.decimals);
    draw_judged(book, [at(0.43), y], 0.18 * width, &figure, exceeded, from_right(size));
    book.fitted([at(0.43) + 0.7, y], 0.09 * width, value.unit, from_left(size));
    let limit = limit_words(&value.limits, value.decimals);
    if !limit.is_empty() {
        book.fitted([at(0.78), y], 0.24 * width, &format!("{limit} {}", value.unit), from_right(size));
    }
    book.fitted([at(1.0) - 0.8, y], 0.2 * width, &value.class, from_right(size));
}

fn warnings(book: &mut Book, warnings: &[String], top: f64, bottom: f64) {
    let [left, width] = COLUMNS[2];
    let left = MARGIN + left;
    if warnings.is_empty() {
        book.text([left + 1.0, top + 8.0], "none", from_left(TEXT));
        return;
    }
    let most = ((bottom - top - HEADING - 0.4) / FINE).floor() as usize;
    let lines: Vec<Vec<String>> = warnings.iter().map(|text| wrapped(text, LABEL, width - 4.0)).collect();
    let all: usize = lines.iter().map(Vec::len).sum();
    // One line stays for the note that there are more.
    let room = if all <= most { most } else { most - 1 };
    let mut used = 0;
    let mut more = 0;
    for (text, lines) in warnings.iter().zip(&lines) {
        if used + lines.len() > room {
            let whole = format!("{}: {text}", book.say("Warning"));
            book.remark(whole);
            more += 1;
            continue;
        }
        for (k, line) in lines.iter().enumerate() {
            let y = top + HEADING + FINE * ((used + k) as f64 + 0.75);
            if k == 0 {
                book.text([left + 1.0, y], "·", from_left(LABEL).bold());
            }
            book.page().text([left + 2.2, y], line, from_left(LABEL).verbatim());
        }
        used += lines.len();
    }
    if more > 0 {
        let y = top + HEADING + FINE * (most as f64 - 0.25);
        let text = format!("further ones among the remarks on the last page: {more}");
        book.fitted([left + 2.2, y], width - 4.0, &text, from_left(LABEL).bold());
    }
}
