//! The least turn of the second gear until a pair of flanks touches: at every roll position a search over the whole first flank, then a
//! refinement by nested golden sections around every valley; where the first flank deviates from its surface, a walk over all places
//! that may come into question.

use super::{PairGap, RollCourse, RolledPair};
use crate::ContactError;
use foundation::numerics::{equidistant, extremes, golden_section};
use rayon::prelude::*;

/// Places of the search over height and length: a valley that is narrower than two of their steps may be missed.
const HEIGHTS: usize = 11;
const LENGTHS: usize = 17;
/// Evaluations of the golden sections over height and length: brackets shrink to 1e-6 and 1e-3 of the flank. Across the contact line
/// the gap grows with the square of the distance over some 8 mm, along it with that of a thousandth: 1e-11 mm and 1e-7 mm.
const EVALUATIONS: [usize; 2] = [26, 12];
/// Steps of the walk between two rows of what a flank deviates by.
const BETWEEN_ROWS: usize = 2;

/// The least value of a function over places: its own there, and a refinement around each that is lower than both beside it.
fn least_around(
    places: &[f64],
    evaluations: usize,
    found: &[f64],
    mut value: impl FnMut(f64) -> f64,
) -> Option<(f64, f64)> {
    let mut best: Option<(f64, f64)> = None;
    let mut take = |place: f64, value: f64| {
        if value.is_finite() && best.is_none_or(|(_, least)| value < least) {
            best = Some((place, value));
        }
    };
    for k in 0..places.len() {
        let before = if k > 0 { found[k - 1] } else { f64::INFINITY };
        let after = found.get(k + 1).copied().unwrap_or(f64::INFINITY);
        if !found[k].is_finite() || found[k] > before || found[k] > after {
            continue;
        }
        take(places[k], found[k]);
        let bracket = [places[k.saturating_sub(1)], places[(k + 1).min(places.len() - 1)]];
        let place = golden_section(bracket[0], bracket[1], evaluations, &mut value);
        take(place, value(place));
    }
    best
}

impl RolledPair {
    /// The least gap over the roll, `positions` for each pitch of the first gear.
    ///
    /// # Errors
    /// [`ContactError::InvalidNumber`] without positions, [`ContactError::FlanksDoNotMesh`] where the flanks never face each other.
    pub fn roll(&self, positions: usize) -> Result<RollCourse, ContactError> {
        if positions == 0 {
            let allowed = "at least 1 for each pitch";
            return Err(ContactError::InvalidNumber { field: "roll_positions", value: 0.0, allowed });
        }
        let gear = self.first();
        let of_length = |b: f64| move |a: f64| [a, b];
        let places = equidistant(gear.lengths, LENGTHS)
            .into_iter()
            .flat_map(|b| equidistant(gear.heights, HEIGHTS).into_iter().map(of_length(b)));
        let [from, to] = extremes(places.filter_map(|place| self.roll_of(place)));
        if from > to {
            return Err(ContactError::FlanksDoNotMesh { flank: self.flank() });
        }
        let step = self.pitch() / positions as f64;
        // A position before and one after, where only edges come near.
        let count = ((to - from) / step).ceil() as usize + 3;
        let start = from - step;
        let own: Vec<f64> = (0..count).into_par_iter().map(|k| self.least(start + k as f64 * step)).collect();
        if own.iter().all(|angle| angle.is_infinite()) {
            return Err(ContactError::FlanksDoNotMesh { flank: self.flank() });
        }
        Ok(RollCourse::new(start, step, positions, own))
    }

    /// The least gap at a roll, rad; infinite where the flanks do not face each other.
    fn least(&self, roll: f64) -> f64 {
        let gear = self.first();
        let columns = self.deviation().map_or(LENGTHS, |of| LENGTHS.max(of.counts()[1]));
        let lengths = equidistant(gear.lengths, columns);
        let along = |length: f64| self.least_across(length, roll);
        let found: Vec<f64> = lengths.iter().map(|length| along(*length)).collect();
        if self.deviation().is_some() {
            // Linear between its columns: the least is on one of them, but for what the flank is curved between two.
            return found.into_iter().fold(f64::INFINITY, f64::min);
        }
        least_around(&lengths, EVALUATIONS[1], &found, along).map_or(f64::INFINITY, |(_, angle)| angle)
    }

    /// The least gap over the heights at a length.
    fn least_across(&self, length: f64, roll: f64) -> f64 {
        let heights = equidistant(self.first().heights, HEIGHTS);
        let mut start = None;
        let mut angle = |height: f64| {
            let gap = self.surface_gap([height, length], roll, start);
            start = gap.map(|gap| gap.partner).or(start);
            gap.map_or(f64::INFINITY, |gap| gap.angle)
        };
        let found: Vec<f64> = heights.iter().map(|height| angle(*height)).collect();
        let Some((height, least)) = least_around(&heights, EVALUATIONS[0], &found, &mut angle) else {
            return f64::INFINITY;
        };
        if self.deviation().is_some() { self.walk(height, length, roll, start) } else { least }
    }

    /// Over the rows of the deviation and places between them, from the height where the surface alone comes nearest to both sides, as long
    /// as what stands out most there may touch first.
    fn walk(&self, from: f64, length: f64, roll: f64, start: Option<[f64; 2]>) -> f64 {
        let Some(deviation) = self.deviation() else { return f64::INFINITY };
        let [least_beyond, most_beyond] = deviation.range();
        let [root, tip] = self.first().heights;
        let steps = BETWEEN_ROWS * (deviation.counts()[0] - 1);
        let step = (tip - root) / steps as f64;
        let Some(nearest) = self.surface_gap([from, length], roll, start) else { return f64::INFINITY };
        let touching = |gap: &PairGap, height: f64| {
            deviation.at([height, length]).map_or(f64::INFINITY, |beyond| gap.angle - beyond / gap.arm)
        };
        let mut least = touching(&nearest, from);
        let first = ((from - root) / step).floor().clamp(0.0, steps as f64) as usize;
        let mut follow = |rows: &mut dyn Iterator<Item = usize>| {
            let mut partner = Some(nearest.partner);
            for row in rows {
                let height = root + row as f64 * step;
                let Some(gap) = self.surface_gap([height, length], roll, partner) else { break };
                partner = Some(gap.partner);
                // Opened farther than by all that the deviation can differ, nothing touches first.
                if (gap.angle - nearest.angle) * gap.arm > most_beyond - least_beyond {
                    break;
                }
                least = least.min(touching(&gap, height));
            }
        };
        follow(&mut (first + 1..=steps));
        follow(&mut (0..=first).rev());
        least
    }
}
