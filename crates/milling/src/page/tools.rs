//! The tools of the machine's store, and what the control has to hold.

use super::cutter_words::cutter_words;
use crate::workflow::{MillingResult, ToolResult, WorkOffsetResult};
use report::charts::{format_fixed, format_significant};
use report::{Block, Column, Quantity, Table};

/// Tools, and the work offset where the job has one.
pub(super) fn blocks(result: &MillingResult) -> Vec<Block> {
    let mut blocks = vec![Block::Table(table(&result.tools))];
    blocks.extend(result.work_offset.as_ref().map(|offset| Block::Table(work_offset(offset))));
    blocks
}

fn table(tools: &[ToolResult]) -> Table {
    let row = |tool: &ToolResult| {
        vec![
            format!("T{}", tool.number),
            cutter_words(&tool.cutter),
            tool.length_mm.map_or_else(String::new, |length| format_significant(length, 7)),
            format!("H{} / D{}", tool.length_offset.h, tool.length_offset.d),
            format_fixed(tool.spindle_rpm, 0),
            format_significant(tool.feed_mm_per_min, 5),
            format_significant(tool.plunge_feed_mm_per_min, 5),
            tool.coolant.to_owned(),
        ]
    };
    Table {
        caption: String::new(),
        columns: vec![
            Column::text("Tool"),
            Column::text("Cutter"),
            Column::number("Length", "mm"),
            Column::text("Number of its length"),
            Column::number("Spindle speed", "1/min"),
            Column::number("Feed", "mm/min"),
            Column::number("Plunge feed", "mm/min"),
            Column::text("Coolant"),
        ],
        rows: tools.iter().map(row).collect(),
        note: "The length is that from the nose of the spindle to the tip; its number is H on LinuxCNC and Fanuc, D on Siemens.".into(),
    }
}

fn work_offset(offset: &WorkOffsetResult) -> Table {
    let mut list = vec![Quantity::count("number of the work offset, 1 is G54", "", i64::from(offset.number))];
    for (name, value) in ["X", "Y", "Z"].into_iter().zip(offset.position_mm) {
        list.push(Quantity::rounded("value of the axis", name, value, 4, "mm"));
    }
    if let Some(held) = &offset.clocking {
        list.push(Quantity::rounded(
            "clocking angle, value of the axis",
            &held.axis,
            held.value_deg,
            5,
            "deg",
        ));
    }
    Table::of_quantities("What the control has to hold", &list)
}
