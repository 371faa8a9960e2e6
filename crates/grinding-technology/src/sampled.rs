//! Stock of one flank on lengths of roll and along the face width, for integrals over both.

use super::{Bodies, Engagement, StockField};
use foundation::geometry::Flank;
use foundation::numerics::equidistant;
use rayon::prelude::*;

/// Intervals along the profile, or along each piece of it between breaks, and along the face width.
const ALONG_PROFILE: usize = 28;
const ALONG_FACE: usize = 64;
/// Along the face width where there are few lengths of roll.
const ALONG_FACE_OF_FEW: usize = 192;
/// The same for stock that is the same everywhere, where the integral along the face width is exact.
const ALONG_PROFILE_CONSTANT: usize = 2048;

/// a_0 on a grid.
#[derive(Clone, Debug)]
pub(crate) struct Sampled {
    /// Lengths of roll, rising, mm.
    pub w: Vec<f64>,
    /// H of the gap at each of them, 1/mm.
    pub curvature: Vec<f64>,
    /// Axial places, rising, mm.
    pub z: Vec<f64>,
    /// Spaces that differ.
    pub spaces: usize,
    /// Spaces of the workpiece for each of them.
    pub alike: f64,
    /// [w][space][z].
    values: Vec<f64>,
}

/// Pieces of the profile from which on they share the intervals of so many, as the rows of a table do.
const PIECES: usize = 4;
/// Fewest intervals of a piece.
const FEWEST: usize = 4;

/// Lengths of roll over the profile with so many intervals on each piece between breaks of the stock, mm; fewer where there are many pieces.
pub(crate) fn rolls(field: &StockField, bodies: &Bodies, flank: Flank, intervals: usize) -> Vec<f64> {
    let [from, to] = bodies.flanks[flank].roll;
    let mut ends = vec![from];
    ends.extend(field.breaks(flank));
    ends.push(to);
    let pieces = ends.len() - 1;
    let shared = PIECES * intervals / pieces.max(PIECES);
    let intervals = shared.max(FEWEST.min(intervals));
    let mut w: Vec<f64> =
        ends.windows(2).flat_map(|ends| equidistant([ends[0], ends[1]], intervals + 1)).collect();
    w.dedup();
    w
}

/// Weights at rising lengths of roll for integrals of J times what is linear between them: exact, J being linear.
pub(crate) fn area_weights(engagement: &Engagement, w: &[f64]) -> Vec<f64> {
    let mut weights = vec![0.0; w.len()];
    for k in 1..w.len() {
        let length = w[k] - w[k - 1];
        let [a, b] = [w[k - 1], w[k]].map(|w| engagement.area_density(w));
        weights[k - 1] += length / 6.0 * (2.0 * a + b);
        weights[k] += length / 6.0 * (a + 2.0 * b);
    }
    weights
}

impl Sampled {
    /// For integrals over the whole flank.
    pub fn whole(field: &StockField, bodies: &Bodies, flank: Flank) -> Self {
        let intervals = if field.is_constant() { ALONG_PROFILE_CONSTANT } else { ALONG_PROFILE };
        Self::with_cells(field, bodies, flank, rolls(field, bodies, flank, intervals), ALONG_FACE)
    }

    /// At a few lengths of roll.
    pub fn at(field: &StockField, bodies: &Bodies, flank: Flank, w: Vec<f64>) -> Self {
        Self::with_cells(field, bodies, flank, w, ALONG_FACE_OF_FEW)
    }

    fn with_cells(field: &StockField, bodies: &Bodies, flank: Flank, w: Vec<f64>, cells: usize) -> Self {
        let half = 0.5 * bodies.face_width;
        let cells = if field.is_constant() { 1 } else { cells };
        let z = equidistant([-half, half], cells + 1);
        let spaces = field.different_spaces();
        let own: Vec<_> = (0..spaces).map(|k| field.of_space(flank, k)).collect();
        let row = |&w: &f64| -> Vec<f64> {
            let places: Vec<_> = z.iter().map(|&z| field.of_place(flank, w, z)).collect();
            own.iter().flat_map(|own| places.iter().map(|place| own.on(*place))).collect()
        };
        let values = w.par_iter().flat_map_iter(row).collect();
        let alike = field.spaces() as f64 / spaces as f64;
        let curvature = w.iter().map(|&w| bodies.flanks[flank].gap_curvature(w)).collect();
        Self { w, curvature, z, spaces, alike, values }
    }

    /// D at which the stock of each cell along the face width goes that lies between two heights, at the `i`th length of roll, mm:
    /// [space][cell].
    pub fn reaches(&self, i: usize, [low, high]: [f64; 2]) -> Vec<f64> {
        let reach = |pair: &[f64]| {
            let depth = (0.5 * (pair[0] + pair[1])).clamp(low, high) - low;
            (2.0 * depth / self.curvature[i]).sqrt()
        };
        (0..self.spaces).flat_map(|k| self.column(i, k).windows(2).map(reach)).collect()
    }

    /// a_0 along the face width at the `i`th length of roll of a space.
    pub fn column(&self, i: usize, space: usize) -> &[f64] {
        let k = space.min(self.spaces - 1);
        let from = (i * self.spaces + k) * self.z.len();
        &self.values[from..from + self.z.len()]
    }
}
