//! `[machine]` of five-axis milling: which machine, how the workpiece sits on its table, how the control counts.

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Serialize};

use super::end_move::EndMove;
use super::pair_schema;
use super::probe::TouchProbe;
use super::work_offset::WorkOffset;
use job::tables::ClampingBody;

/// The machine. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MillingMachine {
    /// Machine description (TOML or JSON), beside the job file.
    #[schemars(extend("minLength" = 1))]
    pub file: String,
    /// How the workpiece sits on the table.
    #[serde(default)]
    pub mount: MillingMount,
    /// From the nose of the spindle to the tip of a cutter that has no `tool_length` of its own.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the distance from spindle nose to cutter tip in mm"))]
    pub tool_length: f64,
    /// Where the length of the tool is where a program holds positions of the axes.
    #[serde(default)]
    pub tool_length_in: LengthHolder,
    /// Origin that the control holds and programs count from; default those of machine and table.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub work_offset: Option<WorkOffset>,
    /// A touch probe: a program that finds the clocking angle is written, and sets it in the work offset.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub probe: Option<TouchProbe>,
    /// Time for the spindle to come to its speed before it cuts, s.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 600, "x-way-out" = "give the time in s, e.g. 2.0; 0 is the default"))]
    pub spindle_dwell_s: f64,
    /// Where the axes go at the end of a program, rapid and one after the other; default the program ends where the cutter is out of the
    /// workpiece.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("maxItems" = 20))]
    pub end_position: Vec<EndMove>,
    /// Diameter of the spindle's nose and of what is behind it, which is kept from the workpiece as a cylinder.
    #[serde(default = "default_spindle_diameter")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the diameter of the spindle behind its nose in mm; 100 is the default"))]
    pub spindle_diameter: f64,
    /// Whether the control leads the tip of the tool while rotary axes turn.
    #[serde(default)]
    pub rtcp: Rtcp,
    /// Largest distance of the tip from its path that straight blocks of the axes may leave, um.
    #[serde(default = "default_position_tolerance")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100, "x-way-out" = "give the tolerance in micrometres; 0.5 is the default"))]
    pub position_tolerance_um: f64,
    /// What is done where a path comes near the pole, the direction in which the first rotary axis does not move the cutter's axis.
    #[serde(default)]
    pub pole: PoleWay,
    /// How near to the pole that is, degrees.
    #[serde(default = "default_pole_cap")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 20, "x-way-out" = "give the angle in degrees; 2 is the default"))]
    pub pole_cap_deg: f64,
    /// What holds the workpiece: arbor, nut, chuck, as bodies of revolution about its axis, from which tool, holder and spindle are kept away; default none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("maxItems" = 20))]
    pub clamping: Vec<ClampingBody>,
    /// Distance that tool, holder and spindle keep from the clamping; default 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0.1, "maximum" = 100, "x-way-out" = "give a distance in mm, e.g. 1"))]
    pub body_clearance: Option<f64>,
}

/// How the workpiece sits on the table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct MillingMount {
    /// Whether +z of the workpiece points down.
    pub turned_over: bool,
    /// Height of the workpiece's origin above that of the table.
    #[schemars(extend("minimum" = -10_000, "maximum" = 10_000, "x-way-out" = "give the height above the table's origin in mm"))]
    pub height: f64,
    /// Angle by which the workpiece is turned about its own +z, degrees: of a part whose teeth are cut already, as it was measured.
    #[schemars(extend("minimum" = -360, "maximum" = 360, "x-way-out" = "give the angle in degrees, e.g. as the clocking program measured it"))]
    pub clocking_deg: f64,
    /// Position of the workpiece's axis on the table, along its x and y.
    #[schemars(schema_with = "offset_schema")]
    pub offset: [f64; 2],
}

/// Where the length of a tool is where a program holds positions of the axes. Under tip control it is always the control's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum LengthHolder {
    /// In the positions: they are those of the spindle's nose.
    #[default]
    Program,
    /// On the control, called by G43 H or D: positions are those of the tip. Only where no rotary axis tilts the tool.
    Control,
}

/// Who leads the tip of the tool while rotary axes turn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Rtcp {
    /// The control.
    #[default]
    On,
    /// The program: it holds positions of the axes.
    Off,
    /// The program where a row is one screw block, exactly; else the control.
    Rows,
}

/// What is done near the pole.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum PoleWay {
    /// The geometry stays, the feed is what the axes allow.
    #[default]
    Slow,
    /// The first rotary axis keeps its angle; for ball cutters.
    Hold,
    /// The workpiece is tilted on the table.
    Mount,
}

fn default_spindle_diameter() -> f64 {
    100.0
}

fn default_pole_cap() -> f64 {
    2.0
}

fn default_position_tolerance() -> f64 {
    0.5
}

fn offset_schema(_: &mut SchemaGenerator) -> Schema {
    pair_schema(-10_000.0, 10_000.0, "give the position on the table in mm")
}
