//! How a row of traces is laid: its heights and widths, its lanes, its magnification.

use super::lanes::{Lane, MOST, lanes};
use super::ordinate::Ordinate;
use super::reach::reach;
use super::traces_data::TraceRow;
use report::charts::magnification::{drawn, of_traces};

/// Height of the diagram and of the table below it.
pub(super) const DIAGRAM: f64 = 56.0;
pub(super) const TABLE: f64 = 22.0;
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
    pub lanes: Vec<Lane<'a>>,
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
}

impl PlacedRow<'_, '_> {
    /// Length of a deviation on paper, mm.
    pub fn drawn(&self, um: f64) -> f64 {
        drawn(um, self.laid.magnification)
    }
}
