//! Block `density`: the smallest grids within limits.

use super::super::given::{check_block, check_items, check_object, requires, tolerance};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::case::MilledCase;
use super::columns::distances;
use milling::{DensityLimits, DistanceLimits, RowSpacing, dense_grid};
use serde_json::Value;

/// Block `density`.
pub(crate) fn density(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("density", block, ledger, |expected, ledger| {
        requires(expected, "law", &["equal arc in the column, equal steps of u"], ledger)?;
        let mm = tolerance(expected, "tolerance_mm", ledger);
        check_items(expected, "items", ledger, |item, ledger| {
            let case = MilledCase::given(reference, item, ledger)?;
            let mut limits = DensityLimits::default();
            let thresholds = item.object("thresholds", ledger).ok_or("thresholds are missing")?;
            check_object(thresholds, ledger, |given, ledger| {
                for (line, limits) in [("row", &mut limits.row), ("column", &mut limits.column)] {
                    let mut limit = |name: &str| given.given_optional(&format!("{line}_{name}_mm"), ledger);
                    *limits = DistanceLimits {
                        greatest: limit("max"),
                        least: limit("min"),
                        greatest_mean: limit("max_mean"),
                        least_mean: limit("min_mean"),
                    };
                }
                Ok(())
            });
            let dense = dense_grid(&case.flank, &*case.lead, case.range()?, RowSpacing::Arc, &limits)?;
            item.whole("columns", dense.grid.columns.len() as i64, ledger);
            item.whole("rows", dense.grid.rows() as i64, ledger);
            let violated: Vec<&str> = dense.violated.iter().map(|violated| violated.name).collect();
            if let Some(expected) = item.take("violated") {
                ledger.equal(item.case(), &item.name("violated"), expected.clone(), violated.into());
            }
            if let Some(mut measured) = item.object("measured", ledger) {
                distances(&mut measured, [dense.along_rows, dense.along_columns], mm, ledger);
                measured.finish(ledger);
            }
            Ok(())
        })
    });
}
