//! Block `full_flank`: rays over whole flanks.

use super::super::given::{MOST, check_block, check_items, check_object, count, counts, number, tolerance};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::case::MilledCase;
use super::referee::{extremes, left_um, rays, row_paths};
use foundation::numerics::equidistant;
use milling::{FlankGrid, RowSpacing};
use serde_json::Value;

/// Block `full_flank`.
pub(crate) fn full_flank(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("full_flank", block, ledger, |expected, ledger| {
        let um = tolerance(expected, "tolerance_um", ledger);
        check_items(expected, "items", ledger, |item, ledger| {
            let case = MilledCase::given(reference, item, ledger)?;
            let columns = count(item, "columns", 2..=MOST)?;
            let rows = count(item, "rows", 2..=MOST)?;
            let overrun = number(item, "overrun_u_mm", ledger)?;
            let height = number(item, "contact_height_mm", ledger)?;
            let [across, along] = counts(item, "rays_grid", 2..=MOST)?;
            let [from, to] = case.range()?;
            let at = equidistant([from - overrun, to + overrun], columns);
            let grid = FlankGrid::build(&case.flank, &*case.lead, &at, rows, RowSpacing::Arc)?;
            let paths = row_paths(&grid, &case.cutter, |_| height, 0.0)?;
            let rays =
                rays(&case, &equidistant(case.heights(), across), &equidistant(case.flank.face, along));
            let left = left_um(&case.cutter, &paths, &rays)?;
            let [least, greatest] = extremes(&left);
            let mean_square = left.iter().map(|x| x * x).sum::<f64>() / left.len() as f64;
            let Some(result) = item.object("result", ledger) else { return Ok(()) };
            check_object(result, ledger, |result, ledger| {
                let figures =
                    [("max_stock_um", greatest), ("min_stock_um", least), ("rms_um", mean_square.sqrt())];
                result.numbers(&figures, um, ledger);
                result.whole("rays", left.len() as i64, ledger);
                let blocks: usize = paths.iter().map(|path| path.places.len() - 1).sum();
                result.whole("blocks", blocks as i64, ledger);
                Ok(())
            });
            Ok(())
        })
    });
}
