//! What is ground at once: flanks and the regions on them.

use super::region::Region;
use crate::FlankLines;
use foundation::geometry::Sides;

/// What is ground at once.
#[derive(Clone, Debug, PartialEq)]
pub struct AreaTask {
    /// The flanks that are ground at once, with their evaluated fields.
    pub lines: Sides<Option<FlankLines>>,
    /// Regions that need worm lines.
    pub regions: Vec<Region>,
    /// Diagonal ratio where no region is ground; 0 allowed.
    pub free_ratio: f64,
}
