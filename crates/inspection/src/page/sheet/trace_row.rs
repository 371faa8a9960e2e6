//! A row of traces: the field of the left flank, the middle column, the field of the right flank, their tables below.

use super::book::{Book, LABEL, MARGIN, TEXT, THIN, WIDTH, centred, from_left};
use super::deviation_scale::{drawn, of_traces};
use super::flank_field::{FlankPlace, draw_field, reach};
use super::lanes::{Lane, MOST, lanes};
use super::middle_column;
use super::ordinate::Ordinate;
use super::text_fit::wrapped;
use super::traces_data::TraceRow;
use super::value_table::draw_table;
use foundation::geometry::Flank;

/// Height of the diagram and of the table below it.
pub(super) const DIAGRAM: f64 = 56.0;
const TABLE: f64 = 22.0;
/// Height of a row.
pub(super) const HEIGHT: f64 = DIAGRAM + TABLE;
/// Width of a field.
pub(super) const FIELD: f64 = 85.0;
/// Where traces are drawn, from the top of the row.
pub(super) const PLOT: [f64; 2] = [5.5, 48.5];
/// Room between a trace and the border of its lane.
const CLEAR: f64 = 0.3;

/// A row with what all its parts on the sheet have in common.
pub(super) struct LaidRow<'a> {
    /// The data.
    pub row: &'a TraceRow,
    /// All lanes.
    lanes: Vec<Lane<'a>>,
    /// Distance of the lanes, mm.
    pub pitch: f64,
    /// Magnification of the deviations.
    pub magnification: f64,
}

/// A part of a row that stands on a page: which of its lanes, and where.
pub(super) struct PlacedRow<'a, 'b> {
    /// The row.
    pub laid: &'b LaidRow<'a>,
    /// The lanes.
    pub lanes: &'b [Lane<'a>],
    /// y of its top.
    pub top: f64,
    /// Places along the traces.
    pub ordinate: Ordinate,
}

impl<'a> LaidRow<'a> {
    /// Chooses lanes and magnification.
    pub fn new(row: &'a TraceRow) -> Self {
        let lanes = lanes(row);
        let pitch = FIELD / (lanes.len().clamp(1, MOST) + 1) as f64;
        let traces = row.flanks.iter().flat_map(|(_, field)| &field.traces);
        let reach = traces.map(reach).fold(0.0, f64::max);
        Self { row, lanes, pitch, magnification: of_traces(reach, 0.5 * pitch - CLEAR) }
    }

    /// Rows of the sheet that it takes, at least one.
    pub fn parts(&self) -> usize {
        self.lanes.len().div_ceil(MOST).max(1)
    }

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
                book.page().text(at, "not measured", centred(TEXT));
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
        let style = if place.flank == Flank::Left { super::book::from_right(TEXT) } else { from_left(TEXT) };
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

impl PlacedRow<'_, '_> {
    /// Length of a deviation on paper, mm.
    pub fn drawn(&self, um: f64) -> f64 {
        drawn(um, self.laid.magnification)
    }
}
