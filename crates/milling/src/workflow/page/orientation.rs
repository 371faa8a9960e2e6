//! The comparison of orientations as the page takes it.

use crate::page::{OrientationView, OrientedRowView, RotaryView};
use crate::workflow::orientation_result::OrientationFigures;
use crate::workflow::run::MillingOutcome;
use crate::workflow::{ComparedOrientations, RotaryFigures};

/// All flanks that were compared.
pub(super) fn views(outcome: &MillingOutcome) -> Vec<OrientationView> {
    outcome.orientations.iter().map(view).collect()
}

fn view(compared: &ComparedOrientations) -> OrientationView {
    let result = &compared.result;
    let sheared = format!("along lines sheared by {} % of the face", 100.0 * result.shear);
    let all = [
        ("column", "in the column planes".to_owned(), &result.column),
        ("iso", "along the parameter lines".to_owned(), &result.iso),
        ("sheared", sheared, &result.sheared),
    ];
    let side = compared.side.name();
    OrientationView {
        flank: format!("{}{} flank", side[..1].to_uppercase(), &side[1..]),
        machine: format!("the machine {}", result.machine),
        axes: result.axes.clone(),
        rows: all.into_iter().map(|(key, name, figures)| row(compared, key, name, figures)).collect(),
    }
}

fn row(
    compared: &ComparedOrientations,
    key: &str,
    name: String,
    figures: &OrientationFigures,
) -> OrientedRowView {
    let curve = compared.curves.iter().find(|curve| curve.name == key);
    let of = |figures: &RotaryFigures| RotaryView {
        travel_deg: figures.travel_deg,
        second: figures.max_second_deg_per_mm2,
        reversals: figures.reversals,
        lean_deg: figures.lean_deg,
    };
    OrientedRowView {
        name,
        figures: match figures {
            OrientationFigures::Reached(figures) => Ok(of(figures)),
            OrientationFigures::NotReached { not_reached } => Err(not_reached.clone()),
        },
        arc_mm: curve.map(|curve| curve.arc_mm.clone()).unwrap_or_default(),
        angles_deg: curve.map(|curve| curve.angles_deg.clone()).unwrap_or_default(),
    }
}
