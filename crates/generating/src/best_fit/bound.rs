//! How near any flank of the class can come to the target: a lower bound from the dual of a programme, over the diagonal ratios
//! (`docs/mathematics/best-fit.md#a-miss`).

use super::planner::BestFitTask;
use super::programme::Limits;
use super::ratios::{candidates, fits};
use foundation::numerics::golden_section;
use rayon::prelude::*;

/// Evaluations about each of the best ratios of the scan, and how many of these.
const REFINED: usize = 6;
const BEST: usize = 2;
/// Range about a ratio: a neighbour of the scan is a factor of about 1.5 away.
const ABOUT: [f64; 2] = [0.75, 1.33];

/// A lower bound of what every flank of the class leaves, in tolerances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeastExcess {
    /// The ratio at which least is left.
    pub ratio: f64,
    /// What is left there, within every limit.
    pub all: f64,
    /// The same without the limits of the axes.
    pub without_axes: f64,
    /// The same without that of the envelope.
    pub without_envelope: f64,
}

const ALL: Limits = Limits { envelope: true, axes: true };

impl BestFitTask<'_> {
    /// The bound over the ratios that the worm is wide enough for, or at a given one. `None` where no programme can be solved.
    pub fn least(&self, given: Option<f64>, least_determinant: f64) -> Option<LeastExcess> {
        let at = |ratio: f64, limits: Limits| self.least_at(ratio, least_determinant, limits);
        let scan = given.map_or_else(|| candidates(self.setup(), self.which()), |ratio| vec![ratio]);
        let mut found: Vec<(f64, f64)> =
            scan.into_par_iter().map(|ratio| (ratio, at(ratio, ALL).unwrap_or(f64::INFINITY))).collect();
        found.sort_by(|a, b| a.1.total_cmp(&b.1));
        if given.is_none() {
            let best: Vec<f64> = found.iter().take(BEST).map(|found| found.0).filter(|k| *k != 0.0).collect();
            let refined = best.into_par_iter().map(|ratio| {
                let mut least = (ratio, f64::INFINITY);
                let ends = ABOUT.map(|by| by * ratio);
                golden_section(ends[0].min(ends[1]), ends[0].max(ends[1]), REFINED, |ratio| {
                    let wide = fits(self.setup(), self.which(), ratio);
                    let excess = wide.then(|| at(ratio, ALL)).flatten().unwrap_or(f64::INFINITY);
                    if excess < least.1 {
                        least = (ratio, excess);
                    }
                    excess
                });
                least
            });
            let refined: Vec<(f64, f64)> = refined.collect();
            found.extend(refined);
            found.sort_by(|a, b| a.1.total_cmp(&b.1));
        }
        let &(ratio, all) = found.first().filter(|found| found.1.is_finite())?;
        Some(LeastExcess {
            ratio,
            all,
            without_axes: at(ratio, Limits { axes: false, ..ALL })?.min(all),
            without_envelope: at(ratio, Limits { envelope: false, ..ALL })?.min(all),
        })
    }
}
