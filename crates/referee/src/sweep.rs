//! The scan of stage two: every pose of the whole motion against every ray, tiles of rays at a time.
//!
//! The motion has two parameters, the workpiece angle and the feed. Whichever thread the coupling pairs with this tooth
//! space, it appears in one turn of the workpiece; so one turn times the stroke holds every pose there is.

use super::engagement::Engagement;
use super::{RemovalError, Statistics};
use nalgebra::{Matrix3, Vector3};

/// Scan step as a share of the mean length of roll of the rays, in the feed and along the rolling path. The curvatures
/// that press worm and workpiece apart are of the order 1/w, so that w/10 between poses hides dips of about w/800.
const STEP_SHARE: f64 = 0.1;
/// More poses than this belong to a stroke in the wrong unit.
const MOST_POSES: f64 = 4e6;

/// A pose of the scan: workpiece coordinates into worm coordinates.
struct ScanPose {
    rotation: Matrix3<f64>,
    translation: Vector3<f64>,
}

/// All poses of the scan: `turns` workpiece angles for each of `feeds` feeds, the angle fast.
pub(super) struct Sweep {
    poses: Vec<ScanPose>,
    turns: usize,
    feeds: usize,
    first_feed: f64,
    /// Distance of poses in angle (rad) and feed (mm).
    pub step: [f64; 2],
}

/// A pose that may hold a minimum.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidate {
    /// Workpiece angle, rad.
    pub angle: f64,
    /// Feed, mm.
    pub feed: f64,
    /// Deviation of the ray's foot from the worm, mm; close to the length of the ray there.
    pub gap: f64,
}

/// Scratch of one thread: the gap of one ray in every pose, infinite where the worm is not.
pub(super) struct Scratch {
    gaps: Vec<f64>,
    touched: Vec<u32>,
    /// Poses that the bound leaves for the tile in work.
    near: Vec<u32>,
}

impl Sweep {
    /// Poses over one turn and the whole stroke, for rays with the given lengths of roll.
    pub fn new(engagement: &Engagement<'_>, rolls: &[f64]) -> Result<Self, RemovalError> {
        let [from, to] = engagement.setup.feed_range;
        let step = STEP_SHARE * rolls.iter().sum::<f64>() / rolls.len() as f64;
        let turns = (2.0 * std::f64::consts::PI * engagement.setup.work.base_radius / step).ceil().max(16.0);
        let intervals = ((to - from) / step).ceil().max(2.0);
        if turns * intervals > MOST_POSES {
            return Err(RemovalError::InvalidNumber {
                field: "feed range z_V2",
                value: to - from,
                allowed: "a length of the order of the face width",
            });
        }
        let step = [2.0 * std::f64::consts::PI / turns, (to - from) / intervals];
        let (turns, feeds) = (turns as usize, intervals as usize + 1);
        let mut poses = Vec::with_capacity(turns * feeds);
        for j in 0..feeds {
            for i in 0..turns {
                let pose = engagement.pose(step[0] * i as f64, from + step[1] * j as f64);
                poses.push(ScanPose { rotation: *pose.rotation(), translation: *pose.translation() });
            }
        }
        Ok(Self { poses, turns, feeds, first_feed: from, step })
    }

    /// Number of poses.
    pub fn count(&self) -> usize {
        self.poses.len()
    }

    /// Scratch for one thread.
    pub fn scratch(&self) -> Scratch {
        Scratch { gaps: vec![f64::INFINITY; self.count()], touched: Vec::new(), near: Vec::new() }
    }

    /// Largest dip that the scan may hide on a ray with length of roll w, mm: twice the square of half a step over 2 w,
    /// at most a quarter of the normal base pitch, so that together with the stock it stays with one thread.
    pub fn hidden_dip(&self, w: f64, normal_base_pitch: f64) -> f64 {
        (self.step[1] * self.step[1] / (4.0 * w)).min(0.25 * normal_base_pitch)
    }

    /// Keeps the poses in which a ball can touch the worm's area at all: the ball holds the feet of the tile's rays and
    /// beyond them the largest gap that makes a candidate.
    pub fn select(
        &self,
        engagement: &Engagement<'_>,
        centre: &Vector3<f64>,
        margin: f64,
        rays: usize,
        scratch: &mut Scratch,
        statistics: &mut Statistics,
    ) {
        let (worm, area) = (engagement.setup.worm, &engagement.area);
        let inner = worm.radius(area.w[0]) - margin;
        let outer = (worm.radius(area.w[1]) + margin).powi(2);
        let inner = inner.max(0.0).powi(2);
        let [low, high] = [area.z[0] - margin, area.z[1] + margin];
        scratch.near.clear();
        scratch.near.extend((0u32..).zip(&self.poses).filter_map(|(k, pose)| {
            let p = pose.rotation * centre + pose.translation;
            let square = p.x * p.x + p.y * p.y;
            (square <= outer && square >= inner && p.z >= low && p.z <= high).then_some(k)
        }));
        statistics.tested += (scratch.near.len() * rays) as u64;
        statistics.pruned += ((self.count() - scratch.near.len()) * rays) as u64;
    }

    /// The dips of one ray's gap over the selected poses that are shallow enough to hold the cut, deepest first.
    pub fn candidates(
        &self,
        engagement: &Engagement<'_>,
        foot: &Vector3<f64>,
        reach: f64,
        scratch: &mut Scratch,
        found: &mut Vec<Candidate>,
    ) {
        for &k in &scratch.near {
            let pose = &self.poses[k as usize];
            if let Some(gap) = engagement.gap(&(pose.rotation * foot + pose.translation)) {
                scratch.gaps[k as usize] = gap;
                scratch.touched.push(k);
            }
        }
        found.clear();
        for &k in &scratch.touched {
            let gap = scratch.gaps[k as usize];
            if gap.abs() <= reach && self.is_dip(&scratch.gaps, k as usize) {
                let (j, i) = (k as usize / self.turns, k as usize % self.turns);
                found.push(Candidate {
                    angle: self.step[0] * i as f64,
                    feed: self.first_feed + self.step[1] * j as f64,
                    gap,
                });
            }
        }
        for k in scratch.touched.drain(..) {
            scratch.gaps[k as usize] = f64::INFINITY;
        }
        found.sort_by(|a, b| a.gap.total_cmp(&b.gap));
    }

    /// Whether no neighbour in angle (round the turn) and feed lies lower.
    fn is_dip(&self, gaps: &[f64], k: usize) -> bool {
        let (j, i) = (k / self.turns, k % self.turns);
        let columns = [(i + self.turns - 1) % self.turns, i, (i + 1) % self.turns];
        (j.saturating_sub(1)..=(j + 1).min(self.feeds - 1))
            .flat_map(|row| columns.map(|column| row * self.turns + column))
            .all(|other| gaps[k] <= gaps[other])
    }
}
