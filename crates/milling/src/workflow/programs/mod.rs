//! NC programs of milling jobs and their proof: paths of cutters -> passes with safe links -> positions of the axes -> text of every
//! control -> read back -> places of the cutter -> rays (`docs/mathematics/milling.md`). Nothing leaves this room that was not read
//! back and compared.

mod at_pole;
mod blocks;
mod build;
mod check;
mod clocking_cycle;
mod cutter_locations;
mod drive;
mod end_position;
mod failure;
mod figures;
mod follow;
mod held;
mod held_clocking;
mod linking;
mod links;
mod operation_figures;
mod passes;
mod pole;
mod probe_tool;
mod proof;
mod safe_room;
mod steps;
mod task;

pub use at_pole::AtPole;
pub use build::{MillingProgram, MillingPrograms};
pub(super) use check::ROUNDING;
pub use check::{AxisFault, CheckedMotion};
pub use clocking_cycle::ClockingCycle;
pub use cutter_locations::CutterLocationText;
pub use failure::of_motion;
pub use follow::FollowedMove;
pub use held::{HeldOffset, length_numbers};
pub use held_clocking::HeldClocking;
pub use operation_figures::{OperationFigures, RowFigures, StraightKept};
pub use probe_tool::ProbeTool;
pub(super) use proof::OBLIQUE;
pub use proof::RayProof;
pub use steps::{DrivenMotion, Step, StepKind, ToolRun};
pub use task::{MillingMachining, MillingWork, ToolWork, clamping};
