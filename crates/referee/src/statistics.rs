//! How much a stage has looked at: counts that do not depend on the number of threads.

use std::ops::Add;

/// Counts of one stage. A pose is one instant of the motion; a pair is one ray in one pose.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Statistics {
    /// Rays, check rays included.
    pub rays: u64,
    /// Poses of the scan over the whole motion.
    pub poses: u64,
    /// Pairs of the scan that were ruled out for a whole tile of rays by a bound.
    pub pruned: u64,
    /// Pairs of the scan that were tested one by one.
    pub tested: u64,
    /// Exact lengths with derivatives, in poses of their own.
    pub exact: u64,
    /// Hits dropped because they lie further than 0.45 axial pitches from the contact (next groove, back of the disc).
    pub foreign: u64,
}

impl Statistics {
    /// Pairs of ray and pose that the scan decided.
    pub fn pairs(&self) -> u64 {
        self.pruned + self.tested
    }
}

impl Add for Statistics {
    type Output = Self;

    /// Sums the counts of two parts of one stage; the poses of the scan are common to the parts.
    fn add(self, other: Self) -> Self {
        Self {
            rays: self.rays + other.rays,
            poses: self.poses.max(other.poses),
            pruned: self.pruned + other.pruned,
            tested: self.tested + other.tested,
            exact: self.exact + other.exact,
            foreign: self.foreign + other.foreign,
        }
    }
}
