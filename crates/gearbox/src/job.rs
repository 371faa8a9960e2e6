//! The job file of the electronic gearbox as types: one table of the file, one file here. A `GearboxJob` has the right keys,
//! types and ranges; contradictions between entries are found by [`job::read_any_job`]. What a job of generating grinding
//! says in the same words is taken from [`job::control`]. Knows nothing of what a gearbox makes of its pulses.

mod checks;
mod compare;
mod correction;
mod engagement;
mod errors;
mod explore;
mod extent;
mod gear;
mod output;
mod spindles;
mod split;
mod stimulus;
mod target;
mod train;
mod travel;

pub use compare::{ComparedAmplitude, ComparedLoop, GearboxCompare};
pub use correction::{AddedRotation, CorrectionAxis, GearboxCorrection, TableEnds};
pub use engagement::GearboxEngagement;
pub use errors::{
    BallScrewErrors, EncoderHarmonic, GearboxErrors, PeriodicError, ScaleErrors, WorkpieceEncoderErrors,
};
pub use explore::{ClockChoice, EncoderChoice, GearboxExplore, InterpolationChoice, ScaleChoice};
pub use gear::GearboxGear;
pub use output::GearboxOutput;
pub use spindles::{GearboxWorkpiece, LeadingWorm};
pub use split::GearboxSplit;
pub use stimulus::{GREATEST_TICK, Stimulus};
pub use target::GearboxTarget;
pub use train::reference_train;
pub use travel::{Dwell, Move, Travel};

use job::{Diagnostic, Loaded, ProcessJob};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use job::control::{ScaleInterpolation, Servo};
use job::tables::{JobInfo, Language};

/// A job of the electronic gearbox: reference pulses of the feed slide become an additional rotation of a helical workpiece.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GearboxJob {
    /// Name and process.
    pub job: JobInfo,
    /// The workpiece as far as its rotation depends on it.
    pub gear: GearboxGear,
    /// What the errors are judged by; without it they are reported and not judged.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub target: Option<GearboxTarget>,
    /// Scale of the feed slide and interpolation of its pulses.
    pub feed: ScaleInterpolation,
    /// Encoder of the workpiece spindle, and the sense of its additional rotation.
    pub workpiece: GearboxWorkpiece,
    /// The tool spindle that leads the workpiece; without one the additional rotation is all that turns it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub worm: Option<LeadingWorm>,
    /// What the feed slide does.
    pub stimulus: Stimulus,
    /// The servo of the workpiece spindle; without one its error is not simulated.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub servo: Option<Servo>,
    /// Errors of scale or ball screw and of the encoder; without them they are perfect.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub errors: Option<GearboxErrors>,
    /// Rotation that is added over feed and worm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub correction: Option<GearboxCorrection>,
    /// The rotation as whole pulses and a voltage.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub split: Option<GearboxSplit>,
    /// How the workpiece comes into the gap of the running worm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub engagement: Option<GearboxEngagement>,
    /// Multipliers of older controls beside the interpolator.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub compare: Option<GearboxCompare>,
    /// Scales, clocks, interpolations and encoders to choose from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub explore: Option<GearboxExplore>,
    /// What to write beside result and report.
    #[serde(default)]
    pub output: GearboxOutput,
}

/// A checked job of the electronic gearbox.
pub type LoadedGearboxJob = Loaded<GearboxJob>;

impl ProcessJob for GearboxJob {
    const NAME: &'static str = "electronic-gearbox";
    const ABOUT: &'static str = "The electronic gearbox that turns a helical workpiece while it feeds.";
    const TEMPLATE: &'static str = include_str!("job/template.toml");

    fn info(&self) -> &JobInfo {
        &self.job
    }

    fn language(&self) -> Language {
        self.output.language
    }

    fn contradictions(&self) -> Vec<Diagnostic> {
        checks::check(self)
    }
}
