//! The referee's rays on a flank that rows of a cutter have milled (`docs/mathematics/milling.md#the-referee`).

use super::super::given::Checked;
use super::case::{MilledCase, located};
use foundation::geometry::Cutter;
use foundation::numerics::Silent;
use milling::FlankGrid;
use referee::{CutterPlace, MillPath, Milling, NormalRay, mill};

/// How far outside of the flank material is assumed, and how far below it gouges are looked for, mm.
const STOCK: f64 = 2.0;
const DEPTH: f64 = 2.0;

/// One path for every row, from column to column.
pub(super) fn row_paths(
    grid: &FlankGrid,
    cutter: &Cutter,
    height: impl Fn(usize) -> f64,
    tilt: f64,
) -> Checked<Vec<MillPath>> {
    let mut paths = Vec::with_capacity(grid.rows());
    for row in 0..grid.rows() {
        let mut places = Vec::with_capacity(grid.columns.len());
        for column in &grid.columns {
            let at = located(&column.places[row], &column.lead, cutter, height(row), tilt)?;
            places.push(CutterPlace { tip: at.tip, axis: at.axis });
        }
        paths.push(MillPath { cutter: 0, places });
    }
    Ok(paths)
}

/// Normal rays of the flank at all pairs of these parameters, heights slow.
pub(super) fn rays(case: &MilledCase, heights: &[f64], lengths: &[f64]) -> Vec<NormalRay> {
    let pairs = heights.iter().flat_map(|&a| lengths.iter().map(move |&b| [a, b]));
    let ray = |[a, b]: [f64; 2]| {
        let jet = case.flank.surface.jet(a, b);
        NormalRay { point: jet.point, normal: jet.normal }
    };
    pairs.map(ray).collect()
}

/// What is left on every ray, um.
pub(super) fn left_um(cutter: &Cutter, paths: &[MillPath], rays: &[NormalRay]) -> Checked<Vec<f64>> {
    let setup = Milling { cutters: std::slice::from_ref(cutter), paths, stock: STOCK, depth: DEPTH };
    let lengths = mill(&setup, rays, &Silent)?.lengths()?;
    Ok(lengths.into_iter().map(|length| 1e3 * length).collect())
}

/// Least and greatest of some numbers.
pub(super) fn extremes(values: &[f64]) -> [f64; 2] {
    values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &x| [low.min(x), high.max(x)])
}
