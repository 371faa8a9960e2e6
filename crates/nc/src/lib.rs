//! The neutral program and its way to a control and back (`docs/mathematics/programs.md`; tips of tools:
//! `docs/mathematics/programs.md#cutters`): blocks of axis values or of a tool's tip and direction in mm, rad and s, one writer per control
//! dialect and one of cutter locations, readers that share no code with the writers, and the comparison of what was written with what was
//! read back. Knows axes and couplings by their names and numbers only: no gear, no process, no file.

mod checked;
mod compare;
mod dialect;
mod error;
mod expand;
mod program;
mod reader;
mod writer;

pub use checked::{Checked, write_checked, write_cl_checked};
pub use compare::compare;
pub use dialect::Dialect;
pub use error::NcError;
pub use expand::split_turns;
pub use program::{
    Angles, AxisMotion, AxisWord, BSplineMotion, Block, Coolant, Coupling, CubicMotion, CubicSpan,
    CurveTable, Gear, GearLeader, GearSynchronisation, Header, MAXIMUM_ANGLES, MAXIMUM_AXES, OffsetShift,
    Orientation, Pace, ProbeMove, Program, Repetition, TablePiece, Targets, TipControl, TipMotion, ToothData,
    WORK_OFFSETS, Word,
};
pub use reader::{
    ClProgram, MAXIMUM_BYTES, ReadError, ReadProblem, ReadProgram, detect_dialect, read, read_cl,
    read_with_netlist,
};
pub use writer::{
    ClCutter, Decimals, FanucOptions, FeedWords, HalOptions, LinuxCncOptions, Rounding, RoundingBound,
    TipDecimals, Warning, WriteOptions, Written, cl_with_notes, netlist_with_notes, rounding_bound,
    with_notes, write, write_cl,
};
