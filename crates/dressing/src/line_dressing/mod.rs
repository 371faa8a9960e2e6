//! Dressing line by line with a narrow disc that touches the worm in one point (`docs/mathematics/dressing.md#conditions`): any
//! modification of the worm can be written, along lines of any direction; the price is the number of lines.

mod clearance;
pub mod lines;
pub mod plan;
pub mod tip_disc;
mod touch;

pub use lines::DressingLine;
pub use plan::{LineDressing, LinePlan};
pub use tip_disc::TipDisc;
pub use touch::{RelativeForm, Touch};
