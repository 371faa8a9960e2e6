//! Ratios between those that a scan compares, for a target that all of these miss: near the limits of the bodies a fit may lead somewhere at one
//! ratio and nowhere at its neighbour, which no expectation of the scan tells.

use super::super::best_fit::{BestFitTask, Expected};
use rayon::prelude::*;

/// Ratios that are looked at between two of a scan, and their least distance from one that was carried out, as factors.
const STEP: f64 = 1.2;
const NEW: f64 = 1.1;
/// Ratios that are expected to cost more than this, in tolerances, are not carried out.
const HOPELESS: f64 = 4.0;

/// Ratios beside those that were `tried`, the most promising first; `scanned` are those of the scan.
pub(super) fn between(scan: &BestFitTask<'_>, scanned: &[Expected], tried: &[f64]) -> Vec<f64> {
    let mut looked_at: Vec<f64> = Vec::new();
    for sign in [-1.0, 1.0] {
        let sizes = scanned.iter().map(|of| of.ratio * sign).filter(|size| *size > 0.0);
        let [least, largest] =
            sizes.fold([f64::INFINITY, 0.0], |[low, high], size| [f64::min(low, size), f64::max(high, size)]);
        let mut size = largest;
        while size >= least {
            looked_at.push(sign * size);
            size /= STEP;
        }
    }
    let near = |a: f64, b: f64| a * b > 0.0 && a.abs().max(b.abs()) < NEW * a.abs().min(b.abs());
    looked_at.retain(|ratio| !tried.iter().any(|other| near(*ratio, *other)));
    let mut expected: Vec<Expected> = looked_at.into_par_iter().map(|ratio| scan.expected(ratio)).collect();
    expected.retain(|of| of.cost <= HOPELESS);
    expected.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    expected.into_iter().map(|of| of.ratio).collect()
}
