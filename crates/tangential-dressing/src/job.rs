//! The job file of tangential dressing as types: one table of the file, one file here. A `TangentialJob` has the right
//! keys, types and ranges; contradictions between entries are found by [`job::read_any_job`]. What both processes say in
//! the same words (gear, control, grid, output) is taken from [`generating_grinding::job`]. Knows nothing of what a variable does to a flank.

mod channel;
mod checks;
mod dresser;
mod dressing;
mod explore;
mod grinding;
mod names;
mod settings;
mod spline;
mod target;
mod variable;
mod worm;

pub use channel::Channel;
pub use dresser::{DresserProfile, TangentialDresser};
pub use dressing::{
    DeviationMeasure, FitMethod, FitWeights, Passes, TangentialDressing, VariableRule, Variables,
};
pub use explore::TangentialExplore;
pub use grinding::{OffsetRule, ShiftOffset, ShiftRatio, ShiftRule, TangentialGrinding};
pub use settings::{FlankValues, TangentialSettings};
pub use spline::{SplineChoice, SplineValues};
pub use target::{EdgeAmounts, TangentialTarget};
pub use variable::{Variable, VariableError};
pub use worm::TangentialWorm;

use job::{Diagnostic, Document, Loaded, ProcessJob};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use job::tables::{Control, Gear, Grid, Hand, JobInfo, Language, Machine, Output};

/// A job of tangential dressing: a worm is dressed by one motion along its axis, modified as function of the position of the
/// dresser, and grinds the gear with a shift that follows the feed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TangentialJob {
    /// Name and process.
    pub job: JobInfo,
    /// The workpiece: external, cylindrical or conical, its flanks alike or not.
    pub gear: Gear,
    /// The wanted flank.
    pub target: TangentialTarget,
    /// The grinding worm.
    pub worm: TangentialWorm,
    /// The disc dresser.
    pub dresser: TangentialDresser,
    /// How the gear is ground.
    pub grinding: TangentialGrinding,
    /// How the worm is dressed, and by which variables the target is met.
    #[serde(default)]
    pub dressing: TangentialDressing,
    /// The machine for which programs are written.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub machine: Option<Machine>,
    /// The control that couples the axes; without one they move exactly as commanded.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub control: Option<Control>,
    /// Points of the result grid.
    #[serde(default)]
    pub grid: Grid,
    /// What to write beside result and report.
    #[serde(default)]
    pub output: Output,
    /// What a study varies.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub explore: Option<TangentialExplore>,
    /// Values of the variables that `simulate` runs; `plan` writes them and does not read them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub settings: Option<TangentialSettings>,
}

impl TangentialJob {
    /// Hand of the worm: as given, else that of the gear (spur: right).
    pub fn worm_hand(&self) -> Hand {
        self.worm.hand.unwrap_or(self.gear.default_worm_hand())
    }

    /// b_w in mm, the range of the tool shift and scale of the dresser's position x_D: as given, else what a given ratio makes
    /// of the face width, and without any shift the face width itself. `None` with a ratio that is still to be found.
    pub fn shift_width(&self) -> Option<f64> {
        let by_ratio = match self.grinding.shift_ratio {
            ShiftRatio::Number(0.0) => Some(self.gear.face_width),
            ShiftRatio::Number(ratio) => Some(ratio.abs() * self.gear.face_width),
            ShiftRatio::Rule(_) => None,
        };
        self.grinding.shift_width.or(by_ratio)
    }
}

/// A checked job of tangential dressing.
pub type LoadedTangentialJob = Loaded<TangentialJob>;

impl ProcessJob for TangentialJob {
    const NAME: &'static str = "tangential-dressing";
    const ABOUT: &'static str =
        "Generating grinding with a worm that one motion of the dresser along its tangent has modified.";
    const TEMPLATE: &'static str = include_str!("job/template.toml");

    fn info(&self) -> &JobInfo {
        &self.job
    }

    fn language(&self) -> Language {
        self.output.language
    }

    fn shape(document: &Document) -> Vec<Diagnostic> {
        names::variable_names(document.root())
    }

    fn contradictions(&self) -> Vec<Diagnostic> {
        checks::check(self)
    }
}
