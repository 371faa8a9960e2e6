//! Programs that find the clocking angle of a part whose teeth are cut already.

use crate::workflow::{ClockingResult, MillingResult};
use report::charts::format_fixed;
use report::{Block, Column, Table};

/// A row for each program; nothing without a probe.
pub(super) fn blocks(result: &MillingResult) -> Vec<Block> {
    if result.clocking_programs.is_empty() {
        return Vec::new();
    }
    let row = |cycle: &ClockingResult| {
        let deg = |value: f64| format_fixed(value, 5);
        let [first, second] = cycle.touches_deg;
        vec![
            cycle.file.clone(),
            cycle.axis.clone(),
            deg(first),
            deg(second),
            deg(cycle.middle_deg),
            format_fixed(cycle.tried_deg, 3),
            format_fixed(cycle.off_deg, 6),
        ]
    };
    vec![Block::Table(Table {
        caption: String::new(),
        columns: vec![
            Column::text("Program"),
            Column::text("Axis"),
            Column::number("First touch", "deg"),
            Column::number("Second touch", "deg"),
            Column::number("Middle", "deg"),
            Column::number("Errors tried", "deg"),
            Column::number("Found within", "deg"),
        ],
        rows: result.clocking_programs.iter().map(row).collect(),
        note: "The table turns until either flank touches the ball of the probe; the mean of both positions less the middle goes into the work offset. Each text was read back and followed on workpieces that are turned by the errors tried, either way, touches found by rays of their flanks."
            .into(),
    })]
}
