//! `[job]`: name and process.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Name, process and description of a job.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JobInfo {
    /// Names the job and its output directory; letters, digits, `-`, `_`, `.` and spaces.
    #[schemars(extend("minLength" = 1, "maxLength" = 100))]
    pub name: String,
    /// What is to be planned.
    pub process: Process,
    /// Free text for the report.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub description: Option<String>,
}

/// The processes that have jobs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Process {
    /// Generating grinding with a dressed worm.
    GeneratingGrinding,
    /// Generating grinding with a worm that one motion of the dresser along its tangent has modified.
    TangentialDressing,
    /// The electronic gearbox that turns a helical workpiece while it feeds.
    ElectronicGearbox,
    /// Five-axis milling of gears and blades.
    FiveAxisMilling,
}

impl Process {
    /// All processes that have jobs.
    pub const ALL: [Process; 4] = [
        Process::GeneratingGrinding,
        Process::TangentialDressing,
        Process::ElectronicGearbox,
        Process::FiveAxisMilling,
    ];

    /// Processes that the job format knows and this version does not plan.
    pub const NOT_AVAILABLE: [&str; 1] = ["skiving-tool-measuring"];

    /// The name in job files.
    pub fn name(self) -> &'static str {
        match self {
            Process::GeneratingGrinding => "generating-grinding",
            Process::TangentialDressing => "tangential-dressing",
            Process::ElectronicGearbox => "electronic-gearbox",
            Process::FiveAxisMilling => "five-axis-milling",
        }
    }
}
