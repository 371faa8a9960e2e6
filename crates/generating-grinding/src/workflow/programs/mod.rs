//! NC programs of a run and their proof: motions of the bodies -> strokes of the machine -> text of every dialect -> read back ->
//! axes -> bodies -> referee. Nothing leaves this room that was not read back and simulated.

mod area_sections;
pub mod areas;
pub mod axis_curves;
pub mod beyond_travel;
pub mod build;
pub mod check;
pub mod clearance;
pub mod cylinders;
pub mod follow;
pub mod grinding_stroke;
pub mod indexing;
pub mod judge;
pub mod lines;
mod mesh;
pub mod of_grinding;
pub mod on_grinding;
pub mod proof;
pub mod result;
pub mod run_programs;
mod single_blocks;
pub mod sought;
pub mod surroundings;
pub mod task;
pub mod technology;
pub mod work;

pub use beyond_travel::BeyondTravel;
pub use build::{Built, BuiltProgram};
pub use check::{BodiesCheck, FollowedBodies};
pub use grinding_stroke::{GrindingStroke, StockContact, StrokeLaw};
pub use indexing::Indexing;
pub use of_grinding::{beyond_travel_of_grinding, programs_of_grinding};
pub use on_grinding::OnGrinding;
pub use result::{
    AxisResult, ClearanceResult, PassResult, ProgramResult, ProgramsResult, ProofResult, WormUse,
};
pub use run_programs::RunPrograms;
pub use task::ProgramTask;
pub use technology::Technology;
pub use work::{DressingWork, GrindingWork};
