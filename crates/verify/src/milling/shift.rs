//! Block `shift_invariance`: contact heights that differ from row to row leave the flank what it is.

use super::super::given::{
    MOST, check_block, check_items, check_object, count, list, requires, text, tolerance,
};
use super::super::ledger::Ledger;
use super::super::reference::{Reference, read};
use super::case::MilledCase;
use super::columns::row_law;
use super::cutter::Tool;
use super::referee::{extremes, left_um, rays, row_paths};
use foundation::numerics::equidistant;
use milling::FlankGrid;
use serde_json::Value;

/// Heights of the rays.
const HEIGHTS: usize = 61;

/// Block `shift_invariance`.
pub(crate) fn shift_invariance(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("shift_invariance", block, ledger, |expected, ledger| {
        let name = text(expected, "case", ledger)?;
        let um = tolerance(expected, "tolerance_um", ledger);
        check_items(expected, "items", ledger, |item, ledger| {
            let mut case = MilledCase::named(reference, name)?;
            let tool = item.take("tool").unwrap_or(&Value::Null);
            let tool: Tool = read(item.case(), tool, ledger).ok_or("the cutter cannot be read")?;
            case.cutter = tool.cutter()?;
            let rows = count(item, "rows", 2..=MOST)?;
            let heights = [
                list(item, "contact_height_fixed_mm", ledger)?,
                list(item, "contact_height_shifted_mm", ledger)?,
            ];
            if heights.iter().any(|heights| heights.len() != rows) {
                return Err("a contact height for every row is needed here".into());
            }
            let at = list(item, "u_mm", ledger)?;
            let law = row_law(text(item, "row_law", ledger)?)?;
            let Some(mut object) = item.object("rays", ledger) else { return Err("rays are missing".into()) };
            requires(&mut object, "a", &["61 equal steps of the parameter, root..tip"], ledger)?;
            requires(&mut object, "order", &["a slow"], ledger)?;
            let lengths = list(&mut object, "b_mm", ledger)?;
            check_object(object, ledger, |_, _| Ok(()));
            let grid = FlankGrid::build(&case.flank, &*case.lead, &at, rows, law)?;
            let rays = rays(&case, &equidistant(case.heights(), HEIGHTS), &lengths);
            let left = |heights: &[f64]| {
                let paths = row_paths(&grid, &case.cutter, |row| heights[row], 0.0)?;
                left_um(&case.cutter, &paths, &rays)
            };
            let (fixed, shifted) = (left(&heights[0])?, left(&heights[1])?);
            let change = fixed.iter().zip(&shifted).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            let figures = [
                ("max_stock_fixed_um", extremes(&fixed)[1]),
                ("max_stock_shifted_um", extremes(&shifted)[1]),
                ("largest_change_um", change),
            ];
            item.numbers(&figures, um, ledger);
            Ok(())
        })
    });
}
