//! The law that answers the run-out of the tool, and what is left of the differences between its teeth.

use crate::workflow::RunoutResult;
use report::cells::{fixed, significant};
use report::charts::ChartError;
use report::{Block, Column, Quantity, Table};

/// Figures and terms of the law; nothing without one.
pub(super) fn blocks(found: Option<&RunoutResult>) -> Result<Vec<Block>, ChartError> {
    let Some(found) = found else { return Ok(Vec::new()) };
    let um = |name: &str, value: f64| Quantity::number(name, "", value, "µm");
    let figures = Table::of_quantities(
        "Differences between the teeth",
        &[
            um("predicted range, as measured", found.spread_um[0]),
            um("predicted range, with the law", found.spread_um[1]),
            um("simulated range, as measured", found.simulated_spread_um[0]),
            um("simulated range, with the law", found.simulated_spread_um[1]),
            um("largest difference between prediction and simulation", found.model_difference_um),
            um("amplitude of the centre distance", found.centre_distance_amplitude_um),
            Quantity::number(
                "amplitude of the workpiece angle",
                "",
                3600.0 * found.work_angle_amplitude_deg,
                "arcsec",
            ),
        ],
    );
    let orders = found.centre_distance_um.len().max(found.work_angle_deg.len());
    let row = |order: usize| {
        let distance = found.centre_distance_um.get(order).copied().unwrap_or_default();
        let turn = found.work_angle_deg.get(order).copied().unwrap_or_default().map(|deg| 3600.0 * deg);
        Ok(vec![
            (order + 1).to_string(),
            fixed("law", distance[0], 3)?,
            fixed("law", distance[1], 3)?,
            significant("law", turn[0], 4)?,
            significant("law", turn[1], 4)?,
        ])
    };
    let terms = Table {
        caption: "Law over the turn of the tool".into(),
        columns: vec![
            Column::number("Order", ""),
            Column::number("Distance, cosine", "µm"),
            Column::number("Distance, sine", "µm"),
            Column::number("Workpiece, cosine", "arcsec"),
            Column::number("Workpiece, sine", "arcsec"),
        ],
        rows: (0..orders).map(row).collect::<Result<_, ChartError>>()?,
        note: "Added to centre distance and angle of the workpiece; the angle of the tool is 0 where tooth 0 stands on the common normal."
            .into(),
    };
    Ok(vec![Block::Table(figures), Block::Table(terms)])
}
