//! Five-axis milling from a checked job to its result: bodies and options, the plan, the referee's rays with what was predicted for
//! them, and the files of a run.

mod bodies;
mod cylindrical;
mod finding;
mod lands;
mod meshes;
mod of_job;
mod offset;
mod page;
mod part_mesh;
pub mod programs;
mod referee;
mod result;
mod run;
mod tables;
mod wear;
mod write;

pub use bodies::{FlankRange, MillingBodies, prepare_milling};
pub use of_job::MillingTexts;
pub use referee::{RefereedFlank, referee};
pub use result::{
    CutterResult, DistancesResult, FlankResult, MillingResult, OperationResult, OutOfReachResult,
    ProgramResult, RootResult, RowResult, WearResult,
};
pub use run::{MillingOutcome, run_milling};
pub use write::write_milling;
