//! What stands on the flanks before they are finished.

use crate::workflow::MillingResult;
use report::charts::format_fixed;
use report::{Block, Column, Table};

/// A row for each flank; nothing where the stock is not known.
pub(super) fn blocks(result: &MillingResult) -> Vec<Block> {
    if result.stock.is_empty() {
        return Vec::new();
    }
    let rows = result.stock.iter().map(|(name, stock)| {
        let [least, greatest] = stock.before_mm;
        vec![(*name).to_owned(), format_fixed(least, 4), format_fixed(greatest, 4), stock.uncut.to_string()]
    });
    vec![Block::Table(Table {
        caption: String::new(),
        columns: vec![
            Column::text("Flank"),
            Column::number("Least stock", "mm"),
            Column::number("Greatest stock", "mm"),
            Column::number("Rays that nothing has cut", ""),
        ],
        rows: rows.collect(),
        note: "Normal to the wanted flank: what roughing leaves, found by the referee, or the allowance of a part that is cut already with what its clocking angle may be off. The greatest stock is what a finishing row engages at most."
            .into(),
    })]
}
