//! Block `spur_exact_stock`: what rows leave between them on a spur flank, in closed form in the file, by rays here.

use super::super::given::{Checked, check_block, list, tolerance};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::case::{MilledCase, located};
use super::referee::{left_um, rays};
use foundation::geometry::Cutter;
use milling::{Column, ColumnPlane};
use referee::{CutterPlace, MillPath};
use serde_json::Value;

/// Block `spur_exact_stock`.
pub(crate) fn spur_exact_stock(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("spur_exact_stock", block, ledger, |expected, ledger| {
        let case = MilledCase::given(reference, expected, ledger)?;
        let um = tolerance(expected, "tolerance_um", ledger);
        let (rows, at) = (list(expected, "rows_w_mm", ledger)?, list(expected, "w_mm", ledger)?);
        let stock = stock_um(&case, &case.cutter, &rows, &at)?;
        expected.list("stock_um", &stock, um, ledger);
        Ok(())
    });
}

/// What rows at these heights leave in the middle of the face, um. The rows run straight along a spur gear, so that one block is
/// each of them.
pub(super) fn stock_um(case: &MilledCase, cutter: &Cutter, rows: &[f64], at: &[f64]) -> Checked<Vec<f64>> {
    let [from, to] = case.range()?;
    let columns = [from, to].map(|u| {
        let plane = ColumnPlane::new(&case.flank, case.lead.at(u)?);
        Column::at_heights(&case.flank, &plane, rows)
    });
    let columns = columns.into_iter().collect::<Result<Vec<_>, _>>()?;
    let mut paths = Vec::with_capacity(rows.len());
    for row in 0..rows.len() {
        let mut places = Vec::with_capacity(columns.len());
        for column in &columns {
            let at = located(&column.places[row], &column.lead, cutter, case.contact_height, 0.0)?;
            places.push(CutterPlace { tip: at.tip, axis: at.axis });
        }
        paths.push(MillPath { cutter: 0, places });
    }
    let middle = 0.5 * (case.flank.face[0] + case.flank.face[1]);
    left_um(cutter, &paths, &rays(case, at, &[middle]))
}
