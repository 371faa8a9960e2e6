//! Block `internal_cylinder`: a straight cutter on a hollow profile, the wrong tool.

use super::super::given::{MOST, check_block, count, number, tolerance};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::case::{MilledCase, located};
use super::cutter::end_mill;
use super::referee::{extremes, left_um, rays, row_paths};
use foundation::numerics::equidistant;
use milling::{Column, ColumnPlane, FlankGrid, LocalContact, RowSpacing};
use serde_json::Value;

/// Rays across the flank; its ends, where the gouge is deepest, are among them.
const ACROSS: usize = 161;

/// Block `internal_cylinder`.
pub(crate) fn internal_cylinder(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("internal_cylinder", block, ledger, |expected, ledger| {
        let case = MilledCase::given(reference, expected, ledger)?;
        let cutter = end_mill(expected, ledger)?;
        let height = number(expected, "h_mm", ledger)?;
        let rows = count(expected, "rows", 2..=MOST)?;
        let um = tolerance(expected, "tolerance_um", ledger);
        let at = case.lead_parameters(9)?;
        let grid = FlankGrid::build(&case.flank, &*case.lead, &at, rows, RowSpacing::Arc)?;
        let paths = row_paths(&grid, &cutter, |_| height, 0.0)?;
        let middle = 0.5 * (case.flank.face[0] + case.flank.face[1]);
        let left = left_um(&cutter, &paths, &rays(&case, &equidistant(case.heights(), ACROSS), &[middle]))?;
        expected.number("min_stock_um", extremes(&left)[0], um, ledger);
        // In the middle of the height.
        let plane = ColumnPlane::new(&case.flank, case.lead.at(at[at.len() / 2])?);
        let column = Column::at_heights(&case.flank, &plane, &[case.height_at(0.5)])?;
        let place = &column.places[0];
        let location = located(place, &column.lead, &cutter, height, 0.0)?;
        let local = LocalContact::new(&place.jet, &location, cutter.shape());
        let per_mm = 1e-3 * um;
        expected.number("gouge_eig_per_mm", local.least_opening(), per_mm, ledger);
        Ok(())
    });
}
