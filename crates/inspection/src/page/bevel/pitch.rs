//! Pitches, run-out and the classes that they reach.

use crate::page::class_table::class_table;
use crate::workflow::BevelInspectionResult;
use report::charts::{ChartError, LineChart, Panel, Series, format_fixed, line_chart};
use report::{Block, Figure, Quantity, Sheet, Table};

/// Values with their classes.
pub(super) fn classes(result: &BevelInspectionResult) -> Option<Table> {
    if result.classes.is_empty() {
        return None;
    }
    let note = "Pitches on the mean pitch diameter. The standard has no tolerances for flank forms; these are judged by the tolerance \
                of the job.";
    Some(class_table("ISO 17485:2006", &result.classes, result.tolerance_class, note))
}

pub(super) fn sheet(result: &BevelInspectionResult) -> Sheet {
    let um = |name: &str, symbol: &str, value: f64| Quantity::rounded(name, symbol, value, 2, "µm");
    let mut list = Vec::new();
    for (flank, pitch) in &result.pitch {
        list.push(um(&format!("single pitch deviation, {flank}"), "f_p", pitch.single_um));
        list.push(um(&format!("cumulative pitch deviation, {flank}"), "F_p", pitch.total_um));
    }
    list.extend(result.run_out_um.map(|value| um("run-out from the pitches", "F_r", value)));
    let sheet = Sheet::new("Pitch and run-out", list);
    if result.pitch.is_empty() { sheet.remark("Pitches were not measured.") } else { sheet }
}

/// The table of classes and the cumulative pitch of both flanks; nothing where no pitch was measured.
pub(super) fn blocks(result: &BevelInspectionResult) -> Result<Vec<Block>, ChartError> {
    let mut blocks: Vec<Block> = classes(result).map(Block::Table).into_iter().collect();
    if let Some(place) = &result.pitch_place {
        blocks.push(Block::Paragraph(format!(
            "The pitch was measured at row {}, column {}, on a radius of {} mm; deviations are on the mean pitch diameter of {} mm.",
            place.row,
            place.column,
            format_fixed(place.radius_mm, 3),
            format_fixed(place.tolerance_diameter_mm, 3)
        )));
    }
    let lines: Vec<Series> = result
        .pitch
        .iter()
        .map(|(flank, of)| {
            let teeth = (1..=of.cumulative_um.len()).map(|tooth| tooth as f64).collect();
            Series::new(*flank, teeth, of.cumulative_um.clone())
        })
        .collect();
    if !lines.is_empty() {
        let title = "Cumulative pitch of every tooth".to_owned();
        let svg = line_chart(&LineChart {
            title,
            x_title: "tooth".into(),
            panels: vec![Panel::linear("F_p [µm]".to_owned(), LEAST_SPAN_UM, lines)],
        })?;
        blocks.push(Block::Figure(Figure::new("cumulative-pitch", svg, "")));
    }
    Ok(blocks)
}

/// Smallest span of the chart: below it a line is flat, µm.
const LEAST_SPAN_UM: f64 = 0.1;
