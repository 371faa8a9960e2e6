//! What `result.json` says of programs, with units in the key names.

use super::build::{Built, BuiltProgram};
use super::task::ProgramTask;
use machine::{Joint, Station};
use run::program_check::{BodyClearance, ThreadProof, shown_word};
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// The programs of a run.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ProgramsResult {
    /// Name of the machine.
    pub machine: String,
    /// Whether the workpiece is clamped with its +z into the -z of its spindle.
    pub work_reversed: bool,
    /// The programs.
    pub programs: Vec<ProgramResult>,
    /// What was proven from their texts.
    pub proofs: Vec<ProofResult>,
    /// Which part of the worm every grinding pass uses, read from the texts; empty where all passes use the area of the plan.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub worm_use: Vec<WormUse>,
    /// How far the worm stays clear of the workpiece; absent where it was not checked.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub clearance: Option<ClearanceResult>,
}

/// What was checked of collisions, from the texts.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ClearanceResult {
    /// In words.
    pub statement: String,
    /// Bodies that were checked against each other, as bodies of revolution.
    pub checked: Vec<&'static str>,
    /// What was not.
    pub not_checked: Vec<&'static str>,
    /// How near the worm and what its spindle carries come to clamping and machine over all blocks, the nearest first; empty where the
    /// job and the machine's description name no such bodies.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub bodies: Vec<BodyClearance>,
    /// Distance that is kept from them, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bodies_kept_mm: Option<f64>,
    /// Least distance, mm.
    pub least_mm: f64,
    /// Distance that is kept, mm.
    pub kept_mm: f64,
}

/// What an area of the worm is used for by a pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AreaUse {
    /// It takes off stock on an area of its own.
    Roughing,
    /// It grinds on an area that carries the modification.
    Finishing,
}

/// What a grinding pass touches on the worm, from its text. mm.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WormUse {
    /// The program.
    pub file: String,
    /// First and last block of the pass, from 1.
    pub blocks: [usize; 2],
    /// Flank.
    pub flank: &'static str,
    /// "roughing" or "finishing" and the number of the area.
    pub area: String,
    /// Which of both.
    #[serde(skip)]
    pub kind: AreaUse,
    /// Number of the area among its kind, from 0.
    #[serde(skip)]
    pub number: usize,
    /// Worm positions z_1 from and to.
    pub z_1_mm: [f64; 2],
    /// Worm lines z_1 + t_1 w_1 from and to; no line serves both roughing and finishing.
    pub lines_mm: [f64; 2],
}

/// One program.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ProgramResult {
    /// Path below the directory of the run.
    pub file: String,
    /// Control.
    pub control: &'static str,
    /// "dressing" or "grinding".
    pub job: &'static str,
    /// The flank of the worm that a program dresses line by line; absent for others.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lines_of_flank: Option<&'static str>,
    /// Blocks that move axes.
    pub blocks: usize,
    /// Time of the whole program, ramps included.
    pub duration_s: f64,
    /// Axes.
    pub axes: Vec<AxisResult>,
    /// Passes.
    pub passes: Vec<PassResult>,
}

/// One axis over a program. mm or degrees, per second.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct AxisResult {
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
    /// Greatest speed.
    pub velocity: f64,
    /// Greatest acceleration.
    pub acceleration: f64,
    /// What the machine allows.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_velocity: Option<f64>,
    /// What the machine allows.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_acceleration: Option<f64>,
}

/// One pass.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PassResult {
    /// Its name.
    pub name: String,
    /// Feed z_V2 or worm position v_zS from where to where, run-in and run-out included.
    pub driven_mm: [f64; 2],
    /// Straight blocks of the stroke.
    pub blocks: usize,
    /// Speed of the feed or the worm position; of lines the least speed along one.
    pub speed_mm_per_s: f64,
    /// Share of the wanted speed that the axes allow, where they slow it down.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub braked_to: Option<f64>,
    /// Largest deviation of the blocks on the flank.
    pub chords_um: f64,
    /// What the digits may add.
    pub rounding_um: f64,
    /// Time of one drive.
    pub duration_s: f64,
}

/// What the referee made of a control's texts.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ProofResult {
    /// Controls whose texts say the same.
    pub controls: Vec<&'static str>,
    /// In words.
    pub statement: String,
    /// By flank.
    pub flanks: BTreeMap<&'static str, FlankProof>,
    /// Threads of the worm, those left out included.
    pub threads_of_worm: u32,
    /// Threads whose dressing was counted and put under rays; empty for a worm that no program dresses.
    pub threads: Vec<ThreadProof>,
    /// Flanks of the worm that are dressed line by line; empty for other worms.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub lines: Vec<LinesProof>,
    /// Rays on each flank of each thread, over the profile and along the worm; a flank that is dressed by lines has its own.
    pub thread_rays: [usize; 2],
    /// Finishing areas of the worm: each is dressed, and ground with by a program of its own.
    pub areas: usize,
    /// Tooth spaces that the finishing strokes grind.
    pub tooth_spaces: u32,
    /// Strokes of a pass between which the workpiece is indexed.
    pub index_strokes: usize,
    /// What the proof says nothing of.
    pub not_covered: Vec<String>,
    /// Deviation of straight blocks, dressing and grinding added up.
    pub chords_um: f64,
    /// What the digits may add, dressing and grinding added up.
    pub rounding_um: f64,
    /// Difference from the run's own flank that blocks and digits explain.
    pub allowed_difference_um: f64,
}

