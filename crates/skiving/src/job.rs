//! The job file of measuring a skiving tool in the machine as types: one table of the file, one file here. A `SkivingJob` has the
//! right keys, types and ranges; contradictions between entries are found by [`job::read_any_job`]. What other processes say in the
//! same words is taken from [`generating_grinding::job`]. Knows nothing of contact points and poses.

mod calibration;
mod checks;
mod evaluation;
mod history;
mod light_barrier;
mod machine;
mod measuring;
mod output;
mod runout;
mod skiving;
mod skiving_tool;
mod stylus;
mod target;
#[cfg(test)]
mod tests;
mod tool_errors;
mod workpiece_probe;

pub use self::skiving::{SkivingSetting, ToolKinematics};
pub use calibration::{CalibrationMove, MandrelCalibration, MandrelSwitch};
pub use evaluation::{MachineSetting, SettingBounds, ToolEvaluation};
pub use history::ToolHistory;
pub use light_barrier::LightBarrier;
pub use machine::{BarrierCarrier, SkivingMachine};
pub use measuring::{MeasuringPoses, Senses, ToolMeasuring, Travel};
pub use output::SkivingOutput;
pub use runout::{RunoutCorrection, RunoutLaw, SkivingStroke};
pub use skiving_tool::{Rake, RakeChamfer, RakeForm, SkivingToolEntry};
pub use stylus::{ScanMotion, Stylus};
pub use target::SkivingTarget;
pub use tool_errors::{EdgeErrorsUm, RandomErrors, ToolErrors, ToothErrors};
pub use workpiece_probe::{SettingErrors, WorkpieceProbe};

use job::{Diagnostic, Loaded, ProcessJob};
use schemars::{JsonSchema, Schema, json_schema};
use serde::{Deserialize, Serialize};

use job::tables::{Gear, JobInfo, Language};

/// A job of measuring a skiving tool: poses and program for the light barrier, readings simulated or read, what they say of the tool and
/// of the workpiece to come.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SkivingJob {
    /// Name and process.
    pub job: JobInfo,
    /// The workpiece; its evaluation diameters bound the edge that is measured.
    pub gear: Gear,
    /// The wanted profile.
    #[serde(default)]
    pub target: SkivingTarget,
    /// The tool.
    pub skiving_tool: SkivingToolEntry,
    /// How tool and workpiece stand while they skive.
    #[serde(default)]
    pub skiving: SkivingSetting,
    /// The light barrier.
    pub light_barrier: LightBarrier,
    /// Tracks, poses, senses, revolutions.
    #[serde(default)]
    pub measuring: ToolMeasuring,
    /// What the tool is judged by, and how far the machine may be set otherwise.
    #[serde(default)]
    pub evaluation: ToolEvaluation,
    /// Errors of the tool whose measurement is simulated.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tool_errors: Option<ToolErrors>,
    /// Switching angles of a real measurement: a table (CSV) with the columns flank, track, sense, revolution, angle_deg, beside the job
    /// file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub readings: Option<TriggerFile>,
    /// The run-out of the tool, answered while it skives.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub runout: Option<RunoutCorrection>,
    /// The light barrier measured with a mandrel.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub calibration: Option<MandrelCalibration>,
    /// A stylus that scans the edges.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stylus: Option<Stylus>,
    /// The machined workpiece, measured by a probe in the tool spindle.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub workpiece_probe: Option<WorkpieceProbe>,
    /// How often the measurement is repeated with other noise.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub monte_carlo: Option<MonteCarlo>,
    /// Earlier measurements of the tool.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub history: Option<ToolHistory>,
    /// The machine for which programs are written.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub machine: Option<SkivingMachine>,
    /// What to write beside result and report.
    #[serde(default)]
    pub output: SkivingOutput,
}

/// `[readings]`: a file of a real measurement.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TriggerFile {
    /// The table, beside the job file.
    #[schemars(extend("minLength" = 1))]
    pub file: String,
}

/// `[monte_carlo]`: the measurement repeated with other noise.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MonteCarlo {
    /// How often.
    #[serde(default = "default_measurements")]
    #[schemars(extend("minimum" = 10, "maximum" = 100_000, "x-way-out" = "give the number of measurements; 1000 is the default"))]
    pub measurements: usize,
    /// Start of the random numbers.
    #[serde(default = "one")]
    pub seed: u64,
}

fn default_measurements() -> usize {
    1000
}

fn one() -> u64 {
    1
}

/// A list of numbers of one range each, of the given length.
fn list_schema(lengths: [usize; 2], [least, most]: [f64; 2], way_out: &str) -> Schema {
    json_schema!({
        "type": "array",
        "items": { "type": "number", "minimum": least, "maximum": most, "x-way-out": way_out },
        "minItems": lengths[0],
        "maxItems": lengths[1]
    })
}

/// A checked job of measuring a skiving tool.
pub type LoadedSkivingJob = Loaded<SkivingJob>;

impl ProcessJob for SkivingJob {
    const NAME: &'static str = "skiving-tool-measuring";
    const ABOUT: &'static str =
        "Measuring a skiving tool or a shaping cutter in the machine, and correcting the setting by it.";
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
