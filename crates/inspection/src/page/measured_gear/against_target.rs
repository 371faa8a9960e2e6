//! Measured flanks against the target and against what the process should have made, in figures.

use super::flanks::{FEATURES, features_um, flanks};
use super::pictures;
use crate::workflow::{MeasuredFlankResult, RoundResult};
use foundation::geometry::Flank;
use report::cells::{fixed, fixed_or_none, flank_title, yes_no};
use report::charts::{ChartError, format_fixed};
use report::{Block, Column, Table};

const INTRODUCTION: &str = "All values are normal to the flank, positive where material is left standing, about their mean: thickness is \
     judged by span or balls. w is the length of roll, z counts from the middle of the face width.";

/// Tables and pictures of all rounds; nothing where no flank was measured as a surface.
pub(super) fn blocks(rounds: &[RoundResult]) -> Result<Vec<Block>, ChartError> {
    with_introduction(INTRODUCTION, rounds)
}

/// The same with another introduction.
pub(in crate::page) fn with_introduction(
    introduction: &str,
    rounds: &[RoundResult],
) -> Result<Vec<Block>, ChartError> {
    if rounds.iter().all(|round| flanks(round).next().is_none()) {
        return Ok(Vec::new());
    }
    let mut blocks = vec![
        Block::Paragraph(introduction.to_owned()),
        Block::Table(course(rounds)?),
        Block::Table(against_process(rounds)?),
    ];
    blocks.extend(pictures::deviations(rounds)?);
    Ok(blocks)
}

/// Number of the round, flank and what was measured of it.
fn all(rounds: &[RoundResult]) -> impl Iterator<Item = (usize, Flank, &MeasuredFlankResult)> {
    rounds.iter().flat_map(|round| flanks(round).map(|(flank, of)| (round.round, flank, of)))
}

/// Deviation of every round and flank from the target.
fn course(rounds: &[RoundResult]) -> Result<Table, ChartError> {
    let mut columns = vec![
        Column::number("Round", ""),
        Column::name("Flank"),
        Column::number("rms", "µm"),
        Column::number("largest", "µm"),
        Column::number("within tolerance", "%"),
    ];
    columns.extend(FEATURES.map(|symbol| Column::number(symbol, "µm")));
    let mut rows = Vec::new();
    for (number, flank, of) in all(rounds) {
        let mut row = vec![number.to_string(), flank_title(flank).to_owned()];
        row.extend(figures(of)?);
        rows.push(row);
    }
    let surfaces: Vec<String> = rounds.first().map_or_else(Vec::new, |round| {
        flanks(round).map(|(flank, of)| format!("{}: {}", flank_title(flank), surface(of))).collect()
    });
    Ok(Table {
        caption: "Measured less target".into(),
        columns,
        rows,
        note: format!(
            "{}. The five characteristics are those of the areal fit; slopes of material.",
            surfaces.join("; ")
        ),
    })
}

fn figures(flank: &MeasuredFlankResult) -> Result<Vec<String>, ChartError> {
    let of = &flank.measured;
    let mut cells = vec![
        fixed("rms", of.rms_um, 3)?,
        fixed("largest", of.largest_um, 3)?,
        fixed("within tolerance", 100.0 * of.within_tolerance, 0)?,
    ];
    for value in features_um(of) {
        cells.push(fixed("characteristic", value, 3)?);
    }
    Ok(cells)
}

/// What the measured surface was made of, in words.
fn surface(of: &MeasuredFlankResult) -> String {
    match of.mismatch_um {
        None => of.surface.clone(),
        Some([rms, most]) => format!(
            "{}; where they cross they disagree by {} µm rms, {} µm at most",
            of.surface,
            format_fixed(rms, 2),
            format_fixed(most, 2)
        ),
    }
}

/// Deviation of every round and flank from what the process should have made.
fn against_process(rounds: &[RoundResult]) -> Result<Table, ChartError> {
    let mut rows = Vec::new();
    for (number, flank, of) in all(rounds) {
        rows.push(vec![
            number.to_string(),
            flank_title(flank).to_owned(),
            fixed("rms", of.model.rms_um, 3)?,
            fixed("largest", of.model.largest_um, 3)?,
            fixed_or_none("correlation", of.correlation, 2)?,
            yes_no(of.explained),
        ]);
    }
    Ok(Table {
        caption: "Measured less simulated".into(),
        columns: vec![
            Column::number("Round", ""),
            Column::name("Flank"),
            Column::number("rms", "µm"),
            Column::number("largest", "µm"),
            Column::number("correlation", ""),
            Column::text("The plan explains the part"),
        ],
        rows,
        note: "The simulated flank is that of a machine without deviations. Correlation is that of both deviations from the target. \
               A compensation leaves the target by what the machine was measured to do wrong."
            .into(),
    })
}
