//! Where the field of a flank lies on the sheet.

use super::book::{Book, LABEL, MARGIN, TRACE, WIDTH, from_left, from_right};
use super::laid_row::FIELD;
use foundation::geometry::Flank;

/// Where the field of a flank lies.
#[derive(Clone, Copy, Debug)]
pub(super) struct FlankPlace {
    /// The flank.
    pub flank: Flank,
    /// x of the border to the middle column.
    inner: f64,
    /// Outwards on the page.
    outwards: f64,
}

impl FlankPlace {
    /// Left of the middle column the left flank, right of it the right one.
    pub fn of(flank: Flank) -> Self {
        match flank {
            Flank::Left => Self { flank, inner: MARGIN + FIELD, outwards: -1.0 },
            Flank::Right => Self { flank, inner: MARGIN + WIDTH - FIELD, outwards: 1.0 },
        }
    }

    /// x at a distance from the middle column.
    pub fn outward(&self, distance: f64) -> f64 {
        self.inner + self.outwards * distance
    }

    /// Left border.
    pub fn left(&self) -> f64 {
        self.outward(0.0).min(self.outward(FIELD))
    }

    /// An arrow to the side where material stands.
    pub fn material(&self, book: &mut Book, y: f64) {
        let [tip, tail] = [1.2, 5.0].map(|d| self.outward(FIELD - d));
        let barb = self.outward(FIELD - 2.6);
        let y = y - 0.8;
        book.page().line([tail, y], [tip, y], TRACE);
        book.page().polylines(&[vec![[barb, y - 0.7], [tip, y], [barb, y + 0.7]]], TRACE);
        let style = if self.flank == Flank::Left { from_left(LABEL) } else { from_right(LABEL) };
        book.text([self.outward(FIELD - 5.8), y + 0.8], "material", style.muted());
    }
}
