//! A row of traces: the field of the left flank, the middle column, the field of the right flank, their tables below.

use super::book::{Book, LABEL, MARGIN, TEXT, THIN, WIDTH, centred, from_left, from_right};
use super::flank_field::draw_field;
use super::flank_place::FlankPlace;
use super::laid_row::{DIAGRAM, FIELD, LaidRow, PLOT, PlacedRow, TABLE};
use super::lanes::MOST;
use super::middle_column;
use super::ordinate::Ordinate;
use super::text_fit::wrapped;
use super::value_table::draw_table;
use foundation::geometry::Flank;

impl LaidRow<'_> {
    /// Draws one of its parts with its top at y.
    pub fn draw(&self, book: &mut Book, part: usize, top: f64) {
        let lanes = self.lanes.chunks(MOST).nth(part).unwrap_or_default();
        let ordinate = Ordinate::of(self.row, top + 0.5 * (PLOT[0] + PLOT[1]), PLOT[1] - PLOT[0]);
        let placed = PlacedRow { laid: self, lanes, top, ordinate };
        let measured = Flank::BOTH.map(|flank| lanes.iter().any(|lane| lane.traces[flank].is_some()));
        for flank in Flank::BOTH {
            let place = FlankPlace::of(flank);
            let left = place.left();
            book.page().rect([left, top], [FIELD, DIAGRAM], "none", Some(THIN));
            self.title(book, &place, part, top);
            if measured[flank as usize] {
                draw_field(book, &placed, &place);
                draw_table(book, &placed, &place, [left, top + DIAGRAM]);
            } else {
                let at = [left + 0.5 * FIELD, top + 0.5 * DIAGRAM];
                book.text(at, "not measured", centred(TEXT));
            }
        }
        if measured.contains(&true) {
            middle_column::draw(book, &placed);
            self.slopes(book, top + DIAGRAM);
        }
    }

    fn title(&self, book: &mut Book, place: &FlankPlace, part: usize, top: f64) {
        let parts = self.parts();
        let share = if parts > 1 { format!(" ({} of {parts})", part + 1) } else { String::new() };
        let text = format!("{}, {} flank{share}", self.row.name, place.flank);
        let y = top + 3.4;
        let style = if place.flank == Flank::Left { from_right(TEXT) } else { from_left(TEXT) };
        book.fitted([place.outward(1.5), y], 0.72 * FIELD, &text, style.bold());
        place.material(book, y);
    }

    /// How slopes are counted, in the middle between the tables.
    fn slopes(&self, book: &mut Book, top: f64) {
        let left = MARGIN + FIELD;
        let width = WIDTH - 2.0 * FIELD;
        let mut size = LABEL;
        let mut lines = wrapped(&self.row.slope_words, size, width - 1.0);
        // Smaller until all of it fits.
        while lines.len() as f64 * 1.2 * size > TABLE - 1.5 && size > 0.4 {
            size *= 0.9;
            lines = wrapped(&self.row.slope_words, size, width - 1.0);
        }
        for (k, line) in lines.iter().enumerate() {
            let y = top + 1.4 + 1.2 * size * (k as f64 + 0.7);
            book.page().text([left + 0.5 * width, y], line, centred(size));
        }
    }
}
