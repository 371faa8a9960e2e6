//! Five-axis milling from a checked job to its result: bodies and options, the plan, the referee's rays with what was predicted for
//! them, and the files of a run.

mod bodies;
mod finding;
mod mate;
mod meshes;
mod of_job;
mod offset;
mod page;
pub mod programs;
mod referee;
mod result;
mod root;
mod run;
mod tables;
mod wear;
mod write;

pub use bodies::{FlankRange, MillingBodies, prepare_milling};
pub use mate::{MateFlank, MateOutcome};
pub use of_job::MillingTexts;
pub use referee::{RefereedFlank, referee};
pub use result::{
    CutterResult, DistancesResult, FlankResult, MateFlankResult, MateResult, MillingResult, OperationResult,
    PatternResult, ProgramResult, RootDeviationResult, RootResult, RowResult, WearResult,
};
pub use root::{RefereedRoot, referee_root};
pub use run::{MillingOutcome, run_milling};
pub use write::write_milling;
