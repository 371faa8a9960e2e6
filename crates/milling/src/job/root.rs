//! `[milling.root]`: fillet and bottom of the space (`docs/mathematics/milling.md#root-and-clearance`).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The root, left by the corner of the cutter: exactly one of `bottom` and `straight`. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MilledRoot {
    /// y_f: height of the bottom above the root body.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = -1000, "maximum" = 1000, "x-way-out" = "give the height above the root body in mm; 0 is the root body itself"))]
    pub bottom: Option<f64>,
    /// h_b: length of the straight piece between the active flank and the fillet.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give the length of the straight piece in mm"))]
    pub straight: Option<f64>,
    /// Whether a second pass with an upright axis joins both fillets.
    #[serde(default = "yes")]
    pub bottom_pass: bool,
}

/// What is known of the root. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RootBottom {
    /// Height of the bottom above the root body.
    Height(f64),
    /// Length of the straight piece below the active flank.
    Straight(f64),
}

impl MilledRoot {
    /// What is known of the root; a checked job has exactly one of both, and the root body itself stands in for neither.
    pub fn depth(&self) -> RootBottom {
        match (self.bottom, self.straight) {
            (None, Some(straight)) => RootBottom::Straight(straight),
            (bottom, _) => RootBottom::Height(bottom.unwrap_or(0.0)),
        }
    }
}

fn yes() -> bool {
    true
}
