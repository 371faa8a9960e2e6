//! From regions to the feed: the interval in which each is ground, conflicts between them, and the segments of constant ratio.

use super::polygon::range;
use super::{AreaTask, FeedInterval, SAME_PLACE, SAME_RATIO};
use crate::GeneratingError;
use foundation::kinematics::MotionLaw;

/// A stretch of the feed with one diagonal ratio: z_V1 = ratio z_V2 + shift_origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FeedSegment {
    /// z_V2 from and to, mm.
    pub feed: [f64; 2],
    /// Diagonal ratio K.
    pub ratio: f64,
    /// z_V01 of the segment, mm.
    pub shift_origin: f64,
    /// Whether a region is ground here; elsewhere the ratio is free.
    pub modified: bool,
}

impl FeedSegment {
    /// The line that the shift follows in this stretch.
    pub fn shift(&self) -> MotionLaw {
        MotionLaw::polynomial(0.0, vec![self.shift_origin, self.ratio])
    }
}

/// The intervals of all regions in the order of their feeds.
///
/// # Errors
/// `InvalidRegion`, `DegenerateDirection`.
pub fn feed_intervals(task: &AreaTask) -> Result<Vec<FeedInterval>, GeneratingError> {
    let mut intervals = Vec::with_capacity(task.regions.len());
    for (index, region) in task.regions.iter().enumerate() {
        let flank = region.flank;
        let Some(lines) = &task.lines[flank] else {
            let reason = "its flank is not ground here";
            return Err(GeneratingError::InvalidRegion { region: index, flank, reason });
        };
        let [direction, ratio] = region.needs(index, lines)?;
        if let Some(feed) = range(region.polygon.iter().map(|&[w, z]| lines.path_feed(w, z))) {
            intervals.push(FeedInterval { region: index, flank, feed, ratio, direction });
        }
    }
    let place = |i: &FeedInterval| (i.feed[0], i.feed[1]);
    intervals.sort_by(|a, b| {
        let ((a0, a1), (b0, b1)) = (place(a), place(b));
        a0.total_cmp(&b0).then(a1.total_cmp(&b1))
    });
    Ok(intervals)
}

/// Pairs of intervals (by their place in the list) that overlap and need different ratios. Touching is allowed.
pub fn conflicts(intervals: &[FeedInterval]) -> Vec<[usize; 2]> {
    let mut pairs = Vec::new();
    for (i, a) in intervals.iter().enumerate() {
        for (j, b) in intervals.iter().enumerate().skip(i + 1) {
            let overlap = a.feed[1].min(b.feed[1]) - a.feed[0].max(b.feed[0]);
            if overlap > SAME_PLACE && (a.ratio - b.ratio).abs() > SAME_RATIO {
                pairs.push([i, j]);
            }
        }
    }
    pairs
}

/// The segments from the first feed of the flanks to the last: regions merged where they agree, the free ratio between them,
/// z_V1 = 0 at the first feed. The intervals are free of conflicts.
pub(super) fn segments(intervals: &[FeedInterval], [from, to]: [f64; 2], free: f64) -> Vec<FeedSegment> {
    let mut parts: Vec<([f64; 2], f64, bool)> = Vec::new();
    for interval in intervals {
        // Corners of a region on a corner of the flank belong to its ends.
        let lo = if interval.feed[0] - from <= SAME_PLACE { from } else { interval.feed[0] };
        let hi = if to - interval.feed[1] <= SAME_PLACE { to } else { interval.feed[1] };
        let reached = parts.last().map_or(from, |part| part.0[1]);
        if lo - reached > SAME_PLACE {
            parts.push(([reached, lo], free, false));
        } else if let Some((feed, ratio, true)) = parts.last_mut() {
            let overlapping = reached - lo > SAME_PLACE;
            if overlapping || (*ratio - interval.ratio).abs() <= SAME_RATIO {
                feed[1] = feed[1].max(hi);
                continue;
            }
        }
        let lo = parts.last().map_or(from, |part| part.0[1]);
        if hi - lo > SAME_PLACE {
            parts.push(([lo, hi], interval.ratio, true));
        }
    }
    let reached = parts.last().map_or(from, |part| part.0[1]);
    if to - reached > SAME_PLACE {
        parts.push(([reached, to], free, false));
    }
    let mut shift = 0.0;
    parts
        .into_iter()
        .map(|(feed, ratio, modified)| {
            let shift_origin = shift - ratio * feed[0];
            shift += ratio * (feed[1] - feed[0]);
            FeedSegment { feed, ratio, shift_origin, modified }
        })
        .collect()
}
