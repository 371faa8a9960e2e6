//! The machined workpiece under a probe: largest deviations of its profiles and the correction of the setting that answers them.

use crate::workflow::ProbeResult;
use foundation::geometry::Flank;
use report::cells::{fixed, fixed_or_none, significant};
use report::charts::ChartError;
use report::{Block, Column, Table};

/// Profiles and changes; nothing without a probe.
pub(super) fn blocks(found: Option<&ProbeResult>) -> Result<Vec<Block>, ChartError> {
    let Some(found) = found else { return Ok(Vec::new()) };
    let row = |flank: Flank| {
        let of = found.flanks.get(flank.name())?;
        let name = "profile of the workpiece";
        let cells = || {
            Ok(vec![
                flank.to_string(),
                of.gaps.keys().cloned().collect::<Vec<_>>().join(", "),
                fixed(name, of.largest_um, 2)?,
                fixed(name, of.corrected_largest_um, 2)?,
                fixed_or_none(name, of.corrected_simulated_um, 2)?,
            ])
        };
        Some(cells())
    };
    let profiles = Table {
        caption: "Profiles of the workpiece".into(),
        columns: vec![
            Column::text("Flank"),
            Column::text("Tooth spaces"),
            Column::number("As measured", "µm"),
            Column::number("With the correction", "µm"),
            Column::number("Simulated", "µm"),
        ],
        rows: Flank::BOTH.into_iter().filter_map(row).collect::<Result<_, ChartError>>()?,
        note: "Largest deviation from the wanted profile, normal to the flank. Simulated: under the referee with the corrected setting."
            .into(),
    };
    let change = &found.correction;
    let all = [
        ("centre distance", change.centre_distance_um, "µm"),
        ("crossed-axes angle", change.crossed_axes_angle_deg, "deg"),
        ("tool shift", change.tool_shift_um, "µm"),
        ("tool angle", change.tool_angle_deg, "deg"),
    ];
    let free = all.into_iter().filter(|(name, ..)| change.settings.contains(name));
    let cells = |(name, value, unit): (&str, f64, &str)| {
        Ok(vec![name.to_owned(), significant(name, value, 5)?, unit.to_owned()])
    };
    let changes = Table {
        caption: "Further changes of the setting".into(),
        columns: vec![Column::text("Quantity"), Column::number("Change", ""), Column::text("Unit")],
        rows: free.map(cells).collect::<Result<_, ChartError>>()?,
        note: "Beside those that the tool asks for.".into(),
    };
    Ok(vec![Block::Table(profiles), Block::Table(changes)])
}
