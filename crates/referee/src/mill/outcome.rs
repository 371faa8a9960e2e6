//! What milling leaves on every ray, what it was that cut it, and how much was looked at.

use super::body::CutterPart;
use super::unmilled::Unmilled;
use crate::RemovalError;
use std::ops::Add;

/// A ray that a cutter has shortened.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MilledRay {
    /// lam*: mm along the normal, > 0 stock that is left, < 0 gouge.
    pub length: f64,
    /// Index of the path that set it.
    pub path: usize,
    /// Index of the block in that path; it runs from the place of the same index to the next.
    pub block: usize,
    /// How far the cutter was along that block, 0 to 1.
    pub fraction: f64,
    /// The part of the cutter that did it.
    pub part: CutterPart,
}

/// How much was looked at; does not depend on the number of threads.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MillStatistics {
    /// Rays.
    pub rays: u64,
    /// Blocks of all paths.
    pub blocks: u64,
    /// Bounds of branches of blocks.
    pub bounds: u64,
    /// Pairs of ray and block that no branch ruled out.
    pub searched: u64,
    /// Distances in those pairs.
    pub evaluations: u64,
}

impl Add for MillStatistics {
    type Output = Self;

    /// Sums the counts of two sets of rays; the blocks are common to both.
    fn add(self, other: Self) -> Self {
        Self {
            rays: self.rays + other.rays,
            blocks: self.blocks.max(other.blocks),
            bounds: self.bounds + other.bounds,
            searched: self.searched + other.searched,
            evaluations: self.evaluations + other.evaluations,
        }
    }
}

/// All rays after milling, in the order in which they were given.
#[derive(Clone, Debug, PartialEq)]
pub struct MilledRays {
    /// What is left on every ray.
    pub rays: Vec<Result<MilledRay, Unmilled>>,
    /// Bound of the error of every length, um: nothing cuts lower than a length by more than that. Rounding of coordinates of some
    /// 100 mm is part of it; for a ray that meets the cutter at a flat angle of sine q that share grows as 1/q.
    pub error_um: f64,
    /// How much was looked at.
    pub statistics: MillStatistics,
}

impl MilledRays {
    /// The lengths alone, mm.
    ///
    /// # Errors
    /// [`RemovalError::RayNotMilled`] if a ray has none.
    pub fn lengths(&self) -> Result<Vec<f64>, RemovalError> {
        let missing =
            || self.rays.iter().enumerate().filter_map(|(i, ray)| ray.err().map(|reason| (i, reason)));
        match missing().next() {
            Some((index, reason)) => {
                Err(RemovalError::RayNotMilled { index, reason, count: missing().count() })
            }
            None => Ok(self.rays.iter().filter_map(|ray| ray.ok().map(|ray| ray.length)).collect()),
        }
    }
}
