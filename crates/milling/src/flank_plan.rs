//! The plan of one flank: its rows and columns, the cutter at all of them, how far the rows go and what they leave.

use super::finish::FinishedRow;
use super::lines::LaidLines;
use super::milled_side::MilledSide;
use super::root_pass::RootSection;
use super::row_paths::RowEnd;
use super::{
    ActiveFlank, CutterLocation, FlankGrid, LeadCurve, LocalContact, MillingError, PlanOptions,
    plane_through, row_distance,
};
use std::sync::Arc;

/// What a row leaves, by curvatures at its middle column. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowFigures {
    /// Scallop to the next row towards the tip; none above the last row.
    pub scallop: Option<f64>,
    /// Error of the straight blocks.
    pub chord: f64,
    /// Greatest angle of the normals out of their column planes, rad.
    pub out_of_plane: f64,
    /// Greatest angle of the axis out of its column plane, rad; 0 without a lead angle.
    pub axis_off: f64,
    /// Least curvature of the gap between cutter and flank, 1/mm.
    pub opening: f64,
}

/// The plan of one flank.
#[derive(Clone, Debug)]
pub struct FlankPlan {
    /// Which.
    pub side: MilledSide,
    /// The flank, as if it went on beyond the middle of a double-helical gear.
    pub active: ActiveFlank,
    /// The guide curve of its space.
    pub lead: Arc<dyn LeadCurve>,
    /// Its rows and columns.
    pub lines: LaidLines,
    /// The cutter at all points of the path's grid.
    pub rows: Vec<FinishedRow>,
    /// Where rows end short of the face because of the other half, row by row.
    pub ends: Vec<Option<RowEnd>>,
    /// What the rows leave.
    pub figures: Vec<RowFigures>,
    /// The root below the flank, column by column of the path.
    pub root: Vec<(RootSection, CutterLocation)>,
}

impl FlankPlan {
    /// What a row leaves of the face because of the other half, mm; 0 of a row that does not end short of it.
    pub fn unmilled_length(&self, row: usize) -> f64 {
        let short = |end: &RowEnd| {
            let [least, greatest] = self.active.face;
            (end.length - least).min(greatest - end.length)
        };
        self.ends.get(row).and_then(Option::as_ref).map_or(0.0, short)
    }

    /// Whether the rows beside a place of the flank come by there; they do unless the other half is in the way.
    ///
    /// # Errors
    /// [`MillingError::RangeNotFound`] where no column plane holds the place.
    pub fn reaches(&self, height: f64, length: f64) -> Result<bool, MillingError> {
        if self.ends.iter().all(Option::is_none) {
            return Ok(true);
        }
        let u = plane_through(&self.active, &*self.lead, height, length)?;
        let columns = &self.lines.path.columns;
        let column = &columns[columns.partition_point(|column| column.lead.u < u).min(columns.len() - 1)];
        let [root, tip] = self.active.height_span();
        let sense = (tip - root).signum();
        let above = column.places.partition_point(|place| sense * (place.height - height) < 0.0);
        let beside = [above.saturating_sub(1), above.min(self.rows.len() - 1)];
        let comes_by = |row: usize| match self.ends[row] {
            Some(end) => (end.u < u) == self.side.half.is_some_and(|half| half.sign() > 0.0),
            None => true,
        };
        Ok(beside.into_iter().all(comes_by))
    }
}

/// What the rows leave at the middle column.
pub(super) fn figures(grid: &FlankGrid, rows: &[FinishedRow], options: &PlanOptions) -> Vec<RowFigures> {
    let middle = grid.columns.len() / 2;
    let neighbour = if middle + 1 < grid.columns.len() { middle + 1 } else { middle - 1 };
    let place = |row: usize, column: usize| &grid.columns[column].places[row];
    let of_row = |(row, finished): (usize, &FinishedRow)| {
        let here = place(row, middle);
        let local = LocalContact::new(&here.jet, &finished.locations[middle], options.cutter.shape());
        let block = (place(row, neighbour).jet.point - here.jet.point).norm();
        let feed = &here.jet.by_length;
        let scallop = (row + 1 < rows.len()).then(|| {
            let between = place(row + 1, middle).jet.point - here.jet.point;
            local.scallop(feed, row_distance(feed, &between))
        });
        let greatest = |value: &dyn Fn(usize) -> f64| {
            (0..grid.columns.len()).map(|column| value(column).abs()).fold(0.0, f64::max)
        };
        RowFigures {
            scallop,
            chord: local.chord(feed, block),
            out_of_plane: greatest(&|column| place(row, column).out_of_plane),
            axis_off: greatest(&|column| finished.locations[column].out_of_plane),
            opening: local.least_opening(),
        }
    };
    rows.iter().enumerate().map(of_row).collect()
}
