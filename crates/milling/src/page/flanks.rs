//! Figures of all flanks beside each other.

use super::shown_flank::ShownFlank;
use crate::workflow::FlankResult;
use report::charts::format_significant;
use report::{Column, Table};

/// Deviations below this are printed as such: nothing in metrology is as small, um.
const ROUNDING_UM: f64 = 1e-4;

/// Deviations of every flank, and its rays that are not milled.
pub(super) fn table(flanks: &[ShownFlank<'_>], tolerance_um: f64) -> Table {
    let um = |x: f64| match x {
        x if x == 0.0 || x.abs() >= ROUNDING_UM => format_significant(x, 4),
        x if x > 0.0 => format!("< {ROUNDING_UM}"),
        _ => format!("> −{ROUNDING_UM}"),
    };
    let row = |flank: &ShownFlank<'_>| {
        let f = flank.result;
        let [deepest, highest] = f.stock_um;
        vec![
            flank.name(),
            um(f.max_deviation_um),
            um(f.rms_deviation_um),
            um(highest),
            um(deepest),
            um(f.model_difference_um),
            um(f.referee_error_um),
            unmilled(f),
        ]
    };
    Table {
        caption: String::new(),
        columns: vec![
            Column::name("Flank"),
            Column::number("Largest", "µm"),
            Column::number("Rms", "µm"),
            Column::number("Highest stock", "µm"),
            Column::number("Deepest gouge", "µm"),
            Column::number("Prediction off by", "µm"),
            Column::number("Rays' own error", "µm"),
            Column::text("Rays not milled"),
        ],
        rows: flanks.iter().map(row).collect(),
        note: format!(
            "Deviations that the rays found, normal to the flank, > 0 stock; a gouge is < 0. Tolerance {} µm.",
            um(tolerance_um)
        ),
    }
}

/// Rays that are not milled, by reason; among them those that the other half of a double-helical gear keeps the cutter from.
fn unmilled(flank: &FlankResult) -> String {
    let out_of_reach = flank.out_of_reach.map(|left| ("the other half is in the way", left.rays));
    let reasons = flank.unmilled.iter().map(|(reason, count)| (reason.as_str(), *count));
    let all: Vec<String> =
        reasons.chain(out_of_reach).map(|(reason, count)| format!("{count} ({reason})")).collect();
    if all.is_empty() { "none".into() } else { all.join(", ") }
}
