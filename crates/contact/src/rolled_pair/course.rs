//! How far the second gear is turned over the roll when the flanks just touch: a pair of teeth, and all pairs together.

use foundation::numerics::extremes;

/// Places between two positions at which the peaks are looked for.
const BETWEEN: usize = 16;

/// Turn of the second gear over the roll of the first, rad, > 0: it lags. Between positions it is linear.
#[derive(Clone, Debug, PartialEq)]
pub struct RollCourse {
    start: f64,
    step: f64,
    per_pitch: usize,
    /// Of the pair itself; infinite where the flanks do not face each other.
    own: Vec<f64>,
}

impl RollCourse {
    /// Of a pair that is looked at from `start` in steps of a pitch divided by `per_pitch`.
    pub(super) fn new(start: f64, step: f64, per_pitch: usize, own: Vec<f64>) -> Self {
        Self { start, step, per_pitch, own }
    }

    /// First and last roll of the first gear at which the pair is looked at, rad.
    pub fn range(&self) -> [f64; 2] {
        [self.start, self.start + self.own.len().saturating_sub(1) as f64 * self.step]
    }

    /// Positions for each pitch.
    pub fn per_pitch(&self) -> usize {
        self.per_pitch
    }

    /// Roll from one position to the next, rad.
    pub fn step(&self) -> f64 {
        self.step
    }

    /// Of the pair itself.
    pub fn own(&self) -> &[f64] {
        &self.own
    }

    /// At any roll, the least of the pair and of all pairs before and after it: which of them touches first holds the gears apart.
    /// Infinite if none faces each other.
    pub fn at(&self, roll: f64) -> f64 {
        let count = self.per_pitch as f64;
        let position = ((roll - self.start) / self.step).rem_euclid(count);
        let first = position.floor().min(count - 1.0);
        let share = position - first;
        let first = first as usize;
        // Pair by pair, so that the corner where one hands over to the next stays sharp.
        let mut least = f64::INFINITY;
        for k in (first..self.own.len()).step_by(self.per_pitch) {
            let ends = [self.own[k], self.own.get(k + 1).copied().unwrap_or(f64::INFINITY)];
            if ends.iter().all(|end| end.is_finite()) {
                least = least.min(ends[0] + share * (ends[1] - ends[0]));
            }
        }
        least
    }

    /// Peak to peak of a mesh period, rad: the transmission error of the unloaded pair. Between positions as well, because the greatest
    /// lag is the corner where one pair hands over to the next.
    pub fn peak_to_peak(&self) -> f64 {
        let count = self.per_pitch * BETWEEN;
        let roll = |k: usize| self.start + k as f64 * self.step / BETWEEN as f64;
        let [least, most] = extremes((0..count).map(|k| self.at(roll(k))));
        most - least
    }
}
