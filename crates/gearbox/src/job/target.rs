//! `[target]` of the electronic gearbox: what its errors are judged by.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What the errors of gearbox and servo are judged by.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GearboxTarget {
    /// Largest error allowed at the flank, in um, normal: of the rotation over the whole motion, and of the workpiece behind its servo.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000,
        "x-way-out" = "give the tolerance in micrometres, e.g. 5.0"))]
    pub tolerance_um: f64,
}
