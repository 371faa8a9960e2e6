//! The conventional method, with the beam parallel to the tool's axis in every pose, beside the virtual contact points.

use crate::workflow::{ConventionalResult, SkivingBodies};
use foundation::geometry::Flank;
use report::cells::{NONE, fixed, fixed_or_none};
use report::charts::ChartError;
use report::{Block, Column, Table};

/// Both ways of measuring beside each other, of the simulated tool, else of the ideal one.
pub(super) fn blocks(bodies: &SkivingBodies, rows: &[ConventionalResult]) -> Result<Vec<Block>, ChartError> {
    if rows.is_empty() {
        return Ok(Vec::new());
    }
    let cells = |row: &ConventionalResult| {
        let name = format!("comparison on the {} flank, track {}", row.flank, row.track);
        let flank = if row.flank == Flank::Left.name() { Flank::Left } else { Flank::Right };
        let section = &bodies.flanks[flank].tracks[row.track - 1].0.section;
        let at_contact_um = row.measured_um.zip(row.reported_um).map_or(0.0, |(measured, _)| measured);
        let (reading, error) = match reading_um(row) {
            Some(um) => (fixed(&name, um, 3)?, fixed(&name, um - at_contact_um, 3)?),
            None => ("beam rests on the body".into(), NONE.into()),
        };
        Ok(vec![
            row.flank.to_string(),
            row.track.to_string(),
            fixed(&name, at_contact_um, 3)?,
            reading,
            error,
            fixed(&name, section.contact_angle.to_degrees(), 2)?,
            fixed_or_none(&name, row.touch_deg, 2)?,
            fixed(&name, section.range[1].to_degrees(), 2)?,
        ])
    };
    let blind = rows.iter().filter(|row| reading_um(row).is_none()).count();
    let mut blocks = vec![Block::Table(Table {
        caption: String::new(),
        columns: vec![
            Column::text("Flank"),
            Column::number("Track", ""),
            Column::number("Virtual contact", "µm"),
            Column::number("Conventional", "µm"),
            Column::number("Error", "µm"),
            Column::number("Contact θ", "deg"),
            Column::number("Touch", "deg"),
            Column::number("Rounding ends", "deg"),
        ],
        rows: rows.iter().map(cells).collect::<Result<_, ChartError>>()?,
        note: "Conventional: the beam parallel to the tool's axis in every pose, so that it touches the silhouette of the edge.".into(),
    })];
    if blind > 0 {
        blocks.push(Block::Paragraph(format!(
            "On {blind} of {} tracks the conventional beam rests on the body of the tooth: wear of the edge cannot be seen there.",
            rows.len()
        )));
    }
    Ok(blocks)
}

/// What the conventional method reads, um; none where the beam rests on the body instead of the rounding.
fn reading_um(row: &ConventionalResult) -> Option<f64> {
    row.measured_um.zip(row.reported_um).map(|(_, reported)| reported).or(row.ideal_um)
}
