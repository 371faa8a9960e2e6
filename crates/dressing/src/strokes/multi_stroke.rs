//! A profile dressed in several strokes, each with its own part of a dresser and its own correction: the least f of all strokes
//! that reach a point, else stock (`docs/mathematics/dressing.md`). Knows no motion along the worm.

use crate::strokes::stroke::check_range;
use crate::{DressedStroke, DressingError, ProfilePoint, Stroke};
use foundation::geometry::Flank;
use foundation::kinematics::DressingCorrection;
use rayon::prelude::*;

/// Strokes of one worm flank at constant corrections.
#[derive(Clone, Debug)]
pub struct MultiStroke {
    flank: Flank,
    strokes: Vec<DressedStroke>,
}

/// A point of a profile and the stroke that finishes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrokePoint {
    /// Number of the stroke, from 0.
    pub stroke: usize,
    /// What it dresses there.
    pub point: ProfilePoint,
}

/// Lengths of roll that differ by less are the same, mm.
pub(crate) const ROUNDING: f64 = 1e-9;

impl MultiStroke {
    /// Solves every stroke for the wanted f(w) (mm normal) at both ends and in the middle of its range.
    ///
    /// # Errors
    /// [`DressingError::InvalidNumber`] without strokes; those of [`Stroke::solve`] and [`Stroke::at`] of the first stroke that fails.
    pub fn solve(
        strokes: &[Stroke<'_>],
        flank: Flank,
        reference_radius: f64,
        wanted: &(dyn Fn(f64) -> f64 + Sync),
    ) -> Result<Self, DressingError> {
        let solved = strokes.par_iter().map(|stroke| {
            let [a, b] = stroke.range;
            let f = [a, 0.5 * (a + b), b].map(wanted);
            stroke.at(flank, stroke.solve(flank, reference_radius, f, &[0.0; 4])?)
        });
        // The first of the strokes that fail is named, on any number of threads.
        Self::of(flank, solved.collect::<Vec<_>>().into_iter().collect::<Result<_, _>>()?)
    }

    /// The strokes at given corrections, one each.
    ///
    /// # Errors
    /// [`DressingError::InvalidNumber`] without strokes or for another number of corrections; those of [`Stroke::at`].
    pub fn at(
        strokes: &[Stroke<'_>],
        flank: Flank,
        corrections: &[DressingCorrection],
    ) -> Result<Self, DressingError> {
        if corrections.len() != strokes.len() {
            return Err(DressingError::InvalidNumber {
                field: "number of corrections",
                value: corrections.len() as f64,
                allowed: "one for each stroke",
            });
        }
        let made = strokes.iter().zip(corrections).map(|(stroke, &dk)| stroke.at(flank, dk));
        Self::of(flank, made.collect::<Result<_, _>>()?)
    }

    fn of(flank: Flank, strokes: Vec<DressedStroke>) -> Result<Self, DressingError> {
        at_least_one(strokes.len())?;
        Ok(Self { flank, strokes })
    }

    /// The strokes in the order in which they were given.
    pub fn strokes(&self) -> &[DressedStroke] {
        &self.strokes
    }

    /// Refuses a profile on which stock is left within `range` (lengths of roll, mm).
    ///
    /// # Errors
    /// [`DressingError::Gap`] with the first part that no stroke reaches and the strokes beside it; [`DressingError::InvalidNumber`] for
    /// the range.
    pub fn check_cover(&self, range: [f64; 2]) -> Result<(), DressingError> {
        check_range(range)?;
        let covered: Vec<[f64; 2]> = self.strokes.iter().map(|s| s.covers).collect();
        first_gap(&covered, range).map_or(Ok(()), |gap| Err(gap.error(self.flank, None)))
    }

    /// The finished profile at length of roll w, mm.
    ///
    /// # Errors
    /// [`DressingError::Gap`] where no stroke reaches; those of [`crate::DressedProfile::at_roll`].
    pub fn at_roll(&self, w: f64) -> Result<StrokePoint, DressingError> {
        let mut least: Option<StrokePoint> = None;
        for (stroke, dressed) in self.strokes.iter().enumerate() {
            let [from, to] = dressed.covers;
            if w < from - ROUNDING || w > to + ROUNDING {
                continue;
            }
            let point = dressed.profile().at_roll(w)?;
            if least.is_none_or(|other| point.f < other.point.f) {
                least = Some(StrokePoint { stroke, point });
            }
        }
        least.ok_or_else(|| {
            let covered: Vec<[f64; 2]> = self.strokes.iter().map(|s| s.covers).collect();
            Gap::around(&covered, w).error(self.flank, None)
        })
    }

    /// The finished profile at several lengths of roll, mm.
    ///
    /// # Errors
    /// As [`MultiStroke::at_roll`].
    pub fn at_rolls(&self, w: &[f64]) -> Result<Vec<StrokePoint>, DressingError> {
        w.iter().map(|&w| self.at_roll(w)).collect()
    }
}

/// # Errors
/// [`DressingError::InvalidNumber`] for no strokes.
pub(crate) fn at_least_one(strokes: usize) -> Result<(), DressingError> {
    if strokes > 0 {
        return Ok(());
    }
    Err(DressingError::InvalidNumber { field: "number of strokes", value: 0.0, allowed: "at least 1" })
}

/// A range that no stroke reaches and the strokes before and behind it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Gap {
    pub range: [f64; 2],
    pub beside: [Option<usize>; 2],
}

impl Gap {
    /// The gap in which w lies.
    pub fn around(covered: &[[f64; 2]], w: f64) -> Self {
        // A stroke that covers nothing is no neighbour.
        let below = covered.iter().enumerate().filter(|(_, c)| c[1] < w && c[0] <= c[1]);
        let below = below.max_by(|a, b| a.1[1].total_cmp(&b.1[1]));
        let above = covered.iter().enumerate().filter(|(_, c)| c[0] > w && c[0] <= c[1]);
        let above = above.min_by(|a, b| a.1[0].total_cmp(&b.1[0]));
        Self {
            range: [below.map_or(w, |(_, c)| c[1]), above.map_or(w, |(_, c)| c[0])],
            beside: [below.map(|(k, _)| k), above.map(|(k, _)| k)],
        }
    }

    pub fn error(self, flank: Flank, b: Option<f64>) -> DressingError {
        let [from, to] = self.range;
        DressingError::Gap { flank, from, to, beside: self.beside, b }
    }
}

/// The first part of `range` that none of the covered ranges reaches.
pub(crate) fn first_gap(covered: &[[f64; 2]], range: [f64; 2]) -> Option<Gap> {
    let mut order: Vec<usize> = (0..covered.len()).collect();
    order.sort_by(|&a, &b| covered[a][0].total_cmp(&covered[b][0]));
    let (mut reach, mut last) = (range[0], None);
    for k in order {
        let [from, to] = covered[k];
        if to < range[0] {
            continue;
        }
        if from > reach + ROUNDING || reach >= range[1] - ROUNDING {
            let next = (from <= range[1]).then_some(k);
            return (reach < range[1] - ROUNDING)
                .then_some(Gap { range: [reach, from.min(range[1])], beside: [last, next] });
        }
        if to > reach {
            (reach, last) = (to, Some(k));
        }
    }
    (reach < range[1] - ROUNDING).then_some(Gap { range: [reach, range[1]], beside: [last, None] })
}
