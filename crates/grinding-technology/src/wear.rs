//! What each place of the worm's width removes: V'_w after some parts (`docs/mathematics/grinding-technology.md#wear-of-the-worm`).

use super::column::in_slices;
use super::cycle::{BENT_CELLS, OnWorm};
use super::{Cycle, STATIONS};
use foundation::geometry::{Flank, Sides};
use foundation::numerics::{equidistant, extremes};
use rayon::prelude::*;

/// Resolution of the removed section over the worm's width, mm: a part of the bins, which are 1 mm wide.
const STEP: f64 = 1.0 / 32.0;
/// Slices of the way on which stock goes: where one cell is the whole face width, and where the face width has many cells.
const SLICES: usize = 48;
const SLICES_OF_MANY: usize = 16;
/// Share of the largest below which a bin is empty: sums of differences leave this much.
const ROUNDING: f64 = 1e-9;

/// V'_w in bins [m, m + 1) mm of the worm's width.
#[derive(Clone, Debug, PartialEq)]
pub struct WearMap {
    /// m of the first bin.
    pub first_bin: i64,
    /// [station][bin], mm^3/mm.
    pub removed: Vec<Vec<f64>>,
}

impl WearMap {
    /// Without the bins at both ends in which no station has a value.
    fn trimmed(mut self) -> Self {
        let least = ROUNDING * self.largest();
        let any = |bin: &usize| self.removed.iter().any(|row| row[*bin] > least);
        let bins = self.removed.first().map_or(0, Vec::len);
        let (first, last) = ((0..bins).find(any), (0..bins).rev().find(any));
        if let (Some(first), Some(last)) = (first, last) {
            self.first_bin += first as i64;
            self.removed.iter_mut().for_each(|row| *row = row[first..=last].to_vec());
        }
        self
    }

    /// V'_w at a station in the bin [m, m + 1), mm^3/mm; 0 in bins that the map leaves out.
    pub fn value(&self, station: usize, m: i64) -> f64 {
        let row = self.removed.get(station);
        let bin = usize::try_from(m - self.first_bin).ok();
        row.zip(bin).and_then(|(row, bin)| row.get(bin)).copied().unwrap_or(0.0)
    }

    /// The first bin and the one behind the last.
    pub fn ends(&self) -> [i64; 2] {
        [self.first_bin, self.first_bin + self.removed.first().map_or(0, Vec::len) as i64]
    }

    /// The largest.
    pub fn largest(&self) -> f64 {
        self.removed.iter().flatten().copied().fold(0.0, f64::max)
    }
}

/// Removed section over the worm's width, accumulated from its lower end; of the first part.
#[derive(Clone, Debug)]
struct Spread {
    from: f64,
    /// At from + k STEP, mm^2 over all spaces' mean.
    accumulated: Vec<f64>,
    step_per_part: f64,
}

/// A histogram of which second differences are collected.
struct Collected {
    from: f64,
    bends: Vec<f64>,
}

impl Collected {
    fn over([from, to]: [f64; 2]) -> Self {
        let from = (from / STEP).floor() * STEP - 2.0 * STEP;
        let cells = ((to - from) / STEP).ceil() as usize + 4;
        Self { from, bends: vec![0.0; cells + 1] }
    }

    /// An amount spread over the sum of two intervals that begin at `at`: evenly over each.
    fn add(&mut self, at: f64, widths: [f64; 2], amount: f64) {
        let mut from = at;
        let [p, q] = widths.map(|width| {
            from += width.min(0.0);
            let held = width.abs().max(STEP);
            from -= 0.5 * (held - width.abs());
            held
        });
        let height = amount / (p * q);
        for (place, by) in [(from, height), (from + p, -height), (from + q, -height), (from + p + q, height)]
        {
            let cell = ((place - self.from) / STEP).max(0.0);
            let k = (cell.floor() as usize).min(self.bends.len() - 2);
            let share = cell - k as f64;
            self.bends[k] += by * (1.0 - share);
            self.bends[k + 1] += by * share;
        }
    }

    fn accumulated(self) -> Vec<f64> {
        let (mut slope, mut density, mut sum) = (0.0, 0.0, 0.0);
        let mut next = |bend: f64| {
            // The slope from here on is what has bent so far.
            let at = sum;
            slope += bend;
            let then = density + slope * STEP;
            sum += 0.5 * STEP * (density + then);
            density = then;
            at
        };
        self.bends.into_iter().map(&mut next).collect()
    }
}

impl Spread {
    fn below(&self, z_1: f64) -> f64 {
        let last = self.accumulated.len() - 1;
        let cell = ((z_1 - self.from) / STEP).clamp(0.0, last as f64);
        let k = (cell.floor() as usize).min(last - 1);
        let share = cell - k as f64;
        self.accumulated[k] * (1.0 - share) + self.accumulated[k + 1] * share
    }

