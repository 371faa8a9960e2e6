//! Worm lines that carry a modification may touch the flank in their own segment only.

use super::{AreaTask, FeedInterval, FeedSegment, SharedLines, WormExtent};
use foundation::geometry::Sides;

/// Lines may be shared over this length: rounding of corners that touch, mm (`docs/mathematics/planning.md#choice-of-the-ratio`).
const SHARED: f64 = 1e-7;

/// Extent of every region on the worm (in the order of the intervals) and the lines they share with other segments.
pub(super) fn regions_on_worm(
    task: &AreaTask,
    intervals: &[FeedInterval],
    segments: &[FeedSegment],
    touched: &Sides<Vec<Option<WormExtent>>>,
) -> (Vec<WormExtent>, Vec<SharedLines>) {
    let (mut extents, mut shared) = (Vec::new(), Vec::new());
    for interval in intervals {
        let middle = 0.5 * (interval.feed[0] + interval.feed[1]);
        let own = segments.iter().position(|s| middle <= s.feed[1]).unwrap_or(segments.len() - 1);
        let polygon = &task.regions[interval.region].polygon;
        let extent = task.lines[interval.flank]
            .as_ref()
            .and_then(|lines| WormExtent::of(polygon, lines, &segments[own]));
        let Some(extent) = extent else { continue };
        for (k, other) in touched[interval.flank].iter().enumerate() {
            let Some(other) = other.filter(|_| k != own) else { continue };
            let overlap = extent.line[1].min(other.line[1]) - extent.line[0].max(other.line[0]);
            if overlap > SHARED {
                shared.push(SharedLines {
                    flank: interval.flank,
                    region: interval.region,
                    feed: interval.feed,
                    segment: segments[k].feed,
                    overlap,
                });
            }
        }
        extents.push(extent);
    }
    (extents, shared)
}
