//! Volumes of stock: integrals over the flank of what lies in bands of height.

use super::column::mean_between;
use super::sampled::{rolls, weights};
use super::{Bodies, StockField};
use foundation::geometry::Flank;
use foundation::numerics::equidistant;
use rayon::prelude::*;

/// Intervals along each piece of the profile between breaks, and along the face width.
const ALONG_PROFILE: usize = 192;
const ALONG_FACE: usize = 320;
/// Intervals along each piece of the profile where every space has its own; half as many miss a space's volume by 2e-5.
const ALONG_PROFILE_OF_EACH: usize = 96;

/// Volume of each space in each band `[low, high]` of height, mm^3: `[band][space]`; one space where all are alike.
pub(crate) fn volumes(
    field: &StockField,
    bodies: &Bodies,
    flank: Flank,
    bands: &[[f64; 2]],
) -> Vec<Vec<f64>> {
    // The area's density is linear: constant stock needs no more than its ends.
    let [along_profile, along_face] = match (field.is_constant(), field.is_alike()) {
        (true, _) => [1, 1],
        (false, true) => [ALONG_PROFILE, ALONG_FACE],
        (false, false) => [ALONG_PROFILE_OF_EACH, ALONG_FACE],
    };
    let engagement = &bodies.flanks[flank];
    let half = 0.5 * bodies.face_width;
    let w = rolls(field, bodies, flank, along_profile);
    let z = equidistant([-half, half], along_face + 1);
    let spaces = field.different_spaces();
    let own: Vec<_> = (0..spaces).map(|k| field.of_space(flank, k)).collect();
    let weighted: Vec<(f64, f64)> = w.iter().copied().zip(weights(&w)).collect();
    let row = |&(w, weight): &(f64, f64)| -> Vec<Vec<f64>> {
        let places: Vec<_> = z.iter().map(|&z| field.of_place(flank, w, z)).collect();
        let by = weight * bodies.face_width * engagement.area_density(w);
        let columns: Vec<Vec<f64>> =
            own.iter().map(|own| places.iter().map(|place| own.on(*place)).collect()).collect();
        let of_band =
            |band: &[f64; 2]| columns.iter().map(|column| by * mean_between(column, *band)).collect();
        bands.iter().map(of_band).collect()
    };
    let rows: Vec<Vec<Vec<f64>>> = weighted.par_iter().map(row).collect();
    let of_space = |band: usize, space: usize| rows.iter().map(|row| row[band][space]).sum();
    (0..bands.len()).map(|band| (0..spaces).map(|space| of_space(band, space)).collect()).collect()
}
