//! NC programs of a run and their proof: motions of the bodies -> strokes of the machine -> text of every dialect -> read back ->
//! axes -> bodies -> referee. Nothing leaves this room that was not read back and simulated.

mod areas;
mod beyond_travel;
mod build;
mod check;
mod clearance;
mod control;
mod follow;
mod indexing;
mod lines;
mod of_grinding;
mod of_tangential;
mod page;
mod proof;
mod result;
mod run_programs;
mod single_blocks;
mod surroundings;
mod task;
mod technology;

pub(in crate::workflow) use beyond_travel::BeyondTravel;
pub use build::{Built, BuiltProgram};
pub(in crate::workflow) use check::{Moved, checked_axes, figures};
pub use check::{ProgramChecker, check_program};
pub(in crate::workflow) use control::{control_of, decimals_of, dialect_of, ending_of, name_of, words_of};
pub use indexing::Indexing;
pub(super) use of_grinding::{beyond_travel_of_grinding, programs_of_grinding};
pub(super) use of_tangential::programs_of_tangential;
pub(super) use page::programs_report;
pub use result::{
    AxisResult, BodyClearance, CheckedAxis, CheckedFlank, CheckedMeasuring, CheckedProgram, CheckedStroke,
    ClearanceResult, PassResult, ProgramResult, ProgramsResult, ProofResult, ThreadProof, WormUse,
};
pub use run_programs::RunPrograms;
pub(in crate::workflow) use run_programs::dialects;
pub(in crate::workflow) use task::machine_of_job;
pub use task::{DressingWork, GrindingWork, ProgramTask};
pub(super) use technology::Technology;
