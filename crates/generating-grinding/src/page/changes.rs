//! Changes of the job that were planned because its flank is missed.

use crate::workflow::ChangeResult;
use report::cells::NONE;
use report::charts::format_fixed;
use report::{Block, Column, Table};

/// The section; empty where nothing was tried.
pub(super) fn changes(tried: &[ChangeResult]) -> Vec<Block> {
    if tried.is_empty() {
        return Vec::new();
    }
    let row = |change: &ChangeResult| {
        vec![
            change.keys(),
            change.cost.to_owned(),
            change.status.map_or("no plan found", |status| status.words()).to_owned(),
            change.deviation_um.map_or(NONE.to_owned(), |um| format_fixed(um, 3)),
        ]
    };
    let table = Table {
        caption: "Changes of the job, planned and simulated one after the other until one meets the target".to_owned(),
        columns: vec![
            Column::text("Change"),
            Column::text("What it costs"),
            Column::text("Verdict"),
            Column::number("Deviation", "µm"),
        ],
        rows: tried.iter().map(row).collect(),
        note: "The flank is judged; programs, stock and control are not made for the changes. Two values of one key are two jobs.".into(),
    };
    vec![Block::Table(table)]
}
