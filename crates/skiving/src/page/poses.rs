//! Tracks and the poses in which they are measured.

use foundation::geometry::Flank;
use report::cells::{fixed, fixed_or_none};
use report::charts::ChartError;
use report::data::{Block, Column, Table};

/// A track with its pose.
#[derive(Clone, Debug, PartialEq)]
pub struct PoseRow {
    /// Flank.
    pub flank: Flank,
    /// Track, from 1.
    pub track: usize,
    /// x = -1..1 along the edge.
    pub place: f64,
    /// w: conjugate length of roll, mm.
    pub roll_mm: f64,
    /// R of the contact point, mm.
    pub radius_mm: f64,
    /// Height of the contact point, mm.
    pub height_mm: f64,
    /// phi_1, deg.
    pub tool_angle_deg: f64,
    /// theta on the rounding, deg.
    pub contact_deg: f64,
    /// L: way of the normal per turn, mm/rad.
    pub lever_mm: f64,
    /// A, deg.
    pub swivel_deg: f64,
    /// B of tooth 0, deg.
    pub turn_deg: f64,
    /// X, Y, Z, mm.
    pub position_mm: [f64; 3],
    /// eta: angle between beam and flank direction, deg.
    pub off_flank_deg: f64,
    /// Gap between the beam and the nearest other flank, mm.
    pub gap_mm: Option<f64>,
    /// Standard deviation of a single reading, um.
    pub sigma_um: Option<f64>,
}

/// What the contact points are, and where the axes stand.
pub(super) fn blocks(rows: &[PoseRow]) -> Result<Vec<Block>, ChartError> {
    Ok(vec![Block::Table(tracks(rows)?), Block::Table(axes(rows)?)])
}

fn name(row: &PoseRow) -> String {
    format!("pose of the {} flank, track {}", row.flank, row.track)
}

fn tracks(rows: &[PoseRow]) -> Result<Table, ChartError> {
    let cells = |row: &PoseRow| {
        let name = name(row);
        Ok(vec![
            row.flank.to_string(),
            row.track.to_string(),
            fixed(&name, row.place, 2)?,
            fixed(&name, row.roll_mm, 4)?,
            fixed(&name, row.radius_mm, 4)?,
            fixed(&name, row.height_mm, 4)?,
            fixed(&name, row.tool_angle_deg, 4)?,
            fixed(&name, row.contact_deg, 2)?,
            fixed(&name, row.lever_mm, 4)?,
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

fn axes(rows: &[PoseRow]) -> Result<Table, ChartError> {
    let cells = |row: &PoseRow| {
        let name = name(row);
        let [x, y, z] = row.position_mm;
        Ok(vec![
            row.flank.to_string(),
            row.track.to_string(),
            fixed(&name, row.swivel_deg, 4)?,
            fixed(&name, row.turn_deg, 4)?,
            fixed(&name, x, 4)?,
            fixed(&name, y, 4)?,
            fixed(&name, z, 4)?,
            fixed(&name, row.off_flank_deg, 2)?,
            fixed_or_none(&name, row.gap_mm, 2)?,
            fixed_or_none(&name, row.sigma_um, 2)?,
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
