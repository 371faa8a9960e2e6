//! Areas of a flank that want different diagonal ratios, where they lie on the worm, and how many sets of them fit
//! (`docs/mathematics/planning.md#choice-of-the-ratio`). Cylindrical bodies. Must not know targets: a region says only which lines it needs.

mod exclusive;
pub mod extent;
mod feeds;
pub mod occupation;
pub mod plan;
mod polygon;
pub mod region;

pub use exclusive::SharedLines;
pub use extent::WormExtent;
pub use feeds::{FeedInterval, FeedSegment, conflicts, feed_intervals};
pub use occupation::{AreaKind, AreaSet, Occupation, OccupiedPlace, PlaceKind};
pub use plan::{AreaPlan, AreaTask};
pub use region::{Demand, Region};

/// Feeds and positions on the worm closer than this are the same, mm: rounding, far below what an axis resolves.
const SAME_PLACE: f64 = 1e-9;
/// Diagonal ratios closer than this are the same (`docs/mathematics/planning.md#choice-of-the-ratio`).
const SAME_RATIO: f64 = 1e-9;
