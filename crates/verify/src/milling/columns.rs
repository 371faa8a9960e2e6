//! Columns with the cutter at their points, and the distances of whole grids.

use super::super::expected::Expected;
use super::super::given::{
    Checked, MOST, check_items, check_object, compare_vector, compare_vectors, number, text, tolerance, whole,
};
use super::super::ledger::Ledger;
use super::body::Body;
use super::case::{MilledCase, located};
use milling::{Column, CutterLocation, FlankGrid, GridPlace, MillingError, NeighbourDistances, RowSpacing};
use nalgebra::Vector3;
use serde_json::Value;

/// Block `columns` of a case.
pub(super) fn columns(case: &MilledCase, expected: &mut Expected<'_>, ledger: &mut Ledger) {
    let Some(object) = expected.object("columns", ledger) else { return };
    check_object(object, ledger, |object, ledger| {
        let tolerances =
            [tolerance(object, "tolerance_mm", ledger), tolerance(object, "tolerance_unit", ledger)];
        let spacing = text(object, "spacing", ledger)?;
        let points = spacing.strip_prefix("equal arc length in the column plane, ");
        let points = points.and_then(|rest| rest.strip_suffix(" points")?.parse::<u64>().ok());
        let points = points.ok_or_else(|| format!("spacing {spacing:?} is unknown"))?;
        let points = whole("points of a column", Some(&points.into()), 2..=MOST)?;
        check_items(object, "columns", ledger, |column, ledger| {
            one_column(case, points, tolerances, column, ledger)
        })
    });
}

fn one_column(
    case: &MilledCase,
    points: usize,
    [mm, unit]: [f64; 2],
    expected: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Checked {
    let (u, tilt) = (number(expected, "u", ledger)?, number(expected, "tilt_mu_rad", ledger)?);
    let column = Column::build(&case.flank, &*case.lead, u, points, RowSpacing::Arc)?;
    let lead = &column.lead;
    compare_vector(expected, "c_mm", &lead.point, mm, ledger);
    compare_vector(expected, "t", &lead.direction, unit, ledger);
    compare_vector(expected, "N", &lead.base_normal, unit, ledger);
    // Heights are lengths in cylinders only, lengths everywhere but in blades.
    let [height, length] = match case.body {
        Body::Cylinder { .. } => [mm, mm],
        Body::Bevel(_) => [unit, mm],
        Body::Blade => [unit, unit],
    };
    let places = &column.places;
    let of = |value: fn(&GridPlace) -> f64| places.iter().map(value).collect::<Vec<_>>();
    expected.list("a", &of(|place| place.height), height, ledger);
    expected.list("b", &of(|place| place.length), length, ledger);
    let points: Vec<Vector3<f64>> = places.iter().map(|place| place.jet.point).collect();
    let normals: Vec<Vector3<f64>> = places.iter().map(|place| place.jet.normal).collect();
    compare_vectors(expected, "P_mm", &points, mm, ledger);
    compare_vectors(expected, "n", &normals, unit, ledger);
    let degrees = unit.to_degrees();
    expected.list("eps_deg", &of(|place| place.out_of_plane.to_degrees()), degrees, ledger);
    let located = |place| located(place, lead, &case.cutter, case.contact_height, tilt);
    let locations = places.iter().map(located).collect::<Result<Vec<CutterLocation>, MillingError>>()?;
    let axes: Vec<Vector3<f64>> = locations.iter().map(|location| location.axis).collect();
    let tips: Vec<Vector3<f64>> = locations.iter().map(|location| location.tip).collect();
    compare_vectors(expected, "axis", &axes, unit, ledger);
    compare_vectors(expected, "tip_mm", &tips, mm, ledger);
    Ok(())
}

/// The blocks `grid_<columns>x<rows>_<law>` of a case: distances of neighbours over the lead range.
pub(super) fn grids(case: &MilledCase, value: &Value, expected: &mut Expected<'_>, ledger: &mut Ledger) {
    let keys = value.as_object().into_iter().flatten().map(|(key, _)| key.as_str());
    for key in keys.filter(|key| key.starts_with("grid_")) {
        let Some(object) = expected.object(key, ledger) else { continue };
        check_object(object, ledger, |object, ledger| {
            let tolerance = tolerance(object, "tolerance_mm", ledger);
            let (columns, rows, law) = named_grid(key)?;
            let at = case.lead_parameters(columns)?;
            let grid = FlankGrid::build(&case.flank, &*case.lead, &at, rows, law)?;
            let Some(mut density) = object.object("density", ledger) else { return Ok(()) };
            distances(&mut density, [grid.along_rows(), grid.along_columns()], tolerance, ledger);
            density.finish(ledger);
            Ok(())
        });
    }
}

/// Columns, rows and law of a grid's name.
fn named_grid(name: &str) -> Checked<(usize, usize, RowSpacing<'static>)> {
    let unknown = || format!("{name}: a name like grid_13x9_arc is needed here");
    let (counts, law) = name.trim_start_matches("grid_").split_once('_').ok_or_else(unknown)?;
    let (columns, rows) = counts.split_once('x').ok_or_else(unknown)?;
    let counted = |text: &str| -> Checked<usize> {
        let number: u64 = text.parse().map_err(|_| unknown())?;
        whole(name, Some(&number.into()), 2..=MOST)
    };
    Ok((counted(columns)?, counted(rows)?, row_law(law)?))
}

/// The law of rows of that name.
pub(super) fn row_law(name: &str) -> Checked<RowSpacing<'static>> {
    match name {
        "arc" => Ok(RowSpacing::Arc),
        "param" => Ok(RowSpacing::Parameter),
        _ => Err(format!("the law of rows {name:?} is unknown; known: arc, param").into()),
    }
}

/// The eight figures of a grid: along rows, along columns.
pub(super) fn distances(
    expected: &mut Expected<'_>,
    figures: [NeighbourDistances; 2],
    tolerance: f64,
    ledger: &mut Ledger,
) {
    for (key, figures) in ["row", "column"].into_iter().zip(figures) {
        let Some(mut object) = expected.object(key, ledger) else { continue };
        let pairs = [
            ("min_mm", figures.least),
            ("max_mm", figures.greatest),
            ("min_mean_mm", figures.least_mean),
            ("max_mean_mm", figures.greatest_mean),
        ];
        object.numbers(&pairs, tolerance, ledger);
        object.finish(ledger);
    }
}
