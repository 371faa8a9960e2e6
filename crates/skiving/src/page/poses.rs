//! Tracks and the poses in which they are measured.

use crate::workflow::TrackResult;
use foundation::geometry::Flank;
use report::cells::{fixed, fixed_or_none};
use report::charts::ChartError;
use report::{Block, Column, Table};
use std::collections::BTreeMap;

/// A track of a flank.
type Row<'a> = (Flank, &'a TrackResult);

/// What the contact points are, and where the axes stand.
pub(super) fn blocks(of: &BTreeMap<&'static str, Vec<TrackResult>>) -> Result<Vec<Block>, ChartError> {
    let of_flank = |flank: Flank| of.get(flank.name()).into_iter().flatten().map(move |track| (flank, track));
    let rows: Vec<Row<'_>> = Flank::BOTH.into_iter().flat_map(of_flank).collect();
    if rows.is_empty() {
        return Ok(Vec::new());
    }
    Ok(vec![Block::Table(tracks(&rows)?), Block::Table(axes(&rows)?)])
}

fn name((flank, row): &Row<'_>) -> String {
    format!("pose of the {flank} flank, track {}", row.track)
}

fn tracks(rows: &[Row<'_>]) -> Result<Table, ChartError> {
    let cells = |row: &Row<'_>| {
        let name = name(row);
        let (flank, row) = row;
        Ok(vec![
            flank.to_string(),
            row.track.to_string(),
            fixed(&name, row.place, 2)?,
            fixed(&name, row.w_mm, 4)?,
            fixed(&name, row.radius_mm, 4)?,
            fixed(&name, row.height_mm, 4)?,
            fixed(&name, row.tool_angle_deg, 4)?,
            fixed(&name, row.contact_angle_deg, 2)?,
            fixed(&name, row.lever_mm_per_rad, 4)?,
        ])
    };
    Ok(Table {
        caption: "Virtual contact points".into(),
        columns: vec![
            Column::text("Flank"),
            Column::number("Track", ""),
            Column::number("x", ""),
            Column::number("Roll w", "mm"),
            Column::number("R", "mm"),
            Column::number("Z", "mm"),
            Column::number("φ_1", "deg"),
            Column::number("θ", "deg"),
            Column::number("Lever L", "mm/rad"),
        ],
        rows: rows.iter().map(cells).collect::<Result<_, ChartError>>()?,
        note: "R, Z in tool coordinates; θ counts on the rounding from the normal of the rake face.".into(),
    })
}

fn axes(rows: &[Row<'_>]) -> Result<Table, ChartError> {
    let cells = |row: &Row<'_>| {
        let name = name(row);
        let (flank, row) = row;
        let [x, y, z] = row.position_mm;
        let gap = row.other_flank_gap_mm;
        let gap = gap.is_finite().then_some(gap);
        Ok(vec![
            flank.to_string(),
            row.track.to_string(),
            fixed(&name, row.a_deg, 4)?,
            fixed(&name, row.b_deg, 4)?,
            fixed(&name, x, 4)?,
            fixed(&name, y, 4)?,
            fixed(&name, z, 4)?,
            fixed(&name, row.off_flank_deg, 2)?,
            fixed_or_none(&name, gap, 2)?,
            fixed(&name, row.single_sigma_um, 2)?,
        ])
    };
    Ok(Table {
        caption: "Axes".into(),
        columns: vec![
            Column::text("Flank"),
            Column::number("Track", ""),
            Column::number("A", "deg"),
            Column::number("B of tooth 0", "deg"),
            Column::number("X", "mm"),
            Column::number("Y", "mm"),
            Column::number("Z", "mm"),
            Column::number("Off flank η", "deg"),
            Column::number("Gap", "mm"),
            Column::number("One reading", "µm"),
        ],
        rows: rows.iter().map(cells).collect::<Result<_, ChartError>>()?,
        note: "Gap: beam to the nearest other flank. One reading: its standard deviation at the flank."
            .into(),
    })
}
