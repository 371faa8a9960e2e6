//! The chart of the used worm width, from the table of the plan.

use foundation::geometry::Flank;
use generating::areas::{Occupation, PlaceKind};
use report::charts::{OccupationBar, OccupationKind, OccupationRow, WormOccupationChart};

/// The chart of the used worm width: a row a flank that is ground, areas numbered from 1 along the worm.
pub fn occupation_chart(title: &str, occupation: &Occupation) -> WormOccupationChart {
    let bars = |flank: Flank| -> Vec<OccupationBar> {
        let places = occupation.places.iter().filter(|place| place.flank == flank);
        places
            .map(|place| OccupationBar {
                kind: match place.kind {
                    PlaceKind::Finishing => OccupationKind::Finishing,
                    PlaceKind::Modified => OccupationKind::Modified,
                    PlaceKind::Roughing => OccupationKind::Roughing,
                    PlaceKind::Unused => OccupationKind::Unused,
                },
                label: place.area.map_or(String::new(), |area| (area + 1).to_string()),
                z_1_mm: place.z_1,
            })
            .collect()
    };
    let rows = [(Flank::Left, "Left flank"), (Flank::Right, "Right flank")]
        .map(|(flank, name)| OccupationRow { name: name.into(), bars: bars(flank) });
    WormOccupationChart {
        title: title.into(),
        width_mm: occupation.width,
        rows: rows.into_iter().filter(|row| !row.bars.is_empty()).collect(),
    }
}
