//! The section of a report on gearbox and servo: what they cost at the flank, over the stroke, on traces and from tooth to tooth. Finished
//! numbers in, a section out.

mod compose;
mod data;

pub use data::{ControlFlankReport, ControlReport, ToothTrace};
