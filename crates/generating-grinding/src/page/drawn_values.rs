//! The values of the drawing as made: what an inspection of the ground gear would print.

use super::content::GrindingPage;
use crate::workflow::drawn_values::{TraceDirection, TraceResult};
use foundation::geometry::Flank;
use report::cells::{NONE, flank_title};
use report::charts::{format_fixed, format_significant};
use report::{Block, Column, Table};

/// A value of the result with its symbol in the reports and its name.
pub(super) const SYMBOLS: [(&str, &str); 8] = [
    ("C_alpha", "C_α crowning"),
    ("C_Halpha", "C_Hα slope"),
    ("C_alpha_a", "C_αa tip relief"),
    ("C_alpha_f", "C_αf root relief"),
    ("C_beta", "C_β crowning"),
    ("C_Hbeta", "C_Hβ slope"),
    ("C_beta_I", "C_βI end relief at face I"),
    ("C_beta_II", "C_βII end relief at face II (datum face)"),
];

fn place(trace: &TraceResult) -> String {
    let at = format_significant(trace.position_mm, 5);
    match trace.direction {
        TraceDirection::Profile => format!("profile at z = {at} mm"),
        TraceDirection::Helix => format!("helix at w = {at} mm"),
    }
}

fn range([from, to]: [f64; 2]) -> String {
    format!("{} to {}", format_significant(from, 5), format_significant(to, 5))
}

/// The section; empty without traces.
pub(super) fn drawn_values(page: &GrindingPage<'_>) -> Vec<Block> {
    let each = || {
        page.flanks
            .iter()
            .filter_map(|(flank, shown)| shown.as_ref().map(|shown| (flank, shown)))
            .flat_map(|(flank, shown)| shown.result.traces.iter().map(move |trace| (flank, trace)))
    };
    if each().next().is_none() {
        return Vec::new();
    }
    let mut blocks = vec![Block::Table(values(each())), Block::Table(deviations(each(), page.tolerance_um))];
    for (flank, trace) in each() {
        for reason in &trace.not_evaluated {
            blocks.push(Block::Paragraph(format!(
                "{}, {}: not evaluated, {reason}.",
                flank_title(flank),
                place(trace)
            )));
        }
    }
    blocks
}

fn values<'a>(traces: impl Iterator<Item = (Flank, &'a TraceResult)>) -> Table {
    let rows = traces.flat_map(|(flank, trace)| {
        trace.values.iter().map(move |value| {
            let known = SYMBOLS.iter().find(|(symbol, _)| *symbol == value.symbol);
            vec![
                flank_title(flank).to_owned(),
                place(trace),
                known.map_or(value.symbol, |(_, shown)| shown).to_owned(),
                value.drawn_um.map_or(NONE.to_owned(), |um| format_significant(um, 6)),
                format_fixed(value.target_um, 3),
                format_fixed(value.made_um, 3),
                format_fixed(value.made_um - value.target_um, 3),
            ]
        })
    });
    Table {
        caption: "Values of the drawing, as an inspection would find them".to_owned(),
        columns: vec![
            Column::text("Flank"),
            Column::text("Trace"),
            Column::symbols("Value"),
            Column::number("Drawing", "µm"),
            Column::number("Target, evaluated", "µm"),
            Column::number("Made", "µm"),
            Column::number("Made − target", "µm"),
        ],
        rows: rows.collect(),
        note: "Transverse, positive: material removed. Traces of the simulated flank, evaluated as `inspect` evaluates a measured gear. Crowning and slope stand for the part without reliefs, the slope over the whole evaluated length; a relief is its line over that of the part without reliefs, at its far end. So the drawing's amounts compare with the evaluated target where nothing else is curved there; what is made compares with the evaluated target always."
            .to_owned(),
    }
}

fn deviations<'a>(traces: impl Iterator<Item = (Flank, &'a TraceResult)>, tolerance_um: f64) -> Table {
    let rows = traces.map(|(flank, trace)| {
        let mut row = vec![
            flank_title(flank).to_owned(),
            place(trace),
            range(trace.range_mm),
            range(trace.unrelieved_mm),
        ];
        row.extend([trace.total_um, trace.form_um, trace.slope_um].map(|um| format_fixed(um, 3)));
        row.push(format_fixed(trace.tolerance_share, 3));
        row
    });
    Table {
        caption: "Deviations of the same traces from the target".to_owned(),
        columns: vec![
            Column::text("Flank"),
            Column::text("Trace"),
            Column::text("Range, mm"),
            Column::text("Without reliefs, mm"),
            Column::symbols("F"),
            Column::symbols("f_f"),
            Column::symbols("f_H"),
            Column::number("Share of the tolerance", ""),
        ],
        rows: rows.collect(),
        note: format!(
            "F, f_f and f_H in µm, transverse: total, form and slope deviation to ISO 1328-1 over the whole range, against the target. The share is the largest distance of the trace from the target, normal, over the tolerance at its place ({} µm where it is tightest).",
            format_significant(tolerance_um, 4)
        ),
    }
}
