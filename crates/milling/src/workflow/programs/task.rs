//! What milling programs are made from: paths of cutters in one space, how often the space is repeated, the machine. Knows no text.

use super::at_pole::AtPole;
use super::follow::FollowedMove;
use super::held::HeldOffset;
use crate::job::{EndMove, MillingMount, Rtcp};
use crate::workflow::prepare::ToolData;
use crate::{CutterPath, OperationKind, Retraction};
use foundation::geometry::Cutter;
use foundation::kinematics::{Pose, Workpiece};
use job::machine::LoadedMachine;
use job::tables::Program as DialectName;
use machine::StationSpindle;
use nalgebra::{Matrix3, Rotation3, Vector3};
use nc::TipControl;
use referee::MillPath;

/// One operation of a cutter in the space about +y.
#[derive(Clone, Debug)]
pub struct ToolWork {
    /// What it does.
    pub kind: OperationKind,
    /// The cutter.
    pub cutter: Cutter,
    /// The tool that it is on the machine: number from 1 to 99999999, length, speeds, coolant.
    pub tool: ToolData,
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
        self.tools.iter().position(|tool| tool.tool.number == number).unwrap_or(0)
    }

    /// Length of the longest tool, mm.
    pub fn longest_tool(&self) -> f64 {
        self.tools.iter().map(|tool| tool.tool.length).fold(0.0, f64::max)
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
    /// Clocking angle of the workpiece that the control holds beside the mount, rad.
    pub held_clocking: Option<f64>,
    /// Origin that the control holds.
    pub work_offset: Option<HeldOffset>,
    /// Whether the control adds the lengths of tools to positions of the axes.
    pub holds_lengths: bool,
    /// Time for the spindle to come to its speed, s; 0: none.
    pub spindle_dwell: f64,
    /// Where the axes go at the end, one after the other.
    pub end_position: &'a [EndMove],
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

/// How the workpiece is clamped: turned about its axis by its clocking angle, turned over about the table's x, then put to its place.
pub fn clamping(mount: &MillingMount) -> Pose<StationSpindle, Workpiece> {
    let sense = if mount.turned_over { -1.0 } else { 1.0 };
    let turn = Matrix3::from_diagonal(&Vector3::new(1.0, sense, sense));
    let [x, y] = mount.offset;
    let clocked = Rotation3::from_axis_angle(&Vector3::z_axis(), mount.clocking_deg.to_radians());
    Pose::rigid(turn * clocked.matrix(), Vector3::new(x, y, mount.height))
}
