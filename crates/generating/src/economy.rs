//! Ratios that cost less: of all that keep to half the tolerance and half the limits of the axes, the one that uses least worm or feeds
//! least (`docs/mathematics/planning.md#what-a-ratio-costs`).

use super::ratio::{Candidate, RatioChoice, RatioReason, Rule};

/// What decides among ratios that keep to half the tolerance.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Prefer {
    /// The rule of least corrections, and the least deviation.
    Accuracy,
    /// The used width of the worm.
    #[default]
    Worm,
    /// The travel of the feed, which is the time of a stroke.
    Time,
}

/// The smallest ratio looked at, as a share of the one chosen by the rule.
const SMALLEST: f64 = 0.02;
/// Halvings between it and the chosen one.
const HALVINGS: usize = 6;
/// Ratios looked at for the travel of the feed.
const LOOKED_AT: i32 = 8;
/// Share of the limits of the axes that a ratio may take to be cheaper.
const AXES: f64 = 0.5;
/// What is not cheaper by this share is not worth another ratio.
const WORTH: f64 = 0.02;

impl Prefer {
    /// What a candidate costs, mm; with `Accuracy` its deviation.
    pub fn cost(self, candidate: &Candidate) -> f64 {
        match self {
            Self::Accuracy => candidate.error,
            Self::Worm => candidate.occupation,
            Self::Time => candidate.feed_travel,
        }
    }
}

impl Rule<'_> {
    /// The choice of a cheaper ratio of the same sign; `None` where the chosen one was named by the target, or none is cheaper.
    pub fn cheaper(&self, prefer: Prefer, choice: &RatioChoice) -> Option<RatioChoice> {
        let free = [RatioReason::LeadCorrection, RatioReason::Compromise, RatioReason::Scan];
        if !free.contains(&choice.reason) {
            return None;
        }
        let known = choice.candidates.iter().find(|c| c.ratio == choice.ratio)?;
        let mut judged = Vec::new();
        let mut allowed = |share: f64| {
            let candidate = self.judge(share * choice.ratio + 0.0, choice.place).ok()?;
            judged.push(candidate.clone());
            (candidate.refusal.is_none() && candidate.score() <= AXES).then_some(candidate)
        };
        let found = match prefer {
            Prefer::Accuracy => None,
            Prefer::Worm => least_allowed(&mut allowed),
            Prefer::Time => {
                let share = |k: i32| SMALLEST.powf(f64::from(k) / f64::from(LOOKED_AT));
                let travel = |a: &Candidate, b: &Candidate| a.feed_travel.total_cmp(&b.feed_travel);
                (1..=LOOKED_AT).filter_map(|k| allowed(share(k))).min_by(travel)
            }
        }?;
        let reason = match prefer {
            Prefer::Time => RatioReason::LeastTravel,
            Prefer::Accuracy | Prefer::Worm => RatioReason::LeastWorm,
        };
        let cheaper = prefer.cost(&found) < (1.0 - WORTH) * prefer.cost(known);
        cheaper.then(|| {
            let candidates = choice.candidates.iter().cloned().chain(judged).collect();
            RatioChoice { ratio: found.ratio, reason, candidates, ..choice.clone() }
        })
    }
}

/// The least share of a ratio that is allowed: corrections grow while it falls.
fn least_allowed(allowed: &mut impl FnMut(f64) -> Option<Candidate>) -> Option<Candidate> {
    if let Some(none) = allowed(0.0).or_else(|| allowed(SMALLEST)) {
        return Some(none);
    }
    let (mut low, mut high, mut found) = (SMALLEST, 1.0, None);
    for _ in 0..HALVINGS {
        let middle = f64::sqrt(low * high);
        match allowed(middle) {
            Some(candidate) => (high, found) = (middle, Some(candidate)),
            None => low = middle,
        }
    }
    found
}
