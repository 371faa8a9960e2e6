//! Load along the edge of a flank's plan, and what it would be if all rows touched at one height.

use super::prepare::MillingBodies;
use crate::{FlankPlan, RowLoad, WearHistogram};
use foundation::geometry::CutterShape;

/// Bin of the histogram, mm (`docs/mathematics/milling.md#cutter-location`).
const BIN: f64 = 0.5;

/// Histograms of the heights of the plan and of the height of its first row for all; none for cutters whose contact is not chosen.
pub(crate) fn histograms(bodies: &MillingBodies, plan: &FlankPlan) -> Option<[WearHistogram; 2]> {
    let cutter = &bodies.options.cutter;
    let first = plan.rows.first().filter(|row| row.window.is_some())?;
    if !matches!(cutter.shape(), CutterShape::Conical { .. }) {
        return None;
    }
    let band = plan.lines.dense.along_columns.greatest_mean;
    let columns = &plan.lines.dense.grid.columns;
    let length = |row: usize| {
        columns
            .windows(2)
            .map(|pair| (pair[1].places[row].jet.point - pair[0].places[row].jet.point).norm())
            .sum::<f64>()
    };
    let histogram = |height: &dyn Fn(usize) -> f64| {
        let rows: Vec<RowLoad> = (0..plan.rows.len())
            .map(|row| RowLoad { height: height(row), band, length: length(row) })
            .collect();
        WearHistogram::new(&rows, cutter.cutting_length(), BIN)
    };
    Some([histogram(&|row| plan.rows[row].contact_height), histogram(&|_| first.contact_height)])
}
