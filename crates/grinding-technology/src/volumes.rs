//! Volumes of stock: integrals over the flank of what lies in bands of height.

use super::column::above;
use super::sampled::{area_weights, rolls};
use super::stock::Bends;
use super::{Bodies, StockField};
use foundation::geometry::Flank;
use foundation::numerics::equidistant;
use rayon::prelude::*;

/// Intervals along each piece of the profile between breaks, and along the face width. What the strokes leave cuts through stock that is
/// linear between its breaks too: the profile needs intervals for that, a line along the face width none.
fn intervals(Bends { run_out, terms, marks }: Bends) -> [usize; 2] {
    let along_face = match (marks, terms, run_out) {
        (true, ..) => 320,
        (false, true, _) => 192,
        (false, false, true) => 64,
        (false, false, false) => 1,
    };
    [if terms { 96 } else { 32 }, along_face]
}

/// Volume of each space in each band `[low, high]` of height, mm^3: `[band][space]`; one space where all are alike.
pub(crate) fn volumes(
    field: &StockField,
    bodies: &Bodies,
    flank: Flank,
    bands: &[[f64; 2]],
) -> Vec<Vec<f64>> {
    // The area's density is linear: constant stock needs no more than its ends.
    let along_profile = if field.is_constant() { 1 } else { intervals(field.bends())[0] };
    let engagement = &bodies.flanks[flank];
    let w = rolls(field, bodies, flank, along_profile);
    let z = face_places(field, bodies, flank);
    let lengths: Vec<f64> = z.windows(2).map(|ends| ends[1] - ends[0]).collect();
    let spaces = field.different_spaces();
    let own: Vec<_> = (0..spaces).map(|k| field.of_space(flank, k)).collect();
    // What lies in a band is what lies above its lower end less what lies above its upper one.
    let mut levels: Vec<f64> = bands.iter().flatten().copied().filter(|level| level.is_finite()).collect();
    levels.sort_by(f64::total_cmp);
    levels.dedup();
    let weighted: Vec<(f64, f64)> = w.iter().copied().zip(area_weights(engagement, &w)).collect();
    let row = |&(w, weight): &(f64, f64)| -> Vec<f64> {
        let places: Vec<_> = z.iter().map(|&z| field.of_place(flank, w, z)).collect();
        let mut column = Vec::with_capacity(places.len());
        let mut row = Vec::with_capacity(spaces * levels.len());
        for own in &own {
            column.clear();
            column.extend(places.iter().map(|place| own.on(*place)));
            row.extend(levels.iter().map(|&level| weight * above(&column, &lengths, level)));
        }
        row
    };
    let rows: Vec<Vec<f64>> = weighted.par_iter().map(row).collect();
    // Nothing lies above an infinite level.
    let whole = |level: f64| -> Vec<f64> {
        let place = levels.iter().position(|other| *other == level);
        let of_space = |space: usize| {
            place.map_or(0.0, |place| rows.iter().map(|row| row[space * levels.len() + place]).sum())
        };
        (0..spaces).map(of_space).collect()
    };
    let in_band = |[low, high]: [f64; 2]| {
        whole(low).into_iter().zip(whole(high)).map(|(low, high)| low - high).collect()
    };
    bands.iter().map(|&band| in_band(band)).collect()
}

/// Axial places between which the stock is smooth, and near enough to count as linear.
fn face_places(field: &StockField, bodies: &Bodies, flank: Flank) -> Vec<f64> {
    let half = 0.5 * bodies.face_width;
    if field.is_constant() {
        return vec![-half, half];
    }
    let mut ends = vec![-half];
    ends.extend(field.face_breaks(flank));
    ends.push(half);
    let each = intervals(field.bends())[1].div_ceil(ends.len() - 1);
    let mut places: Vec<f64> =
        ends.windows(2).flat_map(|ends| equidistant([ends[0], ends[1]], each + 1)).collect();
    places.dedup();
    places
}
