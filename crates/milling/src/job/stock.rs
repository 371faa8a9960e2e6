//! `[stock]`: what stands on the workpiece before it is milled.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The workpiece as it comes to the machine. Without the table spaces are taken to be cleared, with an allowance that nothing is known
/// of. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MillingStock {
    /// Whether its spaces are cut already.
    pub form: StockForm,
    /// Of a pre-cut part: allowance on its flanks, normal to them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0, "maximum" = 5, "x-way-out" = "give the allowance on the flanks in mm, e.g. 0.2"))]
    pub allowance: Option<f64>,
    /// Of a pre-cut part: how far its clocking angle may be off, either way, degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0, "maximum" = 10, "x-way-out" = "give the uncertainty of the clocking angle in degrees; 0 is the default"))]
    pub clocking_error_deg: Option<f64>,
}

/// A workpiece before it is milled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum StockForm {
    /// A turned blank without teeth.
    Solid,
    /// Spaces are cut, flanks have an allowance.
    PreCut,
}
