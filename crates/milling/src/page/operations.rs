//! Operations in their order.

use super::cutter_words::cutter_words;
use crate::workflow::{CutterResult, MillingOutcome};
use report::charts::format_fixed;
use report::{Column, Table};

/// Every operation of one space with its cutter.
pub(super) fn table(outcome: &MillingOutcome) -> Table {
    let options = &outcome.prepared.bodies.options;
    let rows = outcome.result.operations.iter().zip(&outcome.plan.operations).map(|(operation, planned)| {
        let cutter = options.cutter_of(planned.kind);
        vec![
            operation.name.clone(),
            cutter_words(&CutterResult::new(cutter.shape(), cutter.cutting_length())),
            operation.paths.to_string(),
            operation.places.to_string(),
            format_fixed(operation.way_mm, 1),
        ]
    });
    Table {
        caption: String::new(),
        columns: vec![
            Column::text("Operation"),
            Column::text("Cutter"),
            Column::number("Paths", ""),
            Column::number("Places", ""),
            Column::number("Way", "mm"),
        ],
        rows: rows.collect(),
        note: "In one space; the way is that of the cutter's tip along the paths, without coming and going."
            .into(),
    }
}
