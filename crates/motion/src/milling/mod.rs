//! Five-axis milling on a machine (`docs/mathematics/milling.md#positions-of-five-axes`): places of a cutter become positions of the axes,
//! with one solution of the two and one turn chosen along the path; the pole, the time of blocks, straight blocks without RTCP and the
//! smoothness of a row. Knows places of cutters, no flank and no text of a control.

mod choice;
mod feed;
mod place;
mod pole;
mod smoothness;
mod straight;
mod tilt;

pub use choice::{AxisCourse, PoleStrategy, choose};
pub use feed::{BlockLimit, BlockTime, SectionFeed, block_time, block_times, section_feeds};
pub use place::{CutterPlace, MillingSetup};
pub use pole::{DEFAULT_CAP, PolePassage, pole_passages};
pub use smoothness::{Change, RowSmoothness, contact_arcs, leans, smoothness, smoothness_along};
pub use straight::{Refined, StraightError, StraightRun, refine, straight_error, straight_runs};
pub use tilt::{TiltedMount, tilt_mount};
