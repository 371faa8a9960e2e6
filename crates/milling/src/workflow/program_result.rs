//! NC programs in a milling job's `result.json`.

use run::program_check::PartProof;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// One program.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ProgramResult {
    /// Path below the directory of the run.
    pub file: String,
    /// Control.
    pub control: &'static str,
    /// Blocks that move.
    pub blocks: usize,
    /// Time of the whole program, all spaces; changes of tools are not in it.
    pub duration_s: f64,
    /// Time of the first space alone.
    pub one_space_s: f64,
    /// Operations in their order, over all spaces.
    pub operations: Vec<ProgramOperation>,
    /// How the workpiece is tilted on the table beside what the job's mount says, where the pole asks for it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mount_tilt: Option<MountTilt>,
    /// What the axes do that is worth knowing: solutions, turning back, the pole.
    pub remarks: Vec<String>,
    /// What rounding of the numbers does at most.
    pub rounding_um: f64,
    /// What straight blocks of the axes do to the tip at most.
    pub straight_blocks_um: f64,
    /// Largest difference of a ray milled as the text says from the planned one.
    pub proof_difference_um: f64,
    /// What rounding and straight blocks explain of it.
    pub proof_allowed_um: f64,
    /// What the text does to the whole part.
    pub part: PartProof,
}

/// One operation of a program, over all spaces.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ProgramOperation {
    /// What it does.
    pub name: String,
    /// Number of the tool.
    pub tool: u32,
    /// Blocks that move.
    pub blocks: usize,
    /// Time in the material and towards it.
    pub cutting_s: f64,
    /// Time of all other blocks.
    pub rapid_s: f64,
    /// Time of the first space alone.
    pub one_space_s: f64,
    /// What determines the time of how many cuts: "feed" or the name of an axis.
    pub limited_by: BTreeMap<String, usize>,
    /// Travel of both rotary axes, links included; the axis next to the workpiece first.
    pub rotary_travel_deg: [f64; 2],
    /// Links on which an axis is turned back or changes its solution.
    pub turned_back: usize,
}

/// A tilt of the workpiece about its origin.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MountTilt {
    /// Its axis in coordinates of the table.
    pub axis: [f64; 3],
    /// Its angle, right-handed.
    pub angle_deg: f64,
    /// Least angle between the cutter's axis and the pole that is left.
    pub pole_distance_deg: f64,
}
