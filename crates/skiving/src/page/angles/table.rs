//! The angles of a tooth in figures.

use super::switching_angles::{SwitchingAngles, TrackAngles};
use foundation::geometry::Flank;
use report::cells::fixed;
use report::charts::{ChartError, format_fixed};
use report::{Column, Table};

/// Nominal and measured angles of a tooth, track by track.
pub(super) fn table(angles: &SwitchingAngles) -> Result<Table, ChartError> {
    let row = |flank: Flank, k: usize, track: &TrackAngles| {
        let what = format!("{flank} edge, track {}", k + 1);
        Ok(vec![
            flank.to_string(),
            (k + 1).to_string(),
            format_fixed(track.radius_mm, 4),
            format_fixed(track.nominal_deg, 5),
            fixed(&what, track.measured_deg, 5)?,
            fixed(&what, 3600.0 * track.offset(), 2)?,
        ])
    };
    let rows = angles
        .edges
        .iter()
        .flat_map(|(flank, edge)| edge.tracks.iter().enumerate().map(move |(k, track)| row(flank, k, track)));
    Ok(Table {
        caption: format!("Angles of tooth {}", angles.tooth),
        columns: vec![
            Column::text("Flank"),
            Column::number("Track", ""),
            Column::number("R", "mm"),
            Column::number("Nominal F", "deg"),
            Column::number("Measured F", "deg"),
            Column::number("Difference", "arcsec"),
        ],
        rows: rows.collect::<Result<_, ChartError>>()?,
        note: String::new(),
    })
}
