//! Pages with everything that found no room where it belongs, in full.

use super::book::{BOTTOM, Book, LABEL, MARGIN, TEXT, WIDTH, from_left};
use super::data::SheetData;
use super::text_fit::wrapped;
use super::{foot, head};

const PITCH: f64 = 2.9;
const TOP: f64 = MARGIN + head::HEIGHT + 8.0;

/// Adds the pages; none without remarks.
pub(super) fn draw(book: &mut Book, sheet: &SheetData) {
    if book.remarks().is_empty() {
        return;
    }
    let mut y = f64::INFINITY;
    let mut written = 0;
    // The head of these pages may shorten a text for the first time.
    while written < book.remarks().len() {
        let text = book.remarks()[written].clone();
        written += 1;
        let mark = format!("[R{written}]");
        for (k, line) in wrapped(&text, LABEL, WIDTH - 14.0).iter().enumerate() {
            if y + PITCH > BOTTOM - foot::LINE {
                y = begin(book, sheet);
            }
            if k == 0 {
                book.text([MARGIN + 1.0, y], &mark, from_left(LABEL).bold());
            }
            book.page().text([MARGIN + 12.0, y], line, from_left(LABEL).verbatim());
            y += PITCH;
        }
        y += 0.8;
    }
}

/// A page of remarks; returns where its first line stands.
fn begin(book: &mut Book, sheet: &SheetData) -> f64 {
    book.turn("remarks");
    head::draw(book, sheet, "remarks");
    book.text([MARGIN, TOP - 3.2], "Remarks", from_left(TEXT).bold());
    TOP + 1.5
}
