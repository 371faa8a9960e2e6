//! Operations in their order.

use super::cutter_words::cutter_words;
use crate::workflow::{CutterResult, MillingOutcome, OperationResult};
use report::charts::{format_fixed, format_significant};
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
        note: note(&outcome.result.operations),
    }
}

/// What the columns mean, and how the clearing cutter is engaged.
fn note(operations: &[OperationResult]) -> String {
    let mut note =
        "In one space; the way is that of the cutter's tip along the paths, without coming and going."
            .to_owned();
    for of in operations.iter().filter_map(|operation| operation.engagement) {
        note += &format!(
            " Roughing goes down by {} mm in {} layers, {} passes with the whole width and the others with {} mm at most, {}° of the \
             circumference. It removes {} cm³/min, with the whole width {}.",
            format_significant(of.depth_mm, 3),
            of.layers,
            of.full_width_passes,
            format_significant(of.width_mm, 3),
            format_fixed(of.arc_deg, 0),
            format_significant(of.removal_cm3_per_min, 3),
            format_significant(of.full_width_removal_cm3_per_min, 3)
        );
        if let Some(chip) = of.chip_thickness_mm {
            note += &format!(" Its chips are up to {} mm thick.", format_significant(chip, 2));
        }
    }
    note
}
