//! Areas of a flank that want different diagonal ratios, where they lie on the worm, and how many sets of them fit
//! (`docs/mathematics/planning.md#choice-of-the-ratio`). Cylindrical bodies. Must not know targets: a region says only which lines it needs.

mod exclusive;
pub mod extent;
mod feeds;
mod interval;
pub mod occupation;
pub mod plan;
mod polygon;
pub mod region;
mod shared_lines;
mod task;

pub use extent::WormExtent;
pub use feeds::{FeedSegment, conflicts, feed_intervals};
pub use interval::FeedInterval;
pub use occupation::{AreaKind, AreaSet, Occupation, OccupiedPlace, PlaceKind};
pub use plan::AreaPlan;
pub use region::{Demand, Region};
pub use shared_lines::SharedLines;
pub use task::AreaTask;

/// Feeds and positions on the worm closer than this are the same, mm: rounding, far below what an axis resolves.
const SAME_PLACE: f64 = 1e-9;
/// Diagonal ratios closer than this are the same (`docs/mathematics/planning.md#choice-of-the-ratio`).
const SAME_RATIO: f64 = 1e-9;
