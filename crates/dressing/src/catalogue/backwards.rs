//! The search backwards: a dresser is there, and a quantity of the worm is sought with which it makes the target
//! (`docs/mathematics/dressing.md`).

use super::bodies::{CatalogueDresser, CatalogueWorm, DesignedDresser, Workshop};
use super::pair::{Look, Pair, PairFigures, PairLimits, Wanted};
use super::refusal::Refusal;
use foundation::numerics::{equidistant, golden_section};
use rayon::prelude::*;

/// What is free of the worm. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FreeQuantity {
    /// Pitch diameter from, to.
    PitchDiameter([f64; 2]),
    /// Normal profile angle of the left flank from, to; that of the right flank follows from the gear.
    ProfileAngle([f64; 2]),
    /// Number of threads from, to.
    Threads([i32; 2]),
}

/// The dresser on one value of the free quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeValue {
    /// mm, rad or number.
    pub value: f64,
    /// Figures, or why there are none.
    pub figures: Result<PairFigures, Refusal>,
}

impl FreeValue {
    fn is_ok(&self) -> bool {
        self.figures.as_ref().is_ok_and(|f| f.refusal.is_none())
    }

    fn cost(&self) -> f64 {
        match &self.figures {
            Ok(figures) if figures.refusal.is_none() => figures.cost,
            _ => f64::INFINITY,
        }
    }
}

/// Values that make the target without a gap between them.
#[derive(Clone, Debug, PartialEq)]
pub struct WorkingRange {
    /// First value.
    pub from: f64,
    /// Last value.
    pub to: f64,
    /// The value of least cost and its figures.
    pub best: FreeValue,
}

/// The answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Backwards {
    /// The values looked at, ascending.
    pub looked_at: Vec<FreeValue>,
    /// Where the dresser makes the target.
    pub ranges: Vec<WorkingRange>,
}

impl Backwards {
    /// The value of least cost of all.
    pub fn best(&self) -> Option<&FreeValue> {
        self.ranges.iter().map(|r| &r.best).min_by(|a, b| a.cost().total_cmp(&b.cost()))
    }
}

/// The question: with which worm does this dresser make the target?
pub struct BackwardsSearch<'a> {
    /// The rule that puts worms in place.
    pub workshop: &'a dyn Workshop,
    /// What stays of the worm.
    pub worm: &'a CatalogueWorm,
    /// The dresser.
    pub dresser: &'a CatalogueDresser,
    /// Target.
    pub wanted: Wanted,
    /// Limits.
    pub limits: PairLimits,
    /// Whether tip land and undermining are looked at.
    pub collisions: bool,
}

/// Values looked at over an interval.
const VALUES: usize = 33;
/// Halvings at the ends of a range: 1/1024 of the distance of the values.
const HALVINGS: usize = 10;
/// Evaluations around the best value.
const GOLDEN: usize = 16;

impl BackwardsSearch<'_> {
    /// Looks for the ranges and the best value of a quantity.
    ///
    /// # Errors
    /// [`Refusal::Dressing`] for a dresser that is impossible where it was designed.
    pub fn run(&self, free: FreeQuantity) -> Result<Backwards, Refusal> {
        let hand = self.worm.choice.hand.signum();
        let designed = self.dresser.designed(self.workshop, hand)?;
        let values = match free {
            FreeQuantity::PitchDiameter(ends) | FreeQuantity::ProfileAngle(ends) => equidistant(ends, VALUES),
            FreeQuantity::Threads([from, to]) => (from..=to).map(f64::from).collect(),
        };
        let look = |value: f64| self.look(&designed, free, value);
        let looked_at: Vec<FreeValue> = values.par_iter().map(|&value| look(value)).collect();
        let whole = matches!(free, FreeQuantity::Threads(_));
        let mut runs: Vec<(usize, usize)> = Vec::new();
        for (k, _) in looked_at.iter().enumerate().filter(|(_, at)| at.is_ok()) {
            match runs.last_mut() {
                Some((_, last)) if *last + 1 == k => *last = k,
                _ => runs.push((k, k)),
            }
        }
        let ranges = runs
            .into_par_iter()
            .map(|(first, last)| {
                let edge = |good: usize, bad: Option<usize>| match bad.and_then(|k| looked_at.get(k)) {
                    Some(bad) if !whole => narrowed(looked_at[good].value, bad.value, &|x| look(x).is_ok()),
                    _ => looked_at[good].value,
                };
                let (from, to) = (edge(first, first.checked_sub(1)), edge(last, Some(last + 1)));
                let best = (first..=last)
                    .min_by(|&a, &b| looked_at[a].cost().total_cmp(&looked_at[b].cost()))
                    .unwrap_or(first);
                let mut found = looked_at[best].clone();
                if !whole {
                    let low = if best > first { looked_at[best - 1].value } else { from };
                    let high = if best < last { looked_at[best + 1].value } else { to };
                    let finer = look(golden_section(low, high, GOLDEN, |x| look(x).cost()));
                    if finer.cost() < found.cost() {
                        found = finer;
                    }
                }
                WorkingRange { from, to, best: found }
            })
            .collect();
        Ok(Backwards { looked_at, ranges })
    }

    fn look(&self, designed: &DesignedDresser, free: FreeQuantity, value: f64) -> FreeValue {
        let mut worm = CatalogueWorm { smallest: None, ..self.worm.clone() };
        let figures = self.with(&mut worm, free, value).and_then(|()| {
            let pair = Pair {
                workshop: self.workshop,
                worm: &worm,
                dresser: self.dresser,
                designed,
                wanted: &self.wanted,
                limits: &self.limits,
                collisions: self.collisions,
            };
            let seat = pair.seat()?;
            pair.judge(&worm.choice, &seat, None, Look::Allowed)
        });
        FreeValue { value, figures }
    }

    /// Sets the free quantity. A free diameter is the pitch diameter, at which the addendum stays.
    fn with(&self, worm: &mut CatalogueWorm, free: FreeQuantity, value: f64) -> Result<(), Refusal> {
        match free {
            FreeQuantity::PitchDiameter(_) => {
                let now = self.worm.seat(self.workshop, self.dresser.size)?;
                worm.choice = self.worm.worn(&now, value);
            }
            FreeQuantity::ProfileAngle(_) => {
                worm.choice.pressure_angle = Some(value);
                // Both follow from the angle.
                (worm.normal_module, worm.right_angle) = (None, None);
            }
            FreeQuantity::Threads(_) => worm.choice.threads = value as i32,
        }
        Ok(())
    }
}

/// The last good value on the way from `good` to `bad`.
fn narrowed(mut good: f64, mut bad: f64, is_good: &dyn Fn(f64) -> bool) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (good + bad);
        if is_good(middle) { good = middle } else { bad = middle }
    }
    good
}
