//! A measured bevel gear for the job by which it was milled: points of a grid on its flanks, from files to the answer
//! (`docs/inspection.md#bevel-gears`).

mod judgement;
mod pitches;
mod result;
mod run;
mod summary;
mod tables;
mod teeth;
mod write;

pub use result::{BevelInspectionResult, BevelPitchPlace};
pub use run::{BevelInspection, inspect_bevel};
pub use write::write_bevel_inspection;
