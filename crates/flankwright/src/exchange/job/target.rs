//! `[target]`: the wanted flank.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::modification::ModificationSpec;

/// One entry of `modifications`: a table with `kind` and the keys of that kind.
pub type Modification = ModificationSpec;

/// The wanted flank: modifications of the involute, or a grid of values from a file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Target {
    /// Largest deviation allowed between target and simulated flank, in um, normal to the flank.
    #[serde(default = "default_tolerance")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000,
        "x-way-out" = "give the tolerance in micrometres, e.g. 1.0"))]
    pub tolerance_um: f64,
    /// Modifications that add up; amounts are transverse, positive = material removed. An empty list asks for
    /// the pure involute.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub modifications: Option<Vec<Modification>>,
    /// Table of values (CSV with the columns w_mm, z_mm, f_um), beside the job file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minLength" = 1))]
    pub file: Option<String>,
}

fn default_tolerance() -> f64 {
    1.0
}
