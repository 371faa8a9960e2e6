//! Over every place of the first flank the least gap of a whole roll, neighbouring pairs included: what marking compound would show.

use super::{RollCourse, RolledPair};
use foundation::geometry::Surface;
use foundation::numerics::{equidistant, golden_section};
use rayon::prelude::*;

/// Places of a flank: a grid over height and length, root to tip and toe to heel.
#[derive(Clone, Debug, PartialEq)]
pub struct FlankPlaces {
    /// Heights, root to tip.
    pub heights: Vec<f64>,
    /// Lengths, toe to heel.
    pub lengths: Vec<f64>,
}

/// Least normal gaps over the places of a flank.
#[derive(Clone, Debug, PartialEq)]
pub struct GapField {
    /// mm, row-major [height][length]; infinite where the other flank never faces the place.
    pub gaps: Vec<f64>,
}

impl FlankPlaces {
    /// All places, row-major [height][length].
    pub fn iter(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        self.heights.iter().flat_map(|a| self.lengths.iter().map(|b| [*a, *b]))
    }

    /// The area that each place stands for, mm², row-major.
    pub fn areas(&self, surface: &dyn Surface) -> Vec<f64> {
        let width =
            |of: &[f64], k: usize| 0.5 * (of[(k + 1).min(of.len() - 1)] - of[k.saturating_sub(1)]).abs();
        let of_place = |(k, [a, b]): (usize, [f64; 2])| {
            let (row, column) = (k / self.lengths.len(), k % self.lengths.len());
            let jet = surface.jet(a, b);
            let cell = width(&self.heights, row) * width(&self.lengths, column);
            jet.by_height.cross(&jet.by_length).norm() * cell
        };
        self.iter().enumerate().map(of_place).collect()
    }
}

/// Roll positions for each pitch among which the nearest is looked for, place by place: the gap has one valley over the roll.
const COARSE: f64 = 6.0;
/// Evaluations of the golden section that follows: the roll to 1e-5 of a pitch, the gap to 1e-8 mm.
const EVALUATIONS: usize = 22;

impl RolledPair {
    /// The least gap at every place, mm, with the gears held apart as the roll has it.
    pub fn field(&self, places: &FlankPlaces, course: &RollCourse) -> GapField {
        let places: Vec<[f64; 2]> = places.iter().collect();
        let [from, to] = course.range();
        let count = (COARSE * (to - from) / self.pitch()).ceil() as usize + 1;
        let rolls = equidistant([from, to], count.max(2));
        GapField { gaps: places.par_iter().map(|place| self.least_over(*place, course, &rolls)).collect() }
    }

    fn least_over(&self, place: [f64; 2], course: &RollCourse, rolls: &[f64]) -> f64 {
        let Some(at) = self.place(place) else { return f64::INFINITY };
        let mut start = None;
        let mut normal = |roll: f64| {
            let Some(gap) = self.gap_at(&at, roll, start) else { return f64::INFINITY };
            start = Some(gap.partner);
            gap.arm * (gap.angle - course.at(roll))
        };
        let found: Vec<(f64, f64)> = rolls.iter().map(|roll| (*roll, normal(*roll))).collect();
        let nearest = (0..found.len()).min_by(|i, j| found[*i].1.total_cmp(&found[*j].1));
        let Some(best) = nearest.filter(|k| found[*k].1.is_finite()) else { return f64::INFINITY };
        let bracket = [found[best.saturating_sub(1)].0, found[(best + 1).min(found.len() - 1)].0];
        let roll = golden_section(bracket[0], bracket[1], EVALUATIONS, &mut normal);
        normal(roll).min(found[best].1)
    }
}
