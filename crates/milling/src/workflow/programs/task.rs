//! What milling programs are made from: paths of cutters in one space, how often the space is repeated, the machine. Knows no text.

use super::at_pole::AtPole;
use super::follow::FollowedMove;
use crate::job::{MillingMount, Rtcp};
use crate::{CutterPath, OperationKind, Retraction};
use foundation::geometry::Cutter;
use foundation::kinematics::{Pose, Workpiece};
use job::machine::LoadedMachine;
use job::tables::Program as DialectName;
use machine::StationSpindle;
use nalgebra::{Matrix3, Vector3};
use nc::TipControl;
use referee::MillPath;

/// One operation of a cutter in the space about +y.
#[derive(Clone, Debug)]
pub struct ToolWork {
    /// What it does.
    pub kind: OperationKind,
    /// The cutter.
    pub cutter: Cutter,
    /// Number of the tool, 1 to 99999999.
    pub number: u32,
    /// Speed of the spindle, clockwise, 1/min.
    pub spindle_rpm: f64,
    /// Speed of the contact along the path, mm/min.
    pub feed: f64,
    /// Speed towards the first place of a path, mm/min.
    pub plunge_feed: f64,
    /// Paths in the order of cutting, in coordinates of the workpiece.
    pub paths: Vec<CutterPath>,
}

/// What is milled, without a machine.
#[derive(Clone, Debug)]
pub struct MillingWork<'a> {
    /// Name of the job.
    pub name: &'a str,
    /// Operations in the order of cutting.
    pub tools: Vec<ToolWork>,
    /// Number of spaces that are milled, from 1.
    pub spaces: usize,
    /// Turn about +z from one space to the next, rad.
    pub pitch: f64,
    /// Where the cutter is out of the workpiece.
    pub retraction: Retraction,
}

impl MillingWork<'_> {
    /// The cutters, one for each of the tools.
    pub fn cutters(&self) -> Vec<Cutter> {
        self.tools.iter().map(|tool| tool.cutter.clone()).collect()
    }

    /// Index of the first tool with this number.
    pub fn tool(&self, number: u32) -> usize {
        self.tools.iter().position(|tool| tool.number == number).unwrap_or(0)
    }

    /// Every move of a text as a path of its own.
    pub fn paths(&self, moves: &[FollowedMove]) -> Vec<MillPath> {
        let of = |made: &FollowedMove| MillPath { cutter: self.tool(made.tool), places: made.places.clone() };
        moves.iter().map(of).collect()
    }
}

/// The machine and the options of its control.
#[derive(Clone, Debug)]
pub struct MillingMachining<'a> {
    /// The machine. Its rapid speeds are the greatest speeds of its axes.
    pub machine: &'a LoadedMachine,
    /// How the workpiece sits on its table.
    pub mount: MillingMount,
    /// From the nose of the spindle to the tip of the cutter, mm.
    pub tool_length: f64,
    /// Who leads the tip of the tool.
    pub rtcp: Rtcp,
    /// How a control with tip control receives the axis of the tool.
    pub tip_control: TipControl,
    /// Largest distance of the cutter from its path that straight blocks of the axes may leave, mm.
    pub position_tolerance: f64,
    /// What is done near the pole.
    pub at_pole: AtPole,
    /// Dialects in the order of the job.
    pub dialects: &'a [DialectName],
}

/// How the workpiece is clamped: turned over about the table's x, then put to its place.
pub fn clamping(mount: &MillingMount) -> Pose<StationSpindle, Workpiece> {
    let sense = if mount.turned_over { -1.0 } else { 1.0 };
    let turn = Matrix3::from_diagonal(&Vector3::new(1.0, sense, sense));
    let [x, y] = mount.offset;
    Pose::rigid(turn, Vector3::new(x, y, mount.height))
}
