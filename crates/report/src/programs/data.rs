//! The figures of NC programs, as the report takes them. Plain numbers with their units in the names.

use crate::charts::AxisChart;
use serde::Serialize;

/// Everything that a report shows of the programs of a run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ProgramsReport {
    /// Name of the machine.
    pub machine: String,
    /// Whether the workpiece is clamped with its +z into the -z of its spindle.
    pub work_reversed: bool,
    /// What was proven from the texts; controls whose texts say the same stand together.
    pub proofs: Vec<ProofReport>,
    /// The programs.
    pub programs: Vec<ProgramRow>,
    /// What the programs do: dressing, grinding.
    pub stations: Vec<StationReport>,
}

/// A proof.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ProofReport {
    /// Controls whose texts say the same.
    pub controls: Vec<String>,
    /// In words.
    pub statement: String,
    /// By flank.
    pub flanks: Vec<FlankProofRow>,
    /// Largest deviation of straight blocks on the flank, um.
    pub chords_um: f64,
    /// What the digits of the numbers may add, um.
    pub rounding_um: f64,
    /// Difference that blocks and digits explain, um.
    pub allowed_difference_um: f64,
}

/// A flank as proven.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FlankProofRow {
    /// "left" or "right".
    pub flank: String,
    /// Largest deviation from the target, um.
    pub max_deviation_um: f64,
    /// Largest difference from the flank of the run's own motions, um.
    pub difference_um: f64,
}

/// A program.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ProgramRow {
    /// Path below the directory of the run.
    pub file: String,
    /// Control.
    pub control: String,
    /// "dressing" or "grinding".
    pub job: String,
    /// Blocks that move axes.
    pub blocks: usize,
    /// Time of the whole program, s, ramps included.
    pub time_s: f64,
}

/// What the programs of one kind do.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StationReport {
    /// "dressing" or "grinding".
    pub job: String,
    /// What the path parameter of its passes is, for example "feed z_V2".
    pub parameter: String,
    /// Control whose program rows and charts of the axes are taken from.
    pub control: String,
    /// Other controls whose programs drive the axes in the same way.
    pub alike: Vec<String>,
    /// Other controls whose programs drive the axes otherwise.
    pub different: Vec<String>,
    /// The passes; controls with the same ones share a table.
    pub passes: Vec<PassTable>,
    /// Axes that move.
    pub axes: Vec<AxisRow>,
    /// Axes that stand still.
    pub resting: Vec<RestingAxis>,
    /// Axes that turn as spindles.
    pub spindles: Vec<SpindleRow>,
    /// Axes over time.
    pub charts: Vec<AxisChart>,
    /// Axes that move but cannot be drawn, because they have no limits and jump.
    pub jumping: Vec<String>,
}

/// Passes of the programs of some controls.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PassTable {
    /// The controls.
    pub controls: Vec<String>,
    /// The passes in their order.
    pub rows: Vec<PassRow>,
}

/// A pass.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PassRow {
    /// Its name.
    pub name: String,
    /// Path parameter from where to where, run-in and run-out included, mm.
    pub driven_mm: [f64; 2],
    /// Straight blocks.
    pub blocks: usize,
    /// Speed of the path parameter, mm/s.
    pub speed_mm_per_s: f64,
    /// Share of the wanted speed that the axes allow, and what forbids more; `None` at full speed.
    pub braked: Option<(f64, String)>,
    /// Largest deviation of the blocks on the flank, um.
    pub chords_um: f64,
    /// What the digits may add, um.
    pub rounding_um: f64,
    /// Time of one drive, s.
    pub time_s: f64,
}

/// An axis over a program; mm or deg, per second.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AxisRow {
    /// Name on the machine.
    pub axis: String,
    /// What it does, for example "radial"; empty if it plays no role.
    pub role: String,
    /// Word on each control.
    pub words: Vec<ControlWords>,
    /// Whether the control counts it against the machine's sense.
    pub reversed: bool,
    /// "mm" or "deg".
    pub unit: String,
    /// Lowest and highest position.
    pub range: [f64; 2],
    /// Whole way.
    pub way: f64,
    /// Greatest velocity and what the machine allows.
    pub velocity: (f64, Option<f64>),
    /// Greatest acceleration and what the machine allows.
    pub acceleration: (f64, Option<f64>),
}

/// A word and the controls that use it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ControlWords {
    /// The word.
    pub word: String,
    /// The controls.
    pub controls: Vec<String>,
}

/// An axis that turns as a spindle.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SpindleRow {
    /// Name on the machine.
    pub axis: String,
    /// Word in the program.
    pub word: String,
    /// Speed, revolutions per minute.
    pub speed_per_min: f64,
}

/// An axis that stands still.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RestingAxis {
    /// Name on the machine.
    pub axis: String,
    /// Where it stands, mm or deg.
    pub at: f64,
    /// "mm" or "deg".
    pub unit: String,
}