    /// The same of so many parts, each of which stands a step further back.
    fn below_of(&self, z_1: f64, parts: usize) -> f64 {
        let [from, to] = self.range();
        let step = self.step_per_part;
        if step == 0.0 {
            return parts as f64 * self.below(z_1);
        }
        // Parts from `first` up to `behind` stand with a part of theirs below the place, those on one side of them with all, on the other
        // with nothing.
        let at = |place: f64| (((place - z_1) / step).clamp(-1.0, parts as f64 + 1.0)) as i64;
        let (a, b) = (at(from), at(to));
        let count = parts as i64;
        let (first, behind) = ((a.min(b) - 1).clamp(0, count), (a.max(b) + 2).clamp(0, count));
        let whole = if step > 0.0 { count - behind } else { first };
        let total = self.accumulated.last().copied().unwrap_or(0.0);
        let some = (first..behind).map(|part| self.below(z_1 + step * part as f64)).sum::<f64>();
        some + whole as f64 * total
    }

    fn range(&self) -> [f64; 2] {
        [self.from, self.from + STEP * (self.accumulated.len() - 1) as f64]
    }
}

/// Removed sections of all strokes, ready for any number of parts.
pub struct WearTask<'a> {
    cycle: &'a Cycle,
    /// [station][stroke].
    spreads: Sides<Vec<Vec<Spread>>>,
}

impl Cycle {
    /// The load of the worm, station by station.
    pub fn wear(&self) -> WearTask<'_> {
        let of_flank = |flank: Flank| -> Vec<Vec<Spread>> {
            let of_station = |i: usize| -> Vec<Spread> {
                (0..self.strokes.len()).filter_map(|stroke| self.spread(stroke, flank, i)).collect()
            };
            (0..STATIONS).into_par_iter().map(of_station).collect()
        };
        WearTask { cycle: self, spreads: Sides::from_fn(of_flank) }
    }

    /// S of one stroke at a station; `None` where it takes nothing.
    fn spread(&self, stroke: usize, flank: Flank, station: usize) -> Option<Spread> {
        let figures = &self.strokes[stroke];
        let sampled = &self.stations[flank];
        let w = sampled.w[station];
        let curvature = sampled.curvature[station];
        let on_worm = OnWorm::new(&self.bodies, flank, figures, w);
        let cells = sampled.z.len() - 1;
        let reaches = sampled.reaches(station, figures.flanks[flank].between);
        let farthest = reaches.iter().copied().fold(0.0, f64::max);
        if farthest <= 0.0 {
            return None;
        }
        let pieces = if figures.stroke.shift.law.is_affine() { 1 } else { BENT_CELLS.div_ceil(cells) };
        let half = 0.5 * self.bodies.face_width;
        let z = equidistant([-half, half], cells * pieces + 1);
        let slices = if cells == 1 { SLICES } else { SLICES_OF_MANY };
        let slice = farthest / slices as f64;
        // z_1 at the ends of the slices.
        let places =
            |&z: &f64| -> Vec<f64> { (0..=slices).map(|n| on_worm.place(z, slice * n as f64)).collect() };
        let places: Vec<Vec<f64>> = z.iter().map(places).collect();
        let mut collected = Collected::over(extremes(places.iter().flatten().copied()));
        let by = 0.5 * curvature * self.bodies.face_width / (cells * pieces * sampled.spaces) as f64;
        for cell in 0..cells {
            let amounts = in_slices(reaches.iter().skip(cell).step_by(cells).map(|far| far / slice), slices);
            for piece in 0..pieces {
                let [from, to] = [cell * pieces + piece, cell * pieces + piece + 1].map(|k| &places[k]);
                for (n, amount) in amounts.iter().enumerate().filter(|(_, amount)| **amount > 0.0) {
                    let widths = [to[n] - from[n], from[n + 1] - from[n]];
                    collected.add(from[n], widths, by * slice * slice * amount);
                }
            }
        }
        Some(Spread {
            from: collected.from,
            accumulated: collected.accumulated(),
            step_per_part: figures.stroke.shift.step_per_part,
        })
    }
}

impl WearTask<'_> {
    /// V'_w after some parts since dressing.
    pub fn after(&self, parts: usize) -> Sides<WearMap> {
        Sides::from_fn(|flank| {
            let all = || self.spreads[flank].iter().flatten();
            // The worm runs on: a step takes its place on the worm back.
            let reaches = all().flat_map(|spread| {
                let [from, to] = spread.range();
                let back = spread.step_per_part * parts.saturating_sub(1) as f64;
                [from - back.max(0.0), to - back.min(0.0)]
            });
            if all().next().is_none() {
                return WearMap { first_bin: 0, removed: Vec::new() };
            }
            let [low, high] = extremes(reaches).map(|z_1| z_1.floor() as i64);
            let stations = self.cycle.bodies.flanks[flank].stations();
            let row = |(spreads, w): (&Vec<Spread>, f64)| -> Vec<f64> {
                let factor = self.cycle.bodies.flanks[flank].wear_factor(w);
                let below =
                    |edge: i64| spreads.iter().map(|spread| spread.below_of(edge as f64, parts)).sum::<f64>();
                let edges: Vec<f64> = (low..=high + 1).map(below).collect();
                edges.windows(2).map(|ends| factor * (ends[1] - ends[0]).max(0.0)).collect()
            };
            let removed: Vec<Vec<f64>> = self.spreads[flank].iter().zip(stations).map(row).collect();
            WearMap { first_bin: low, removed }.trimmed()
        })
    }

    /// The largest V'_w on either flank after some parts, mm^3/mm.
    pub fn largest_after(&self, parts: usize) -> f64 {
        let maps = self.after(parts);
        maps.left.largest().max(maps.right.largest())
    }
}
