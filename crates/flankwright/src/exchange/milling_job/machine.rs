//! `[machine]` of five-axis milling: which machine, how the workpiece sits on its table, how the control counts.

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Serialize};

use super::pair_schema;

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
    /// From the nose of the spindle to the tip of the cutter.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the distance from spindle nose to cutter tip in mm"))]
    pub tool_length: f64,
    /// Whether the control leads the tip of the tool while rotary axes turn.
    #[serde(default)]
    pub rtcp: Rtcp,
    /// Largest distance of the tip from its path that straight blocks of the axes may leave, um.
    #[serde(default = "default_position_tolerance")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100, "x-way-out" = "give the tolerance in micrometres; 0.5 is the default"))]
    pub position_tolerance_um: f64,
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
    /// Position of the workpiece's axis on the table, along its x and y.
    #[schemars(schema_with = "offset_schema")]
    pub offset: [f64; 2],
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

fn default_position_tolerance() -> f64 {
    0.5
}

fn offset_schema(_: &mut SchemaGenerator) -> Schema {
    pair_schema(-10_000.0, 10_000.0, "give the position on the table in mm")
}
