//! A worm from new to used up under one dresser: what is left on it without corrections, corrections, stretch, and down to which
//! diameter the target is still made. Knows no ranking.

use super::pair::{Look, Pair, PairFigures};
use super::refusal::Refusal;
use crate::WormSeat;
use foundation::geometry::Sides;
use foundation::numerics::equidistant;

/// One diameter in the life of a worm. mm, rad.
#[derive(Clone, Debug, PartialEq)]
pub struct LifeRow {
    /// Pitch diameter of the worm.
    pub pitch_diameter: f64,
    /// Profile crowning of the gear without corrections of crossing angle and offset, transverse, per flank that is ground;
    /// absent where that cannot be dressed.
    pub uncorrected: Option<Sides<Option<f64>>>,
    /// Corrections, stretch and what they miss, or why there are none.
    pub figures: Result<PairFigures, Refusal>,
}

impl LifeRow {
    /// Why the target is not made at this diameter, if so.
    pub fn refusal(&self) -> Option<&Refusal> {
        match &self.figures {
            Ok(figures) => figures.refusal.as_ref(),
            Err(refusal) => Some(refusal),
        }
    }
}

/// How long a worm serves. mm.
#[derive(Clone, Debug, PartialEq)]
pub struct RemainingLife {
    /// Current pitch diameter.
    pub from: f64,
    /// Smallest pitch diameter at which the target is still made.
    pub to: f64,
    /// What ends it; `None` where the worm is used up first.
    pub end: Option<Refusal>,
}

/// Diameters below the current one at which a remaining life is looked for before its end is narrowed down.
const MARCH: usize = 5;
/// Halvings of the interval in which a life ends: 1/256 of a step of the march.
const HALVINGS: usize = 8;

impl Pair<'_> {
    /// The whole life in `rows` diameters from now to the smallest (at least 2; one row where the worm does not shrink).
    ///
    /// # Errors
    /// [`Refusal::Dressing`] for a worm that is impossible as it is now or has no usable smallest diameter.
    pub fn life(&self, rows: usize) -> Result<Vec<LifeRow>, Refusal> {
        let now = self.seat()?;
        let smallest = self.worm.smallest_pitch_diameter(&now)?;
        let from = 2.0 * now.reference_radius();
        let diameters = if smallest < from { equidistant([from, smallest], rows.max(2)) } else { vec![from] };
        let mut last: Option<PairFigures> = None;
        let row = |pitch_diameter: f64| {
            let figures = self.at(&now, pitch_diameter, last.as_ref(), Look::Whole);
            last = figures.as_ref().ok().cloned();
            let seat = self.worn_seat(&now, pitch_diameter);
            let uncorrected = seat.and_then(|seat| self.uncorrected(&seat)).ok();
            LifeRow { pitch_diameter, uncorrected, figures }
        };
        Ok(diameters.into_iter().map(row).collect())
    }

    /// Down to which diameter the pair makes the target, for a pair that makes it now.
    ///
    /// The march down ends at the first diameter that is refused: what lies beyond cannot be reached with one dresser.
    ///
    /// # Errors
    /// As [`Pair::life`].
    pub fn remaining_life(&self, now: &WormSeat, figures: &PairFigures) -> Result<RemainingLife, Refusal> {
        let smallest = self.worm.smallest_pitch_diameter(now)?;
        let from = 2.0 * now.reference_radius();
        let (mut good, mut last) = (from, figures.clone());
        let mut end = None;
        if smallest < from {
            for diameter in equidistant([from, smallest], MARCH + 1).into_iter().skip(1) {
                match self.allowed_at(now, diameter, &last) {
                    Ok(figures) => (good, last) = (diameter, figures),
                    Err(refusal) => {
                        end = Some((diameter, refusal));
                        break;
                    }
                }
            }
        }
        let mut end = end.map(|(mut bad, mut refusal)| {
            for _ in 0..HALVINGS {
                let middle = 0.5 * (good + bad);
                match self.allowed_at(now, middle, &last) {
                    Ok(figures) => (good, last) = (middle, figures),
                    Err(here) => (bad, refusal) = (middle, here),
                }
            }
            refusal
        });
        if self.collisions
            && good < from
            && let Err(mut refusal) = self.spared(now, figures, good)
        {
            let mut bad = good;
            good = from;
            for _ in 0..HALVINGS {
                let middle = 0.5 * (good + bad);
                match self.spared(now, figures, middle) {
                    Ok(()) => good = middle,
                    Err(here) => (bad, refusal) = (middle, here),
                }
            }
            end = Some(refusal);
        }
        Ok(RemainingLife { from, to: good, end })
    }

    /// Whether dressing at the current diameter leaves the worn worm of a smaller diameter untouched.
    fn spared(&self, now: &WormSeat, figures: &PairFigures, pitch_diameter: f64) -> Result<(), Refusal> {
        let later = self.worn_seat(now, pitch_diameter)?;
        self.check_undermining(now, figures, &later)
    }

    fn at(
        &self,
        now: &WormSeat,
        pitch_diameter: f64,
        start: Option<&PairFigures>,
        look: Look,
    ) -> Result<PairFigures, Refusal> {
        let seat = self.worn_seat(now, pitch_diameter)?;
        self.judge(&self.worm.worn(now, pitch_diameter), &seat, start, look)
    }

    fn allowed_at(
        &self,
        now: &WormSeat,
        pitch_diameter: f64,
        start: &PairFigures,
    ) -> Result<PairFigures, Refusal> {
        let mut figures = self.at(now, pitch_diameter, Some(start), Look::Allowed)?;
        match figures.refusal.take() {
            Some(refusal) => Err(refusal),
            None => Ok(figures),
        }
    }
}
