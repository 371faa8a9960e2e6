//! The pages of a sheet in their order: traces, pitch and foot on the first, further rows, topographies, remarks.

use super::book::{BOTTOM, Book, LABEL, MARGIN, WIDTH, from_left, from_right};
use super::check::check;
use super::data::SheetData;
use super::laid_row::{self, LaidRow};
use super::{foot, head, pitch_row, remarks, topography};
use report::charts::{ChartError, Svg};

/// Distance of the blocks.
const GAP: f64 = 2.0;
/// Rows of traces on a page without pitch and foot.
const ROWS: usize = 3;

/// A page: A4 upright, 210 x 297 mm with its margins.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SheetPage {
    /// What stands on it.
    pub name: String,
    /// The page, its unit the millimetre.
    pub svg: Svg,
}

/// Draws the pages of a sheet. The same data give the same bytes.
///
/// # Errors
/// [`ChartError`] for infinite numbers, lists of different length, places that do not ascend; the error names the trace.
pub fn sheet_pages(sheet: &SheetData) -> Result<Vec<SheetPage>, ChartError> {
    check(sheet)?;
    let sheet = &sheet.said();
    let mut book = Book::new(&sheet.title, sheet.language);
    let first = [LaidRow::new(&sheet.profiles), LaidRow::new(&sheet.helices)];
    first_page(&mut book, sheet, &first);
    let more: Vec<LaidRow> = sheet.further.iter().map(LaidRow::new).collect();
    let rest = first.iter().flat_map(|row| (1..row.parts()).map(move |part| (row, part)));
    let further = more.iter().flat_map(|row| (0..row.parts()).map(move |part| (row, part)));
    let rows: Vec<(&LaidRow, usize)> = rest.chain(further).collect();
    for rows in rows.chunks(ROWS) {
        book.turn("further traces");
        head::draw(&mut book, sheet, "further traces");
        for (k, (row, part)) in rows.iter().enumerate() {
            row.draw(&mut book, *part, below_head() + k as f64 * (laid_row::HEIGHT + GAP));
        }
    }
    topography::draw(&mut book, sheet);
    remarks::draw(&mut book, sheet);
    Ok(finished(book, sheet))
}

fn below_head() -> f64 {
    MARGIN + head::HEIGHT + GAP
}

fn first_page(book: &mut Book, sheet: &SheetData, rows: &[LaidRow; 2]) {
    book.turn("traces and pitch");
    head::draw(book, sheet, "");
    let mut top = below_head();
    for row in rows {
        row.draw(book, 0, top);
        top += laid_row::HEIGHT + GAP;
    }
    pitch_row::draw(book, &sheet.pitch, top);
    foot::draw(book, &sheet.foot, top + pitch_row::HEIGHT + GAP);
}

/// Page numbers and what made the sheet.
fn finished(book: Book, sheet: &SheetData) -> Vec<SheetPage> {
    let pages = book.into_pages();
    let count = pages.len();
    let numbered = pages.into_iter().enumerate().map(|(k, (name, mut canvas))| {
        let text = format!("page {} of {count}", k + 1);
        canvas.text([MARGIN + WIDTH, BOTTOM], &sheet.language.say(&text), from_right(LABEL));
        canvas.text([MARGIN, BOTTOM], &sheet.product, from_left(LABEL).muted().verbatim());
        SheetPage { name, svg: canvas.finish() }
    });
    numbered.collect()
}
