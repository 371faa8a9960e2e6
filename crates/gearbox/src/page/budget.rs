//! The error budget part by part.

use crate::workflow::BudgetResult;
use report::charts::{format_fixed, format_significant};
use report::{Column, Table};

/// The table of a budget; `flank_share` is what the flank moves per error along the feed.
pub(super) fn table(budget: &BudgetResult, flank_share: f64) -> Table {
    let parts = [
        ("staircase of the pulses", "p/P", budget.quantisation_um),
        ("whole counts of the period", "v (P − 1)/f_1", budget.truncation_um),
        ("pulses are seen a tick late", "v/f_1", budget.synchronisation_um),
        ("speed of the interval before", "a p²/v²", budget.acceleration_um),
    ]
    .map(|(name, formula, along_um)| (name, formula, along_um, along_um * flank_share));
    let along = parts.iter().map(|(.., along_um, _)| along_um).sum::<f64>();
    let flank = parts.iter().map(|(.., flank_um)| flank_um).sum::<f64>();
    let row = |(name, formula, along_um, flank_um): (&str, &str, f64, f64)| {
        let share = if along > 0.0 { 1e2 * along_um / along } else { 0.0 };
        vec![
            name.to_owned(),
            formula.to_owned(),
            format_significant(along_um, 4),
            format_significant(flank_um, 4),
            format_fixed(share, 1),
        ]
    };
    Table {
        caption: String::new(),
        columns: vec![
            Column::text("Part"),
            Column::symbols("Formula"),
            Column::number("Along the feed", "µm"),
            Column::number("At the flank", "µm"),
            Column::number("Share", "%"),
        ],
        rows: parts.into_iter().chain([("sum", "", along, flank)]).map(row).collect(),
        note: "At the greatest speed of the motion; starts, stops and reversals saturate the part of the acceleration at p (P − 1)/P.".into(),
    }
}
