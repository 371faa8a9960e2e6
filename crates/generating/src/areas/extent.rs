//! What a flank touches on the worm: ranges of z_1 and of the worm lines, segment by segment.

use super::FeedSegment;
use super::polygon::{Corner, clip, range, rectangle};
use crate::FlankLines;

/// Ranges on the worm, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WormExtent {
    /// z_1 from and to.
    pub z_1: [f64; 2],
    /// Worm lines from and to: xi_1 = X_1/cos(rho_1) = z_1 + t_1 w_1.
    pub line: [f64; 2],
}

impl WormExtent {
    /// Where the corners of a polygon are ground in a segment; `None` of no corners.
    pub(super) fn of(corners: &[Corner], lines: &FlankLines, segment: &FeedSegment) -> Option<Self> {
        let shift = segment.shift();
        let points = || {
            corners.iter().map(|&[w, z]| {
                let (w_1, z_1) = lines.worm_point(w, z, &shift);
                [z_1, z_1 + lines.t_1 * w_1]
            })
        };
        Some(Self { z_1: range(points().map(|p| p[0]))?, line: range(points().map(|p| p[1]))? })
    }

    /// The smallest extent that holds both.
    pub(super) fn with(self, other: Self) -> Self {
        let hull = |a: [f64; 2], b: [f64; 2]| [a[0].min(b[0]), a[1].max(b[1])];
        Self { z_1: hull(self.z_1, other.z_1), line: hull(self.line, other.line) }
    }

    /// The same moved along the worm by `distance`, mm.
    pub(super) fn moved(self, distance: f64) -> Self {
        Self { z_1: self.z_1.map(|x| x + distance), line: self.line.map(|x| x + distance) }
    }
}

/// What the flank touches in each segment. The polygon of a segment is the field between its two contact paths; the first and the
/// last segment reach to the ends of the field.
pub(super) fn by_segment(lines: &FlankLines, segments: &[FeedSegment]) -> Vec<Option<WormExtent>> {
    let field = rectangle(lines.roll, lines.face);
    let last = segments.len().saturating_sub(1);
    let part = |k: usize, segment: &FeedSegment| {
        let [from, to] = segment.feed;
        let mut polygon = field.clone();
        if k > 0 {
            polygon = clip(&polygon, |[w, z]| lines.path_feed(w, z) - from);
        }
        if k < last {
            polygon = clip(&polygon, |[w, z]| to - lines.path_feed(w, z));
        }
        WormExtent::of(&polygon, lines, segment)
    };
    segments.iter().enumerate().map(|(k, segment)| part(k, segment)).collect()
}
