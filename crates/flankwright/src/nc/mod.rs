//! The neutral axis program and its way to a control and back (spec 80): blocks of axis values in mm, rad and s, one writer
//! per control dialect, a reader that shares no code with the writers, and the comparison of what was written with what was
//! read back. Knows axes and couplings by their names and numbers only: no gear, no process, no file.

mod compare;
mod dialect;
mod error;
mod expand;
mod expand_gears;
mod program;
mod reader;
mod writer;

pub use compare::{compare, write_checked};
pub use dialect::Dialect;
pub use error::NcError;
pub use expand::{split_turns, subdivide};
pub use expand_gears::expand_gears;
pub use program::{
    AxisMotion, AxisWord, BSplineMotion, Block, Coupling, CubicMotion, CubicSpan, CurveTable, Gear,
    GearLeader, GearSynchronisation, Header, MAXIMUM_AXES, Program, Repetition, TablePiece, Targets,
    ToothData, Word,
};
pub use reader::{
    MAXIMUM_BYTES, ReadError, ReadProblem, ReadProgram, detect_dialect, read, read_with_netlist,
};
pub use writer::{
    Decimals, FanucOptions, HalOptions, LinuxCncOptions, Rounding, Warning, WriteOptions, Written, write,
};
