//! The head of every page: what was measured, the data of the gear, how it was measured and judged.

use super::book::{Book, LABEL, MARGIN, TEXT, THIN, WIDTH, from_left, from_right};
use super::data::SheetData;
use report::charts::text_width;
use report::data::Fact;

/// Height of the head.
pub(super) const HEIGHT: f64 = 28.0;
/// Left ends and widths of the columns, from the left border.
const COLUMNS: [[f64; 2]; 3] = [[1.5, 64.0], [67.0, 40.0], [109.0, 80.0]];
/// Room of the title.
const TITLE: f64 = 5.2;
/// Most lines of a column.
const MOST: usize = 10;
const PITCH: f64 = 3.15;

/// Draws the head with the name of the page.
pub(super) fn draw(book: &mut Book, sheet: &SheetData, page: &str) {
    let top = MARGIN;
    book.page().rect([MARGIN, top], [WIDTH, HEIGHT], "none", Some(THIN));
    book.page().line([MARGIN, top + TITLE], [MARGIN + WIDTH, top + TITLE], THIN);
    let y = top + 3.8;
    book.text([MARGIN + 1.5, y], "Inspection sheet", from_left(3.2).bold());
    let name = [MARGIN + 30.0, y];
    book.words(name, 120.0, ["Part", &sheet.title], from_left(3.2).bold());
    book.fitted([MARGIN + WIDTH - 1.5, y], 36.0, page, from_right(TEXT));
    for (facts, column) in [&sheet.head.part, &sheet.head.gear, &sheet.head.conditions].iter().zip(COLUMNS) {
        draw_column(book, facts, column, top + TITLE);
    }
}

fn draw_column(book: &mut Book, facts: &[Fact], [left, width]: [f64; 2], top: f64) {
    let shown = facts.len().min(MOST);
    let room = HEIGHT - TITLE - 0.6;
    let pitch = PITCH.min(room / shown.max(1) as f64);
    let size = TEXT.min(0.8 * pitch);
    let label_size = LABEL.min(size);
    let widest = facts.iter().map(|fact| text_width(&book.say(&fact.label), label_size)).fold(0.0, f64::max);
    let beside = (widest + 1.5).min(0.45 * width);
    for (k, fact) in facts.iter().enumerate() {
        if k >= MOST {
            let whole = format!("{}: {}", book.say(&fact.label), fact.text);
            book.remark(whole);
            continue;
        }
        let y = top + pitch * (k as f64 + 0.85);
        let x = MARGIN + left;
        book.fitted([x, y], beside - 0.8, &fact.label, from_left(label_size).muted());
        book.words([x + beside, y], width - beside, [&fact.label, &fact.text], from_left(size));
    }
}
