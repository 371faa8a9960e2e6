//! Programs of the measurement and what was proven of them.

use crate::workflow::programs::{MandrelWayResult, ToolProgramResult};
use report::cells::fixed;
use report::charts::ChartError;
use report::{Block, Column, Quantity, Table};

/// What holds of every text.
const PROOF: &str = "Every text was read by a reader that shares nothing with the writer, its axes were taken through the kinematics of the \
                     machine to the tool, and the ideal tool was measured there: it switches where it should, as far as numbers are rounded.";

/// Proof, files and figures; nothing without programs.
pub(super) fn blocks(programs: &[ToolProgramResult]) -> Result<Vec<Block>, ChartError> {
    if programs.is_empty() {
        return Ok(Vec::new());
    }
    let row = |program: &ToolProgramResult| {
        Ok(vec![
            program.file.clone(),
            program.control.to_owned(),
            program.blocks.to_string(),
            fixed(&program.file, program.duration_s, 1)?,
        ])
    };
    let table = Table {
        caption: String::new(),
        columns: vec![
            Column::name("File"),
            Column::text("Control"),
            Column::number("Blocks", ""),
            Column::number("Duration", "s"),
        ],
        rows: programs.iter().map(row).collect::<Result<_, ChartError>>()?,
        note: String::new(),
    };
    let figures = Table::of_quantities("Figures of the proof", &figures(programs));
    let mut blocks = vec![Block::Paragraph(PROOF.into()), Block::Table(table), Block::Table(figures)];
    // The ways are the same on every control.
    let driven = programs.iter().find(|program| !program.mandrel_ways.is_empty());
    blocks.extend(driven.map(|program| mandrel_ways(&program.mandrel_ways)).transpose()?.map(Block::Table));
    Ok(blocks)
}

/// Ways of the mandrel, and where the given beam will switch.
fn mandrel_ways(ways: &[MandrelWayResult]) -> Result<Table, ChartError> {
    let rows = ways.iter().flat_map(|way| way.switches_mm.iter().map(move |at| (way, at)));
    let cells = |(way, [x, y, z]): (&MandrelWayResult, &[f64; 3])| {
        let name = "way of the mandrel";
        Ok(vec![
            way.along.to_owned(),
            fixed(name, way.spindle_deg, 1)?,
            fixed(name, *x, 4)?,
            fixed(name, *y, 4)?,
            fixed(name, *z, 4)?,
        ])
    };
    Ok(Table {
        caption: "Switches of the mandrel".into(),
        columns: vec![
            Column::text("Along"),
            Column::number("Spindle", "deg"),
            Column::number("X", "mm"),
            Column::number("Y", "mm"),
            Column::number("Z", "mm"),
        ],
        rows: rows.map(cells).collect::<Result<_, ChartError>>()?,
        note: "X and Y of the mandrel's axis, Z of its lower face, where the given beam will switch.".into(),
    })
}

/// The worst of all programs.
fn figures(programs: &[ToolProgramResult]) -> Vec<Quantity> {
    let worst = |of: fn(&ToolProgramResult) -> f64| programs.iter().map(of).fold(0.0, f64::max);
    let um = |name: &str, value: f64| Quantity::number(name, "", value, "µm");
    let mut figures = vec![
        um("touch of the ideal tool off its nominal place", worst(|p| p.proof_difference_um)),
        um("beam off its place at the contact", worst(|p| p.proof_axis_distance_um)),
        um("explained by rounded numbers", worst(|p| p.proof_allowed_um)),
    ];
    let between = programs.iter().filter_map(|p| p.between_places_um).reduce(f64::max);
    figures.extend(between.map(|left| um("left by straight blocks between their ends", left)));
    let flank = programs.iter().filter_map(|p| p.flank_difference_um).reduce(f64::max);
    figures.extend(flank.map(|left| um("flank of the stroke off the planned one", left)));
    figures
}
