//! `[job]`: name and process.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::diagnostic::{Diagnostic, Problem};

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
    /// Measuring a skiving tool in the machine, and correcting the setting by it.
    SkivingToolMeasuring,
}

impl Process {
    /// All processes that have jobs.
    pub const ALL: [Process; 5] = [
        Process::GeneratingGrinding,
        Process::TangentialDressing,
        Process::ElectronicGearbox,
        Process::FiveAxisMilling,
        Process::SkivingToolMeasuring,
    ];

    /// The name in job files.
    pub fn name(self) -> &'static str {
        match self {
            Process::GeneratingGrinding => "generating-grinding",
            Process::TangentialDressing => "tangential-dressing",
            Process::ElectronicGearbox => "electronic-gearbox",
            Process::FiveAxisMilling => "five-axis-milling",
            Process::SkivingToolMeasuring => "skiving-tool-measuring",
        }
    }

    /// What a command answers to a job of this process if it does not take it; on the key `job.process`.
    pub fn refused_by(self, command: &str) -> Diagnostic {
        let name = self.name();
        let message = format!("`{command}` does not take a job of the process \"{name}\"");
        Diagnostic::new(Problem::ProcessNotAvailable, message)
            .field("job.process")
            .value(format!("\"{name}\""))
            .allowed(self.others_taken_by(command))
            .way_out("take a job of one of these processes, or another command for this one")
    }

    /// The processes whose jobs a command takes, this one left out.
    pub(crate) fn others_taken_by(self, command: &str) -> String {
        let takes = |process: &Process| match command {
            "explore" | "convert" => *process == Process::GeneratingGrinding,
            "simulate" => !matches!(process, Process::ElectronicGearbox | Process::FiveAxisMilling),
            "plan" | "program check" => *process != Process::ElectronicGearbox,
            _ => true,
        };
        let others = Process::ALL.into_iter().filter(|process| *process != self && takes(process));
        others.map(|process| format!("\"{}\"", process.name())).collect::<Vec<_>>().join(", ")
    }
}
