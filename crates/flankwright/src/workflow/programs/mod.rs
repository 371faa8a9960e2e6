//! NC programs of a run and their proof: motions of the bodies -> strokes of the machine -> text of every dialect -> read back ->
//! axes -> bodies -> referee. Nothing leaves this room that was not read back and simulated.

mod build;
mod of_grinding;
mod page;
mod proof;
mod result;
mod task;
mod technology;

pub use build::{Built, BuiltProgram};
pub use of_grinding::RunPrograms;
pub(super) use of_grinding::programs_of_grinding;
pub(super) use page::programs_report;
pub use result::{AxisResult, PassResult, ProgramResult, ProgramsResult, ProofResult};
pub use task::{DressingWork, GrindingWork, ProgramTask};
