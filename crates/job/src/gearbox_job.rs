//! The job file of the electronic gearbox as types: one table of the file, one file here. A `GearboxJob` has the right keys,
//! types and ranges; contradictions between entries are found by [`super::read_any_job`]. What a job of generating grinding
//! says in the same words is taken from [`super::control`]. Knows nothing of what a gearbox makes of its pulses.

mod checks;
mod explore;
mod extent;
mod gear;
mod output;
mod spindles;
mod stimulus;
mod target;
mod train;
mod travel;

pub(super) use checks::check;
pub use explore::{ClockChoice, EncoderChoice, GearboxExplore, InterpolationChoice, ScaleChoice};
pub use gear::GearboxGear;
pub use output::GearboxOutput;
pub use spindles::{GearboxWorkpiece, LeadingWorm};
pub(super) use stimulus::GREATEST_TICK;
pub use stimulus::Stimulus;
pub use target::GearboxTarget;
pub use travel::{Dwell, Move, Travel};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::control::{ScaleInterpolation, Servo};
use super::diagnostic::{Diagnostic, Problem};
use super::job::{JobInfo, Process};

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
    /// Scales, clocks, interpolations and encoders to choose from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub explore: Option<GearboxExplore>,
    /// What to write beside result and report.
    #[serde(default)]
    pub output: GearboxOutput,
}

impl GearboxJob {
    /// What every other command than `gearbox` answers to such a job; on the key `job.process`.
    pub fn refused_by(command: &str) -> Diagnostic {
        let name = Process::ElectronicGearbox.name();
        let message = format!("`{command}` does not take a job of the process \"{name}\"");
        let way_out = if command == "explore" {
            "run `flankwright gearbox FILE`, which carries out its table [explore] as well"
        } else {
            "run `flankwright gearbox FILE`"
        };
        Diagnostic::new(Problem::ProcessNotAvailable, message)
            .field("job.process")
            .value(format!("\"{name}\""))
            .allowed(Process::ElectronicGearbox.others_taken_by(command))
            .way_out(way_out)
    }
}
