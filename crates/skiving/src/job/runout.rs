//! `[runout]`: the run-out of the tool, answered while it skives.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::runout::RunoutAxes;

/// A periodic law over the turn of the tool that answers the differences of its measured teeth.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RunoutCorrection {
    /// What changes with the turn of the tool.
    #[serde(default)]
    pub law: RunoutLaw,
    /// Orders of the law: 1 is once per turn, as an eccentric tool asks for.
    #[serde(default = "one")]
    #[schemars(extend("minimum" = 1, "maximum" = 20, "x-way-out" = "give the number of orders, 1 for an eccentric tool"))]
    pub orders: usize,
    /// The stroke that is written as a program with the law in it, and with the correction of the setting.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stroke: Option<SkivingStroke>,
}

/// What changes with the turn of the tool.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RunoutLaw {
    /// Centre distance and coupling.
    #[default]
    Both,
    /// The centre distance: radial run-out.
    CentreDistance,
    /// The coupling of workpiece and tool.
    Coupling,
}

/// A finishing stroke of skiving. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SkivingStroke {
    /// Speed of the tool spindle, 1/min.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100_000, "x-way-out" = "give the speed in 1/min, e.g. 600"))]
    pub tool_speed_rpm: f64,
    /// Axial feed per turn of the workpiece.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10, "x-way-out" = "give the feed in mm per turn of the workpiece, e.g. 0.2"))]
    pub feed: f64,
    /// How far beside both faces the edges begin and end.
    #[serde(default = "default_overrun")]
    #[schemars(extend("minimum" = 0, "maximum" = 100, "x-way-out" = "give the overrun in mm; 2 is the default"))]
    pub overrun: f64,
    /// Blocks per turn of the tool.
    #[serde(default = "default_blocks")]
    #[schemars(extend("minimum" = 8, "maximum" = 360, "x-way-out" = "give the number of blocks per turn of the tool; 24 is the default"))]
    pub blocks_per_turn: usize,
    /// From the origin of the work spindle to the middle of the workpiece's face, along its axis.
    #[serde(default)]
    #[schemars(extend("minimum" = -5000, "maximum" = 5000, "x-way-out" = "give the height of the middle of the face above the origin of the work spindle in mm"))]
    pub work_height: f64,
}

impl RunoutLaw {
    /// As the fit takes it.
    pub(crate) fn axes(self) -> RunoutAxes {
        RunoutAxes { centre_distance: self != Self::Coupling, coupling: self != Self::CentreDistance }
    }
}

fn one() -> usize {
    1
}

fn default_overrun() -> f64 {
    2.0
}

fn default_blocks() -> usize {
    24
}
