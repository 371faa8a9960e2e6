//! The least turn of the second gear until a pair of flanks touches: at every roll position a search over the whole first flank, then a
//! refinement by nested golden sections.

use super::{RollCourse, RolledPair};
use crate::ContactError;
use foundation::numerics::{equidistant, extremes, golden_section};
use rayon::prelude::*;

/// Places of the search over height and length.
const HEIGHTS: usize = 9;
const LENGTHS: usize = 9;
/// Evaluations of the golden sections over height and length: brackets shrink to 1e-6 and 1e-3 of the flank. Across the contact line
/// the gap grows with the square of the distance over some 8 mm, along it with that of a thousandth: 1e-11 mm and 1e-7 mm.
const EVALUATIONS: [usize; 2] = [26, 12];

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
        let along = |length: f64| self.least_across(length, roll);
        let lengths = equidistant(gear.lengths, LENGTHS);
        let found: Vec<f64> = lengths.iter().map(|length| along(*length)).collect();
        let Some(best) = (0..LENGTHS).min_by(|i, j| found[*i].total_cmp(&found[*j])) else {
            return f64::INFINITY;
        };
        if found[best].is_infinite() {
            return f64::INFINITY;
        }
        let bracket = [lengths[best.saturating_sub(1)], lengths[(best + 1).min(LENGTHS - 1)]];
        let length = golden_section(bracket[0], bracket[1], EVALUATIONS[1], along);
        along(length).min(found[best])
    }

    /// The least gap over the heights at a length.
    fn least_across(&self, length: f64, roll: f64) -> f64 {
        let heights = equidistant(self.first().heights, HEIGHTS);
        let mut start = None;
        let mut angle = |height: f64| {
            let gap = self.gap([height, length], roll, start);
            start = gap.map(|gap| gap.partner).or(start);
            gap.map_or(f64::INFINITY, |gap| gap.angle)
        };
        let found: Vec<f64> = heights.iter().map(|height| angle(*height)).collect();
        let Some(best) = (0..HEIGHTS).min_by(|i, j| found[*i].total_cmp(&found[*j])) else {
            return f64::INFINITY;
        };
        if found[best].is_infinite() {
            return f64::INFINITY;
        }
        let bracket = [heights[best.saturating_sub(1)], heights[(best + 1).min(HEIGHTS - 1)]];
        let height = golden_section(bracket[0], bracket[1], EVALUATIONS[0], &mut angle);
        angle(height).min(found[best])
    }
}