/// One flank of the worm whose lines were found in a text.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LinesProof {
    /// "left" or "right".
    pub flank: &'static str,
    /// The program.
    pub file: String,
    /// Lines on each thread, all of them counted.
    pub lines: usize,
    /// Threads on which they were counted.
    pub threads: usize,
    /// Rays of the referee on each thread, across the lines at several places.
    pub rays: usize,
    /// Largest distance of a line from that of the plan, along the normal of the worm.
    pub line_difference_um: f64,
    /// Largest distance of a line from its place across the lines.
    pub aside_um: f64,
    /// Largest difference of a ray from that on the lines of the run.
    pub ray_difference_um: f64,
    /// Greatest height over the wanted worm flank on these rays.
    pub scallop_um: f64,
    /// Greatest depth below it.
    pub undercut_um: f64,
    /// Least distance of the disc from the worm's tip cylinder where it is outside the thread space.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outside_mm: Option<f64>,
    /// Least distance of its rounded tip from the opposite flank inside the thread space, beside the lines.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inside_mm: Option<f64>,
    /// Deviation of straight blocks.
    pub chords_um: f64,
    /// What the digits may add.
    pub rounding_um: f64,
    /// Difference of a line from the plan's that blocks and digits explain.
    pub allowed_difference_um: f64,
}

/// One flank as proven.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FlankProof {
    /// Largest deviation from the target.
    pub max_deviation_um: f64,
    /// Largest difference from the flank of the run's own motions.
    pub difference_um: f64,
}

impl ProgramsResult {
    /// Of the programs that were built and what was proven of them.
    pub fn new(task: &ProgramTask<'_>, built: &Built, proofs: Vec<ProofResult>) -> Self {
        Self {
            machine: task.machine.file.name.clone(),
            work_reversed: task.technology.grinding.counterpart.reversed,
            programs: built.programs.iter().map(|program| program_result(task, program)).collect(),
            proofs,
            worm_use: Vec::new(),
            clearance: None,
        }
    }
}

/// A way shorter than this, mm or rad, is rounding.
const STANDS_STILL: f64 = 1e-9;

fn program_result(task: &ProgramTask<'_>, program: &BuiltProgram) -> ProgramResult {
    let machine = &task.machine.machine;
    let trace = &program.layout.trace;
    let axes = program
        .words
        .words
        .iter()
        .zip(&program.words.numbers)
        .filter(|(_, number)| program.words.is_moved(**number) || trace.way(**number) > STANDS_STILL)
        .map(|(word, &number)| {
            let axis = &machine.axes()[number];
            let shown = |x: f64| axis.joint.shown(x);
            let [from, to] = foundation::numerics::extremes(trace.rows.iter().map(|row| row.at[number]));
            let largest =
                |f: &dyn Fn(usize) -> f64| (0..trace.rows.len()).map(f).fold(0.0f64, |m, x| m.max(x.abs()));
            AxisResult {
                axis: axis.name.clone(),
                word: shown_word(&word.word),
                unit: match axis.joint {
                    Joint::Linear => "mm",
                    Joint::Rotary => "deg",
                },
                from: shown(from),
                to: shown(to),
                way: shown(trace.way(number)),
                velocity: shown(largest(&|k| trace.rows[k].velocity[number])),
                acceleration: shown(largest(&|k| trace.rows[k].acceleration[number])),
                max_velocity: axis.limits.velocity.map(shown),
                max_acceleration: axis.limits.acceleration.map(shown),
            }
        })
        .collect();
    let moves = |block: &&nc::Block| {
        use nc::Block;
        matches!(block, Block::Rapid(_) | Block::Linear { .. } | Block::Cubic(_) | Block::BSpline(_))
    };
    ProgramResult {
        file: program.file.clone(),
        control: program.dialect.name(),
        job: match program.station {
            Station::Dresser => "dressing",
            Station::Work => "grinding",
        },
        lines_of_flank: program.lines.map(foundation::geometry::Flank::name),
        blocks: program.layout.program.blocks().iter().filter(moves).count(),
        duration_s: trace.duration(),
        axes,
        passes: program
            .layout
            .passes
            .iter()
            .map(|pass| PassResult {
                name: pass.name.clone(),
                driven_mm: pass.driven,
                blocks: pass.blocks,
                speed_mm_per_s: pass.speed,
                braked_to: pass.braked.as_ref().map(|braked| braked.share),
                chords_um: pass.chord_deviation * 1e3,
                rounding_um: pass.rounding * 1e3,
                duration_s: pass.time,
            })
            .collect(),
    }
}
