//! The section of a report on NC programs: proof, programs, passes, axes over time. Finished numbers in, a section out; the same for
//! every process that drives a machine.

mod compose;
mod data;

pub use data::{
    AxisRow, ControlWords, FlankProofRow, PassRow, PassTable, ProgramRow, ProgramsReport, ProofReport,
    RestingAxis, SpindleRow, StationReport,
};
