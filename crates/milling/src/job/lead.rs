//! `milling.lead_in` and `milling.lead_out`: how the cutter comes to a row and leaves it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// An arc that touches the row, and a straight piece before it (behind it where the cutter leaves). Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Lead {
    /// Radius of the arc.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the radius of the arc in mm, e.g. 0.5"))]
    pub radius: f64,
    /// Angle of the arc, degrees; 90 is a quarter circle.
    #[serde(default = "quarter")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 90, "x-way-out" = "give the angle of the arc in degrees; 90 is the default"))]
    pub angle_deg: f64,
    /// Length of the straight piece, which touches the arc.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give the length of the straight piece in mm; 0 is the default"))]
    pub straight: f64,
}

fn quarter() -> f64 {
    90.0
}
