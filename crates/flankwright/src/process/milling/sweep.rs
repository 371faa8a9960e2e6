//! A cutter on its way in straight blocks, as machine and referee move it: tip linear, axis linear and made a unit vector; and how
//! low it cuts a line.

use super::meeting::{Line, Profile};
use crate::geometry::CutterShape;
use crate::numerics::least_value;
use nalgebra::Vector3;

/// A path along the columns.
#[derive(Clone, Debug)]
pub(super) struct Sweep {
    profile: Profile,
    /// Lead parameter, ascending, with tip and axis there.
    places: Vec<(f64, Vector3<f64>, Vector3<f64>)>,
}

/// The lowest place on a line that a cutter on its way leaves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lowest {
    /// Distance from the line's point, mm.
    pub length: f64,
    /// Lead parameter, linear within its block.
    pub u: f64,
    /// Lead parameters at the ends of the block.
    pub block: [f64; 2],
}

/// How exactly the lowest place is found along the path, mm: a cutter of radius R there is higher by the square of that over 2 R.
pub(super) const ALONG: f64 = 1e-4;

impl Sweep {
    /// A path of a cutter.
    pub fn new(shape: &CutterShape, places: impl Iterator<Item = (f64, Vector3<f64>, Vector3<f64>)>) -> Self {
        Self { profile: Profile::new(shape), places: places.collect() }
    }

    /// The lowest place of a line that the path leaves, looked for `reach` to both sides of a lead parameter; `None` if the cutter
    /// does not come by.
    pub fn lowest(&self, line: &Line, near: f64, reach: f64) -> Option<Lowest> {
        let last = self.places.len().checked_sub(2)?;
        let block_of = |u: f64| self.places.partition_point(|place| place.0 <= u).saturating_sub(1).min(last);
        let window = [near - reach, near + reach];
        let [from, to] = window.map(block_of);
        let mut start = block_of(near);
        let middle = |block: usize| {
            let [low, high] = self.shares(block, window);
            self.at(line, block, 0.5 * (low + high))
        };
        let mut least = middle(start);
        for block in from..=to {
            let value = middle(block);
            if value < least {
                (start, least) = (block, value);
            }
        }
        let mut best = self.within(line, start, window);
        // Blocks to both sides as long as they go lower.
        let down: Vec<usize> = (from..start).rev().collect();
        for side in [down, (start + 1..=to).collect()] {
            for block in side {
                let found = self.within(line, block, window);
                match (&best, &found) {
                    (Some(best), Some(found)) if found.length >= best.length => break,
                    (Some(_), None) => break,
                    _ => best = found,
                }
            }
        }
        best
    }

    /// The part of a block that lies in a window of the lead parameter, as shares.
    fn shares(&self, block: usize, window: [f64; 2]) -> [f64; 2] {
        let [from, to] = [self.places[block].0, self.places[block + 1].0];
        window.map(|u| ((u - from) / (to - from)).clamp(0.0, 1.0))
    }

    fn within(&self, line: &Line, block: usize, window: [f64; 2]) -> Option<Lowest> {
        let [low, high] = self.shares(block, window);
        let way = (self.places[block + 1].1 - self.places[block].1).norm() * (high - low);
        // A path that stands still is the same everywhere.
        let tolerance = (ALONG / way).min(0.5) * (high - low);
        let (share, length) = least_value([low, high], tolerance, |share| self.at(line, block, share));
        let [from, to] = [self.places[block].0, self.places[block + 1].0];
        length.is_finite().then_some(Lowest { length, u: from + (to - from) * share, block: [from, to] })
    }

    /// Where the cutter at a share of a block meets the line; infinity if it does not.
    fn at(&self, line: &Line, block: usize, share: f64) -> f64 {
        let ((_, tip, axis), (_, next, turned)) = (&self.places[block], &self.places[block + 1]);
        let tip = tip + (next - tip) * share;
        let axis = (axis + (turned - axis) * share).normalize();
        self.profile.meeting(&tip, &axis, line).unwrap_or(f64::INFINITY)
    }
}
