//! What else of the dresser touches the worm: its section swept along the thread, without the condition of contact
//! (`docs/mathematics/dressing.md#limits-of-a-correction`). Knows no wanted profile.

pub mod clearance;
pub(super) mod dresser_pose;
pub mod dresser_section;
pub mod section_outline;
pub(super) mod swept_circle;
pub mod undermining;

pub use clearance::{Clearance, ThreadSpace};
pub use dresser_section::{DresserSection, SectionPart};
pub use section_outline::{SectionOutline, ShownWorm};
pub use undermining::WormFlank;
