//! The error budget part by part.

use crate::workflow::BudgetResult;
use report::cells::NONE;
use report::charts::{format_fixed, format_significant};
use report::{Column, Table};

/// The table of a budget; `flank_share` is what the flank moves per error along the feed, `measuring_um` what errors of scale, screw and
/// encoder come to at the flank, where the job has any.
pub(super) fn table(budget: &BudgetResult, flank_share: f64, measuring_um: Option<f64>) -> Table {
    let parts = [
        ("staircase of the pulses", "p/P", budget.quantisation_um),
        ("whole counts of the period", "v (P − 1)/f_1", budget.truncation_um),
        ("pulses are seen a tick late", "v/f_1", budget.synchronisation_um),
        ("speed of the interval before", "a p²/v²", budget.acceleration_um),
    ]
    .map(|(name, formula, along_um)| (name, formula, along_um, along_um * flank_share));
    let along = parts.iter().map(|(.., along_um, _)| along_um).sum::<f64>();
    let flank = parts.iter().map(|(.., flank_um)| flank_um).sum::<f64>() + measuring_um.unwrap_or_default();
    let row = |name: &str, formula: &str, along_um: Option<f64>, flank_um: f64| {
        // A spur gear shows nothing of the feed on its flank.
        let share = if flank > 0.0 { flank_um / flank } else { along_um.unwrap_or_default() / along };
        vec![
            name.to_owned(),
            formula.to_owned(),
            along_um.map_or_else(|| NONE.to_owned(), |um| format_significant(um, 4)),
            format_significant(flank_um, 4),
            format_fixed(1e2 * share, 1),
        ]
    };
    let sum = if measuring_um.is_some() { None } else { Some(along) };
    let mut rows: Vec<Vec<String>> = parts
        .into_iter()
        .map(|(name, formula, along_um, flank_um)| row(name, formula, Some(along_um), flank_um))
        .collect();
    rows.extend(measuring_um.map(|um| row("scale, screw and encoder", "", None, um)));
    rows.push(row("sum", "", sum, flank));
    Table {
        caption: String::new(),
        columns: vec![
            Column::text("Part"),
            Column::symbols("Formula"),
            Column::number("Along the feed", "µm"),
            Column::number("At the flank", "µm"),
            Column::number("Share", "%"),
        ],
        rows,
        note: "At the greatest speed of the motion; starts, stops and reversals saturate the part of the acceleration at p (P − 1)/P.".into(),
    }
}
