//! A line of a history.

use super::HistoryRecord;
use super::time::Moment;
use job::Node;
use std::ops::Range;

/// A record with its place.
pub(super) struct Line {
    pub record: HistoryRecord,
    pub moment: Moment,
    pub node: Node,
    /// Where it begins in the file.
    pub start: usize,
}

impl Line {
    /// Place of a key's value in the file.
    pub fn span(&self, path: &str) -> Range<usize> {
        let node = self.node.follow(path).map_or(&self.node, |(node, _)| node);
        moved(&node.span, self.start)
    }
}

/// A span of a line in the file.
pub(super) fn moved(span: &Range<usize>, by: usize) -> Range<usize> {
    span.start + by..span.end + by
}
