//! What fits at the diagonal ratios are expected to cost, and which ratio comes first.

use super::super::{FeedLaw, Prefer};
use super::flank::FlankFit;
use super::planner::BestFitTask;
use super::ratios::{candidates, fits};
use foundation::numerics::golden_section;
use rayon::prelude::*;

/// Evaluations of the golden section about the best ratio.
const GOLDEN: usize = 8;
/// Ratios that are expected to cost no more than this count as equally good.
const EASY: f64 = 0.3;

/// A ratio with what its fit is expected to cost.
#[derive(Clone, Copy, Debug)]
pub struct Expected {
    /// K.
    pub ratio: f64,
    /// 1 is the tolerance or a limit of the envelope.
    pub cost: f64,
}

impl BestFitTask<'_> {
    /// The ratio that is preferred among those expected to be easy, as far as it is found with few of them: costs are taken to fall with |K|
    /// on either side of 0. `None` where no easy one is found, or where accuracy counts alone.
    pub fn easiest(&self, prefer: Prefer) -> Option<Expected> {
        if prefer == Prefer::Accuracy {
            return None;
        }
        let smallest_easy = |sign: f64| {
            let mut ratios: Vec<f64> = candidates(self.setup(), self.which());
            ratios.retain(|ratio| ratio * sign > 0.0);
            ratios.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
            let (mut from, mut to, mut found) = (0, ratios.len(), None);
            while from < to {
                let middle = usize::midpoint(from, to);
                match self.easy(ratios[middle]) {
                    Some(easy) => (found, to) = (Some(easy), middle),
                    None => from = middle + 1,
                }
            }
            found
        };
        self.easy(0.0).or_else(|| {
            let (negative, positive) = rayon::join(|| smallest_easy(-1.0), || smallest_easy(1.0));
            let price = |of: &Expected| self.price(of.ratio, prefer);
            negative.into_iter().chain(positive).min_by(|a, b| price(a).total_cmp(&price(b)))
        })
    }

    /// A ratio if it is expected to be easy: of least squares, or of a programme, neither of which is asked for more than that takes.
    fn easy(&self, ratio: f64) -> Option<Expected> {
        let fits = self.fits(ratio).ok()?;
        let mut cost: f64 = 0.0;
        for (_, fit) in fits.iter() {
            let Some(fit) = fit else { continue };
            let quick = fit.quick_estimate();
            cost = cost.max(if quick <= EASY { quick } else { fit.estimate() });
            if cost > EASY {
                return None;
            }
        }
        Some(Expected { ratio, cost })
    }

    /// Ratios by what their fits are expected to cost, the best first; refined about the best. Among those well within the tolerance the one
    /// that is preferred comes first: the smaller one uses less worm.
    pub fn ratios(&self, prefer: Prefer) -> Vec<Expected> {
        let easy = if prefer == Prefer::Accuracy { 0.0 } else { EASY };
        let price = |ratio: f64| self.price(ratio, prefer);
        // Least squares tell what is easy; a programme need only be solved for what would come before.
        let quick = |ratio: f64| Expected { ratio, cost: self.cost(ratio, |fit| fit.quick_estimate()) };
        let quick: Vec<Expected> =
            candidates(self.setup(), self.which()).into_par_iter().map(quick).collect();
        let sure = quick.iter().filter(|of| of.cost <= easy).map(|of| price(of.ratio));
        let sure = sure.fold(f64::INFINITY, f64::min);
        let expected = |of: Expected| match price(of.ratio) < sure {
            true => Expected { cost: self.cost(of.ratio, |fit| fit.estimate()), ..of },
            false => of,
        };
        let mut tried: Vec<Expected> = quick.into_par_iter().map(expected).collect();
        let order = |a: &Expected, b: &Expected| {
            // Costs within a hundredth are one.
            let class = |of: &Expected| (of.cost.max(easy).ln() / 0.01).round();
            class(a).total_cmp(&class(b)).then(price(a.ratio).total_cmp(&price(b.ratio)))
        };
        tried.sort_by(order);
        if let Some(best) = tried.first().copied().filter(|best| best.ratio != 0.0 && best.cost > EASY) {
            let (a, b) = (0.8 * best.ratio, 1.25 * best.ratio);
            let mut found = Vec::new();
            golden_section(a, b, GOLDEN, |ratio| {
                if !fits(self.setup(), self.which(), ratio) {
                    return f64::INFINITY;
                }
                let cost = self.cost(ratio, |fit| fit.estimate());
                found.push(Expected { ratio, cost });
                cost
            });
            found.sort_by(order);
            tried.extend(found.first());
            tried.sort_by(order);
        }
        tried.retain(|tried| tried.cost.is_finite());
        tried.dedup_by(|a, b| (a.ratio - b.ratio).abs() < 1e-3 * b.ratio.abs());
        tried
    }

    /// What a ratio is expected to cost.
    pub fn expected(&self, ratio: f64) -> Expected {
        Expected { ratio, cost: self.cost(ratio, |fit| fit.estimate()) }
    }

    fn cost(&self, ratio: f64, of_flank: impl Fn(&FlankFit<'_>) -> f64) -> f64 {
        let fits = self.fits(ratio);
        fits.map_or(f64::INFINITY, |fits| {
            fits.iter().filter_map(|(_, fit)| fit.as_ref()).map(|fit| of_flank(fit)).fold(0.0, f64::max)
        })
    }

    /// What tells apart ratios that are equally good.
    fn price(&self, ratio: f64, prefer: Prefer) -> f64 {
        match prefer {
            Prefer::Accuracy | Prefer::Worm => ratio.abs(),
            Prefer::Time => {
                let shift = FeedLaw::Ratio(ratio).law(self.setup(), self.which());
                let [from, to] = self.setup().feed_range(&shift, self.which());
                to - from
            }
        }
    }
}
