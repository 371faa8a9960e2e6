//! Tables of amounts over a flank: written point by point, coordinate outside, diameter inside, both ascending; read so and by axes.

use super::document::Component;
use super::draft::Draft;
use super::error::RexsError;
use super::flank::FlankPlace;
use super::values::{Asked, title};
use super::warning::{RexsWarning, RexsWarningKind};
use crate::inspection::DatumFace;
use foundation::geometry::Flank;
use foundation::modification::{FlankChoice, GridSpec, ModificationSpec, PointMethod, PointsSpec};

/// Places nearer than this are one, mm.
const SAME_MM: f64 = 1e-7;
/// Fewest rows and columns of a table that a spline goes through.
const LEAST: usize = 4;

/// A table of f_t in um, `[w][z]`, positive = material, as a component.
pub(super) fn write(
    place: &FlankPlace,
    w_mm: &[f64],
    z_mm: &[f64],
    f_um: impl Fn(usize, usize) -> f64,
) -> Draft {
    let n = w_mm.len() * z_mm.len();
    let (mut xi, mut d, mut amounts) = (Vec::with_capacity(n), Vec::with_capacity(n), Vec::with_capacity(n));
    let mut rows: Vec<usize> = (0..z_mm.len()).collect();
    if place.datum_face == DatumFace::PlusZ {
        rows.reverse();
    }
    for j in rows {
        for (i, w) in w_mm.iter().enumerate() {
            xi.push(place.distance(z_mm[j]));
            d.push(place.diameter(*w));
            // Adding zero turns -0 into 0.
            amounts.push(-1e-3 * f_um(i, j) + 0.0);
        }
    }
    Draft::new("topographical_modification")
        .list("coordinates_of_topographical_modification", xi)
        .list("diameters_of_topographical_modification", d)
        .list("topographical_modification_amounts", amounts)
        .word("type_of_interpolation_topographical_modification", "spline")
        .boolean("is_additive_modification", true)
}

/// Lists of a component as a modification of one flank.
pub(super) fn read(
    component: &Component,
    place: &FlankPlace,
    flank: Flank,
    warnings: &mut Vec<RexsWarning>,
) -> Result<ModificationSpec, RexsError> {
    let of = Asked(component);
    let amounts = of.needed_list("topographical_modification_amounts")?;
    let xi = of.needed_list("coordinates_of_topographical_modification")?;
    let w = match of.list("length_of_topographical_modification")? {
        Some(list) => list,
        None => {
            let id = "diameters_of_topographical_modification";
            let list = of.needed_list(id)?;
            list.iter().map(|d| place.roll(component, id, *d)).collect::<Result<_, _>>()?
        }
    };
    let mut assume = |message: String| warnings.push(RexsWarning::new(RexsWarningKind::Assumed, message));
    if of.boolean("is_additive_modification")? == Some(false) {
        assume(format!("{} replaces the other modifications; it is added to them here", title(component)));
    }
    let z: Vec<f64> = xi.iter().map(|xi| place.height(*xi)).collect();
    let table = table(component, &w, &z, &amounts)?;
    let flank = FlankChoice::from(flank);
    if table.w.len() < LEAST || table.z.len() < LEAST {
        let mut points = Vec::with_capacity(amounts.len());
        for (i, w) in table.w.iter().enumerate() {
            points.extend(table.z.iter().enumerate().map(|(j, z)| [*w, *z, table.f_um[i][j]]));
        }
        let method = PointMethod::Linear;
        return Ok(ModificationSpec::Points(PointsSpec { points, method, flank, ..Default::default() }));
    }
    let id = "type_of_interpolation_topographical_modification";
    if let Some(word) = of.word(id)?.filter(|word| *word != "spline") {
        let word: String = word.chars().take(40).collect();
        assume(format!(
            "{} is interpolated `{word}`; a spline goes through its points here",
            title(component)
        ));
    }
    let (w_mm, z_mm, f_um) = (table.w, table.z, table.f_um);
    Ok(ModificationSpec::Grid(GridSpec { w_mm, z_mm, f_um, flank, ..Default::default() }))
}

struct Table {
    w: Vec<f64>,
    z: Vec<f64>,
    f_um: Vec<Vec<f64>>,
}

/// Point by point where all lists are of one length, else by axes.
fn table(component: &Component, w: &[f64], z: &[f64], amounts: &[f64]) -> Result<Table, RexsError> {
    let n = amounts.len();
    let by_points = w.len() == n && z.len() == n;
    if n == 0 || !(by_points || w.len().checked_mul(z.len()) == Some(n)) {
        let what = format!("{} coordinates, {} diameters and {n} amounts", z.len(), w.len());
        return Err(RexsError::ArrayLength { component: title(component), what });
    }
    let (places_w, places_z) = (different(w), different(z));
    let incomplete = || RexsError::GridIncomplete {
        component: title(component),
        points: n,
        coordinates: places_z.len(),
        diameters: places_w.len(),
    };
    if places_w.len().checked_mul(places_z.len()) != Some(n) {
        return Err(incomplete());
    }
    let mut f_um = vec![vec![f64::NAN; places_z.len()]; places_w.len()];
    for (k, amount) in amounts.iter().enumerate() {
        let (i, j) = if by_points { (k, k) } else { (k % w.len(), k / w.len()) };
        let cell = &mut f_um[nearest(&places_w, w[i])][nearest(&places_z, z[j])];
        if !cell.is_nan() {
            return Err(incomplete());
        }
        *cell = -1e3 * amount + 0.0;
    }
    Ok(Table { w: places_w, z: places_z, f_um })
}

/// Different values, ascending.
fn different(values: &[f64]) -> Vec<f64> {
    let mut list = values.to_vec();
    list.sort_by(f64::total_cmp);
    list.dedup_by(|later, first| (*later - *first).abs() <= SAME_MM);
    list
}

fn nearest(places: &[f64], value: f64) -> usize {
    let above = places.partition_point(|place| *place < value).min(places.len() - 1);
    let below = above.saturating_sub(1);
    if (places[below] - value).abs() < (places[above] - value).abs() { below } else { above }
}
