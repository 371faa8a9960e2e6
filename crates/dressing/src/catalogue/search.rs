//! All worms of a catalogue with all dressers for one target: who makes it, ranked (`docs/mathematics/dressing.md`). Refused pairs stay in
//! the list with their reason.

use super::bodies::{CatalogueDresser, CatalogueWorm, DesignedDresser, Workshop};
use super::life::RemainingLife;
use super::pair::{Look, Pair, PairFigures, PairLimits, Wanted};
use super::refusal::Refusal;
use crate::DressingError;
use foundation::numerics::Progress;
use rayon::prelude::*;
use std::cmp::Ordering;

/// The question: which pair makes the target?
pub struct CatalogueSearch<'a> {
    /// The rule that puts worms in place.
    pub workshop: &'a dyn Workshop,
    /// Worms.
    pub worms: &'a [CatalogueWorm],
    /// Dressers.
    pub dressers: &'a [CatalogueDresser],
    /// Target.
    pub wanted: Wanted,
    /// Limits.
    pub limits: PairLimits,
    /// Whether the tip land is looked at and, with the life, undermining.
    pub collisions: bool,
    /// Whether the remaining life of the worm is sought for pairs that make the target.
    pub life: bool,
}

/// One pair and its verdict.
#[derive(Clone, Debug, PartialEq)]
pub struct RankedPair {
    /// Place of the worm in its list.
    pub worm: usize,
    /// Place of the dresser in its list.
    pub dresser: usize,
    /// Figures on the worm as it is now; absent where it cannot be dressed to the target.
    pub figures: Option<PairFigures>,
    /// Remaining life, if it was sought and the pair makes the target.
    pub life: Option<RemainingLife>,
    /// Why the pair does not make the target, if so.
    pub refusal: Option<Refusal>,
}

impl RankedPair {
    /// Whether the pair makes the target within all limits.
    pub fn is_ok(&self) -> bool {
        self.refusal.is_none()
    }

    /// max |DK_j/limit_j|.
    pub fn cost(&self) -> Option<f64> {
        self.figures.as_ref().map(|f| f.cost)
    }

    /// Those that make the target first, then by cost; what has no figures last.
    fn compare(&self, other: &Self) -> Ordering {
        let cost = |pair: &Self| pair.cost().unwrap_or(f64::INFINITY);
        other.is_ok().cmp(&self.is_ok()).then(cost(self).total_cmp(&cost(other)))
    }
}

impl CatalogueSearch<'_> {
    /// Judges every pair; the best first, equal ones in the order of the lists.
    ///
    /// The result does not depend on the number of threads.
    pub fn run(&self, progress: &dyn Progress) -> Vec<RankedPair> {
        let hands = [-1.0, 1.0];
        // A dresser is designed once for each hand that the worms have.
        let designed: Vec<[Option<Result<DesignedDresser, DressingError>>; 2]> = self
            .dressers
            .par_iter()
            .map(|dresser| {
                hands.map(|hand| {
                    let wanted = self.worms.iter().any(|w| w.choice.hand.signum() == hand);
                    wanted.then(|| dresser.designed(self.workshop, hand))
                })
            })
            .collect();
        progress.start("pairs", (self.worms.len() * self.dressers.len()) as u64);
        let places: Vec<(usize, usize)> =
            (0..self.worms.len()).flat_map(|w| (0..self.dressers.len()).map(move |d| (w, d))).collect();
        let mut pairs: Vec<RankedPair> = places
            .into_par_iter()
            .map(|(w, d)| {
                let hand = usize::from(self.worms[w].choice.hand > 0.0);
                let pair = match &designed[d][hand] {
                    Some(Ok(tool)) => self.pair(w, d, tool),
                    Some(Err(error)) => refused(w, d, Refusal::Dressing(error.clone())),
                    None => unreachable_hand(w, d, self.worms[w].choice.hand),
                };
                progress.advance(1);
                pair
            })
            .collect();
        progress.finish();
        pairs.sort_by(RankedPair::compare);
        pairs
    }

    /// The pair of these places in the lists, ready to be judged.
    pub fn of<'b>(&'b self, worm: usize, dresser: usize, designed: &'b DesignedDresser) -> Pair<'b> {
        Pair {
            workshop: self.workshop,
            worm: &self.worms[worm],
            dresser: &self.dressers[dresser],
            designed,
            wanted: &self.wanted,
            limits: &self.limits,
            collisions: self.collisions,
        }
    }

    fn pair(&self, w: usize, d: usize, designed: &DesignedDresser) -> RankedPair {
        let pair = self.of(w, d, designed);
        let judged = pair.seat().map_err(Refusal::from).and_then(|seat| {
            let figures = pair.judge(&self.worms[w].choice, &seat, None, Look::Whole)?;
            Ok((seat, figures))
        });
        let (seat, figures) = match judged {
            Ok(judged) => judged,
            Err(refusal) => return refused(w, d, refusal),
        };
        let mut refusal = figures.refusal.clone();
        let life = match (&refusal, self.life) {
            (None, true) => match pair.remaining_life(&seat, &figures) {
                // Where no smaller diameter stays untouched, dressing now ruins the worm.
                Ok(RemainingLife { from, to, end: Some(reason @ Refusal::Undermined { .. }) })
                    if to >= from =>
                {
                    refusal = Some(reason);
                    None
                }
                Ok(life) => Some(life),
                Err(reason) => {
                    refusal = Some(reason);
                    None
                }
            },
            _ => None,
        };
        RankedPair { worm: w, dresser: d, figures: Some(figures), life, refusal }
    }
}

fn refused(worm: usize, dresser: usize, refusal: Refusal) -> RankedPair {
    RankedPair { worm, dresser, figures: None, life: None, refusal: Some(refusal) }
}

/// A hand that is neither left nor right.
fn unreachable_hand(worm: usize, dresser: usize, hand: f64) -> RankedPair {
    let error = DressingError::InvalidNumber { field: "hand of the worm", value: hand, allowed: "+1 or -1" };
    refused(worm, dresser, Refusal::Dressing(error))
}
