//! A cutter on its way in straight blocks, as machine and referee move it: tip linear, axis linear and made a unit vector; and how
//! low it cuts a line.

use super::meeting::{Line, Profile};
use foundation::geometry::CutterShape;
use foundation::numerics::least_value;
use nalgebra::Vector3;

/// A path along the columns.
#[derive(Clone, Debug)]
pub(super) struct Sweep {
    profile: Profile,
    /// Lead parameter, ascending, with tip and axis there; at least two.
    places: Vec<(f64, Vector3<f64>, Vector3<f64>)>,
    /// How far to both sides of a line's column plane the lowest place is looked for, as a difference of lead parameters.
    reach: f64,
    /// Steps of that search, and what makes no difference to the length.
    step: f64,
    along: f64,
}

/// The lowest place on a line that a cutter on its way leaves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lowest {
    /// Distance from the line's point, mm.
    pub length: f64,
    /// Lead parameter, linear within its block.
    pub u: f64,
}

/// How exactly the lowest place is found along the path, mm: a cutter of radius R there is higher by the square of that over 2 R.
const ALONG: f64 = 1e-4;
/// Steps of the search per radius of the cutter: farther than a radius away it does not meet the line at all.
const STEPS: f64 = 4.0;

impl Sweep {
    /// A path of a cutter; its lowest places are looked for `reach` mm along the path. `None` for fewer than two places.
    pub fn new(
        shape: &CutterShape,
        places: impl Iterator<Item = (f64, Vector3<f64>, Vector3<f64>)>,
        reach: f64,
    ) -> Option<Self> {
        let places: Vec<_> = places.collect();
        let [first, .., last] = places.as_slice() else { return None };
        let speed = (last.1 - first.1).norm() / (last.0 - first.0);
        Some(Self {
            profile: Profile::new(shape),
            reach: reach / speed,
            step: reach.min(shape.radius()) / STEPS / speed,
            along: ALONG / speed,
            places,
        })
    }

    /// The lowest place of a line that the path leaves around the column plane at a lead parameter; `None` if the cutter does not come
    /// by.
    pub fn lowest(&self, line: &Line, near: f64) -> Option<Lowest> {
        let window = self.around(line, near)?;
        let [from, to] = window.map(|u| self.block_of(u));
        let mut start = self.block_of(0.5 * (window[0] + window[1]));
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

    /// A step to both sides of a lead parameter, and within that what makes no difference.
    pub fn steps(&self) -> [f64; 2] {
        [self.step, self.along]
    }

    /// Lead parameters between which the lowest place lies: a step to both sides of the lowest of places a step apart, going down from
    /// the column plane to both sides.
    fn around(&self, line: &Line, near: f64) -> Option<[f64; 2]> {
        let value = |k: i32| {
            let u = near + f64::from(k) * self.step;
            let block = self.block_of(u);
            let [share, _] = self.shares(block, [u, u]);
            self.at(line, block, share)
        };
        let most = (self.reach / self.step).ceil() as i32;
        let start = (0..=most).flat_map(|k| [k, -k]).find(|&k| value(k).is_finite())?;
        // A flat end face goes deepest at one of its edges, before or behind the plane.
        let down = |sense: i32| {
            let (mut place, mut least) = (start, value(start));
            while place.abs() < most {
                let next = value(place + sense);
                if next >= least {
                    break;
                }
                (place, least) = (place + sense, next);
            }
            (place, least)
        };
        let [ahead, behind] = [down(1), down(-1)];
        let place = if behind.1 < ahead.1 { behind.0 } else { ahead.0 };
        let [from, to] = [place - 1, place + 1].map(|k| near + f64::from(k) * self.step);
        Some([from, to])
    }

    /// The block that holds a lead parameter; the first or last one for those beyond the ends.
    fn block_of(&self, u: f64) -> usize {
        self.places.partition_point(|place| place.0 <= u).saturating_sub(1).min(self.places.len() - 2)
    }

    /// The part of a block that lies in a window of the lead parameter, as shares.
    fn shares(&self, block: usize, window: [f64; 2]) -> [f64; 2] {
        let [from, to] = [self.places[block].0, self.places[block + 1].0];
        window.map(|u| ((u - from) / (to - from)).clamp(0.0, 1.0))
    }

    fn within(&self, line: &Line, block: usize, window: [f64; 2]) -> Option<Lowest> {
        let [low, high] = self.shares(block, window);
        let [from, to] = [self.places[block].0, self.places[block + 1].0];
        let tolerance = self.along / (to - from);
        let (share, length) = least_value([low, high], tolerance, |share| self.at(line, block, share));
        length.is_finite().then_some(Lowest { length, u: from + (to - from) * share })
    }

    /// Where the cutter at a share of a block meets the line; infinity if it does not.
    fn at(&self, line: &Line, block: usize, share: f64) -> f64 {
        let ((_, tip, axis), (_, next, turned)) = (&self.places[block], &self.places[block + 1]);
        let tip = tip + (next - tip) * share;
        let axis = (axis + (turned - axis) * share).normalize();
        self.profile.meeting(&tip, &axis, line).unwrap_or(f64::INFINITY)
    }
}
