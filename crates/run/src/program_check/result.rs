//! What `program check` says of a program, with units in the key names.

use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;
use verdict::Remark;

/// What `program check` says.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CheckedProgram {
    /// Control whose language it is.
    pub control: &'static str,
    /// Name of the machine.
    pub machine: String,
    /// Name of the program, if its text has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// "dressing" or "grinding", as far as the axes tell.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub kind: Option<&'static str>,
    /// Blocks.
    pub blocks: usize,
    /// Time of all blocks, rapid moves under the limits of the axes, s.
    pub duration_s: f64,
    /// Axes that the program names.
    pub axes: Vec<CheckedAxis>,
    /// Strokes of the tool on the bodies of the job; empty without a job.
    pub strokes: Vec<CheckedStroke>,
    /// The flank that it leaves; absent without a job.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flanks: Option<BTreeMap<&'static str, CheckedFlank>>,
    /// Threads of the worm that a dressing program dresses; empty without a job and for other programs.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub threads: Vec<ThreadProof>,
    /// How near the worm and what its spindle carries come to clamping and machine; empty without a job or such bodies.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub bodies: Vec<BodyClearance>,
    /// What a milling program does to the whole part; absent for other programs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part: Option<PartProof>,
    /// What a program that measures a skiving tool does for the measurement of the job; absent for other programs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub measuring: Option<CheckedMeasuring>,
    /// What does not fit machine or job.
    pub remarks: Vec<Remark>,
}

/// Recordings or scans of a checked program.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CheckedMeasuring {
    /// Recordings or edges that the job wants.
    pub wanted: usize,
    /// Those that are as it wants them.
    pub sound: usize,
    /// Greatest way of the flank between where the ideal tool touches and its nominal place.
    pub difference_um: f64,
    /// Greatest distance of the beam's axis from where the contacts want it.
    pub axis_distance_um: f64,
    /// What digits explain of both.
    pub allowed_um: f64,
    /// In words.
    pub statement: String,
    /// What the check says nothing of.
    pub not_covered: Vec<String>,
}

/// One axis of a checked program. mm or degrees, per second.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CheckedAxis {
    /// Name on the machine.
    pub axis: String,
    /// Word in the text.
    pub word: String,
    /// "mm" or "deg".
    pub unit: &'static str,
    /// Lowest position.
    pub from: f64,
    /// Highest position.
    pub to: f64,
    /// Whole way.
    pub way: f64,
    /// Greatest speed of blocks that state a time.
    pub velocity: f64,
    /// Lower end of travel.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub min: Option<f64>,
    /// Upper end of travel.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max: Option<f64>,
    /// What the machine allows.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_velocity: Option<f64>,
}

/// One stroke of a checked program.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CheckedStroke {
    /// Feed z_V2 or worm position v_zS from where to where.
    pub range_mm: [f64; 2],
    /// First and last block, from 1.
    pub blocks: [usize; 2],
    /// Time, s.
    pub duration_s: f64,
    /// The stroke of the job that it finishes, if it does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub serves: Option<String>,
}

/// One flank as a checked program leaves it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CheckedFlank {
    /// Largest deviation from the target of the job.
    pub max_deviation_um: f64,
    /// Largest difference from the flank of the job's own motions.
    pub difference_um: f64,
}

/// How near something comes to a body of clamping or machine.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct BodyClearance {
    /// Its name.
    pub body: String,
    /// What comes near to it: the worm or a body that the worm's spindle carries.
    pub of: String,
    /// Least distance, mm: never more than 0.02 mm above the true one.
    pub least_mm: f64,
    /// The program in which that is; empty where one text alone is checked.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub file: String,
    /// Its block, from 1.
    pub block: usize,
}

/// One thread of the worm as proven.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ThreadProof {
    /// Its number, from 1 in the positive sense about the worm's axis.
    pub thread: u32,
    /// First and last block of its finishing strokes, from 1.
    pub blocks: Vec<[usize; 2]>,
    /// Largest difference of each worm flank from that of the job's own motions.
    pub difference_um: BTreeMap<&'static str, f64>,
}

/// What a text was proven for.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PartProof {
    /// In words.
    pub statement: String,
    /// Spaces of the part, all of them under rays, and how many the job mills.
    pub spaces: [usize; 2],
    /// Surfaces under rays.
    pub surfaces: Vec<String>,
    /// Their rays.
    pub rays: usize,
    /// Greatest distance of neighbouring rays on flanks, root and tips.
    pub ray_spacing_mm: f64,
    /// How exactly the depth of a cut is known along a ray.
    pub depth_resolution_mm: f64,
    /// Rapid moves that were looked at.
    pub rapid_moves: usize,
    /// Distance of the places and points of the tool that were looked at on them.
    pub rapid_resolution_mm: f64,
    /// How near tool, holder and spindle come to the clamping over all moves, the nearest first; empty where the job names none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub clamping: Vec<BodyClearance>,
    /// Distance that is kept from it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub clamping_kept_mm: Option<f64>,
    /// What the proof says nothing of.
    pub not_covered: Vec<String>,
    /// What is wrong.
    pub faults: Vec<ProgramFault>,
}

/// Something wrong in a text.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ProgramFault {
    /// Stable code.
    pub code: &'static str,
    /// What, with block and place.
    pub text: String,
    /// What helps.
    pub way_out: &'static str,
    /// Number of the block, from 1; where nothing is milled that of the nearest block.
    pub block: usize,
    /// Number of the space, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub space: Option<usize>,
    /// The surface.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub surface: Option<String>,
    /// Where, in coordinates of the workpiece.
    pub place_mm: [f64; 3],
    /// How deep or how high.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub amount_mm: Option<f64>,
}
