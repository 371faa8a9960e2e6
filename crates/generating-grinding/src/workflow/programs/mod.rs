//! NC programs of a run and their proof: motions of the bodies -> strokes of the machine -> text of every dialect -> read back ->
//! axes -> bodies -> referee. Nothing leaves this room that was not read back and simulated.

pub mod areas;
pub mod axis_curves;
pub mod beyond_travel;
pub mod build;
pub mod check;
pub mod clearance;
pub mod follow;
pub mod indexing;
pub mod lines;
pub mod of_grinding;
pub mod proof;
pub mod result;
pub mod run_programs;
mod single_blocks;
pub mod surroundings;
pub mod task;
pub mod technology;

pub use beyond_travel::BeyondTravel;
pub use build::{Built, BuiltProgram};
pub use check::{BodiesCheck, FollowedBodies};
pub use indexing::Indexing;
pub use of_grinding::{OnGrinding, beyond_travel_of_grinding, programs_of_grinding};
pub use result::{
    AxisResult, ClearanceResult, PassResult, ProgramResult, ProgramsResult, ProofResult, WormUse,
};
pub use run_programs::RunPrograms;
pub use task::{DressingWork, GrindingWork, ProgramTask};
pub use technology::Technology;
