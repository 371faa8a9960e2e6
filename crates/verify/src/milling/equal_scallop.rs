//! Block `equal_scallop`: rows that leave the same height between them.

use super::super::given::{Checked, MOST, check_block, number, tolerance};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::case::{MilledCase, located};
use super::referee::extremes;
use super::spur_stock::stock_um;
use foundation::numerics::equidistant;
use milling::{ColumnPlane, GridPlace, LocalContact, MillingError, RowSpacing, Section, row_heights};
use serde_json::Value;

/// Rays between two rows: as many as the file's figures have, a scallop between two of them is not seen (0.02 um).
const RAYS: usize = 401;

/// Block `equal_scallop`.
pub(crate) fn equal_scallop(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("equal_scallop", block, ledger, |expected, ledger| {
        let case = MilledCase::given(reference, expected, ledger)?;
        let limit = number(expected, "scallop_limit_um", ledger)?;
        let mm = tolerance(expected, "tolerance_mm", ledger);
        let um = tolerance(expected, "tolerance_um", ledger);
        let [from, to] = case.range()?;
        let plane = ColumnPlane::new(&case.flank, case.lead.at(0.5 * (from + to))?);
        let weight = |plane: &ColumnPlane, section: &Section| weight(&case, plane, section);
        let law = RowSpacing::Weighted(&weight);
        let (_, whole) = row_heights(&plane, 2, law)?;
        let rows = (whole / (8e-3 * limit).sqrt()).ceil() + 1.0;
        if !(2.0..=MOST as f64).contains(&rows) {
            return Err(format!("{rows} rows").into());
        }
        let (heights, _) = row_heights(&plane, rows as usize, law)?;
        expected.number("Lambda_sqrt_mm", whole, mm, ledger);
        expected.whole("rows", rows as i64, ledger);
        expected.list("w_mm", &heights, mm, ledger);
        expected.list("stock_max_um", &gaps_um(&case, &heights)?, um, ledger);
        let (_, arc) = row_heights(&plane, 2, RowSpacing::Arc)?;
        expected.number("column_arc_mm", arc, mm, ledger);
        let by_arc = rows_by_arc(&case, &plane, limit)?;
        expected.whole("rows_needed_with_equal_arc", by_arc as i64, ledger);
        Ok(())
    });
}

/// The root of the effective curvature of rows along the tooth.
fn weight(case: &MilledCase, plane: &ColumnPlane, section: &Section) -> Result<f64, MillingError> {
    let place = GridPlace {
        height: section.height,
        length: section.length,
        jet: section.jet,
        out_of_plane: 0.0,
        is_virtual: false,
    };
    let location = located(&place, plane.lead(), &case.cutter, case.contact_height, 0.0)?;
    let local = LocalContact::new(&section.jet, &location, case.cutter.shape());
    Ok(local.effective_curvature(&section.jet.by_length).max(0.0).sqrt())
}

/// The greatest stock in every gap between rows, um.
fn gaps_um(case: &MilledCase, heights: &[f64]) -> Checked<Vec<f64>> {
    let greatest = |pair: &[f64]| {
        let at = equidistant([pair[0], pair[1]], RAYS);
        Ok(extremes(&stock_um(case, &case.cutter, pair, &at)?)[1])
    };
    heights.windows(2).map(greatest).collect()
}

/// The fewest rows of equal arcs that keep a limit.
fn rows_by_arc(case: &MilledCase, plane: &ColumnPlane, limit: f64) -> Checked<usize> {
    for rows in 2..=MOST as usize {
        let (heights, _) = row_heights(plane, rows, RowSpacing::Arc)?;
        if gaps_um(case, &heights)?.iter().all(|&stock| stock <= limit) {
            return Ok(rows);
        }
    }
    Err("no number of rows keeps the limit".into())
}
