//! Load along the edge of a flank's plan, and what it would be if all rows touched at one height.

use super::prepare::MillingBodies;
use crate::{FlankPlan, RowLoad, WearHistogram};
use foundation::geometry::CutterShape;

/// Bin of the histogram, mm (`docs/mathematics/milling.md#cutter-location`): of a straight side, and of the arc on which rows that lean
/// differently touch.
const BIN: f64 = 0.5;
const BIN_OF_ARC: f64 = 0.1;

/// Histograms of the heights of the plan and of the height of its first row for all; none for cutters whose contact is not chosen, by
/// height or by the lean of rows.
pub(crate) fn histograms(bodies: &MillingBodies, plan: &FlankPlan) -> Option<[WearHistogram; 2]> {
    let cutter = &bodies.options.cutter;
    let leaning = bodies.options.tilt_at_tip.is_some();
    plan.rows.first().filter(|row| leaning || row.window.is_some())?;
    if !leaning && !matches!(cutter.shape(), CutterShape::Conical { .. }) {
        return None;
    }
    // Where the contact follows from the axis it moves a little from column to column.
    let height = |row: usize| {
        let row = &plan.rows[row];
        if !leaning {
            return row.contact_height;
        }
        row.locations.iter().map(|at| at.contact_height).sum::<f64>() / row.locations.len() as f64
    };
    let band = plan.lines.dense.along_columns.greatest_mean;
    let columns = &plan.lines.dense.grid.columns;
    let length = |row: usize| {
        columns
            .windows(2)
            .map(|pair| (pair[1].places[row].jet.point - pair[0].places[row].jet.point).norm())
            .sum::<f64>()
    };
    let bin = if leaning { BIN_OF_ARC } else { BIN };
    let histogram = |height: &dyn Fn(usize) -> f64| {
        let rows: Vec<RowLoad> = (0..plan.rows.len())
            .map(|row| RowLoad { height: height(row), band, length: length(row) })
            .collect();
        WearHistogram::new(&rows, cutter.cutting_length(), bin)
    };
    Some([histogram(&height), histogram(&|_| height(0))])
}
