//! The conventional method, with the beam parallel to the tool's axis in every pose, beside the virtual contact points.

use foundation::geometry::Flank;
use report::cells::{NONE, fixed, fixed_or_none};
use report::charts::ChartError;
use report::data::{Block, Column, Table};

/// A track in both ways of measuring.
#[derive(Clone, Debug, PartialEq)]
pub struct ConventionalRow {
    /// Flank.
    pub flank: Flank,
    /// Track, from 1.
    pub track: usize,
    /// Deviation at the virtual contact point, um.
    pub virtual_um: f64,
    /// What the conventional method reads, um; none where the beam rests on the body instead of the rounding.
    pub conventional_um: Option<f64>,
    /// theta of the virtual contact point, deg.
    pub contact_deg: f64,
    /// Angle at which the conventional beam touches, deg.
    pub touch_deg: Option<f64>,
    /// theta_hi: where the rounding ends, deg.
    pub end_deg: f64,
}

pub(super) fn blocks(rows: &[ConventionalRow]) -> Result<Vec<Block>, ChartError> {
    let cells = |row: &ConventionalRow| {
        let name = format!("comparison on the {} flank, track {}", row.flank, row.track);
        let (reading, error) = match row.conventional_um {
            Some(um) => (fixed(&name, um, 3)?, fixed(&name, um - row.virtual_um, 3)?),
            None => ("beam rests on the body".into(), NONE.into()),
        };
        Ok(vec![
            row.flank.to_string(),
            row.track.to_string(),
            fixed(&name, row.virtual_um, 3)?,
            reading,
            error,
            fixed(&name, row.contact_deg, 2)?,
            fixed_or_none(&name, row.touch_deg, 2)?,
            fixed(&name, row.end_deg, 2)?,
        ])
    };
    let blind = rows.iter().filter(|row| row.conventional_um.is_none()).count();
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
