//! The coordinate along traces on paper: linear, upwards or downwards, at a round magnification.

use super::traces_data::TraceRow;
use report::charts::magnification::largest;

/// Where places along the traces of a row lie.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ordinate {
    middle_mm: f64,
    /// mm on paper per mm, downwards on the page.
    downwards: f64,
    /// The page's y of the middle.
    centre: f64,
}

impl Ordinate {
    /// For all places of a row in a height about the page's y `centre`.
    pub fn of(row: &TraceRow, centre: f64, height: f64) -> Self {
        let places = row.flanks.iter().flat_map(|(_, field)| {
            let traces = field
                .traces
                .iter()
                .flat_map(|t| t.abscissa_mm.first().into_iter().chain(t.abscissa_mm.last()));
            traces.chain(field.lines.iter().map(|line| &line.at_mm))
        });
        let [lo, hi] = foundation::numerics::extremes(places.copied());
        if lo > hi {
            return Self { middle_mm: 0.0, downwards: 1.0, centre };
        }
        let magnification = largest(hi - lo, height);
        let downwards = if row.rising { -magnification } else { magnification };
        Self { middle_mm: 0.5 * (lo + hi), downwards, centre }
    }

    /// y on the page.
    pub fn y(&self, place: f64) -> f64 {
        self.centre + self.downwards * (place - self.middle_mm)
    }

    /// mm on paper per mm.
    pub fn magnification(&self) -> f64 {
        self.downwards.abs()
    }
}
