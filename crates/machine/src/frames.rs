//! The frames between which poses of a machine lead.

/// Frame M: the machine's bed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bed;

/// Frame P: the spindle that carries the tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ToolSpindle;

/// Frame Q or D: the spindle of a station.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StationSpindle;

/// Where the tool works.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Station {
    /// On the workpiece.
    Work,
    /// On the dresser.
    Dresser,
}
