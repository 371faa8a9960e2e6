//! What can be done with a job.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What is to be done with a job.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Task {
    /// From the target to settings, motions and a proven flank; a job of the electronic gearbox is run.
    Plan,
    /// From settings to the flank.
    Simulate,
    /// What varies side by side, ranked.
    Explore,
    /// The simulated machine of the job, measured and corrected.
    Inspect,
}

impl Task {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Plan, Self::Simulate, Self::Explore, Self::Inspect];

    /// Its word, that of the command.
    pub fn name(self) -> &'static str {
        match self {
            Self::Plan => "plan",
            Self::Simulate => "simulate",
            Self::Explore => "explore",
            Self::Inspect => "inspect",
        }
    }
}
