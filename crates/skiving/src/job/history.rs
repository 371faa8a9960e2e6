//! `[history]`: earlier measurements of the tool.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Where measurements of the tool are kept, and what is to be noted of this one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToolHistory {
    /// The file, one measurement a line (JSON), beside the job file; it is made if it is missing.
    #[schemars(extend("minLength" = 1))]
    pub file: String,
    /// Which tool: its number or name.
    #[schemars(extend("minLength" = 1, "maxLength" = 100))]
    pub tool: String,
    /// When it was measured, e.g. "2026-03-01T09:30:00Z".
    #[schemars(extend("minLength" = 1, "maxLength" = 40))]
    pub time: String,
    /// Workpieces that it has cut since it was ground.
    #[schemars(extend("minimum" = 0, "maximum" = 1e9, "x-way-out" = "give the number of workpieces cut since the tool was ground"))]
    pub parts: f64,
    /// How often it has been ground again.
    #[serde(default)]
    #[schemars(extend("maximum" = 10_000))]
    pub resharpened: u32,
}
