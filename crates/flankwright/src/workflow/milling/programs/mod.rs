//! NC programs of milling jobs and their proof: paths of cutters -> passes with safe links -> positions of the axes -> text of every
//! control -> read back -> places of the cutter -> rays (spec 50 sections 8, 11 to 13). Nothing leaves this room that was not read
//! back and compared.

mod blocks;
mod build;
mod cutter_locations;
mod drive;
mod failure;
mod figures;
mod follow;
mod links;
mod passes;
mod proof;
mod safe_room;
mod task;

pub use build::{MillingProgram, MillingPrograms};
pub use cutter_locations::CutterLocationText;
pub use drive::{DrivenMotion, Step, StepKind, ToolRun};
pub use figures::{OperationFigures, RowFigures, StraightKept};
pub use follow::FollowedMove;
pub use proof::RayProof;
pub use task::{MillingMachining, MillingWork, ToolWork};
