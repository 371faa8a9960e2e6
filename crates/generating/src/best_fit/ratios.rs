//! Diagonal ratios worth a best fit.

use super::super::{FeedLaw, GrindingSetup};
use foundation::geometry::Flank;

/// Ratios per sign between the smallest and the largest.
const PER_SIGN: usize = 8;
/// The smallest ratio tried beside 0, as a share of the largest.
const SMALLEST: f64 = 0.06;
/// Largest ratio where nothing limits the worm.
const UNLIMITED: f64 = 8.0;

/// Worm width that a ratio needs, mm.
fn needed(setup: &GrindingSetup, which: &[Flank], ratio: f64) -> f64 {
    let shift = FeedLaw::Ratio(ratio).law(setup, which);
    let [from, to] = setup.occupation(&shift, which);
    to - from + 2.0 * setup.run_in()
}

/// Whether the worm is wide enough.
pub fn fits(setup: &GrindingSetup, which: &[Flank], ratio: f64) -> bool {
    setup.input.worm_width.is_none_or(|width| needed(setup, which, ratio) <= width)
}

/// The largest ratio of a sign that the worm is wide enough for; `None` if there is none.
fn largest(setup: &GrindingSetup, which: &[Flank], sign: f64) -> Option<f64> {
    if fits(setup, which, sign * UNLIMITED) {
        return Some(UNLIMITED);
    }
    // Two affine extents, so that width grows with |K| but perhaps near 0: bisection from above.
    let (mut low, mut high) = (0.0, UNLIMITED);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        if fits(setup, which, sign * middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    (low > 1e-3).then_some(low)
}

/// Candidates: 0, those that lay the worm's lines along the profile traces' normal (rho_2 = 0), the largest that the worm is wide enough
/// for, and some between.
pub fn candidates(setup: &GrindingSetup, which: &[Flank]) -> Vec<f64> {
    let mut ratios = vec![0.0];
    for sign in [-1.0, 1.0] {
        let Some(top) = largest(setup, which, sign) else { continue };
        let step = SMALLEST.powf(1.0 / (PER_SIGN - 1) as f64);
        ratios.extend((0..PER_SIGN).map(|k| sign * top * step.powi(k as i32)));
    }
    for &flank in which {
        let level = setup.lines[flank].ratio_of_direction(0.0);
        if level.is_finite() && level != 0.0 && fits(setup, which, level) {
            ratios.push(level);
        }
    }
    ratios
}
