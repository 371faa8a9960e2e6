//! `[target]` of skiving: the wanted profile.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use job::tables::Modification;

/// The wanted flank of the workpiece; without modifications the involute.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SkivingTarget {
    /// Largest deviation allowed of the workpiece's profile that the mean tooth will leave, um, normal to the flank.
    #[serde(default = "default_tolerance")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000,
        "x-way-out" = "give the tolerance in micrometres, e.g. 10.0"))]
    pub tolerance_um: f64,
    /// Modifications of the profile that add up; amounts are transverse, positive = material removed. Those along the tooth are made by
    /// the motion of the machine, not by the tool.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub modifications: Option<Vec<Modification>>,
}

fn default_tolerance() -> f64 {
    10.0
}

impl Default for SkivingTarget {
    fn default() -> Self {
        Self { tolerance_um: default_tolerance(), modifications: None }
    }
}
