//! `[gear]` of five-axis milling: the table that every process has, and halves of opposite hand.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::exchange::job::Gear;

/// Drawing data of a cylindrical gear: spur, helical, internal, double-helical.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(extend("unevaluatedProperties" = false))]
pub struct MillingGear {
    /// The table as every process has it.
    #[serde(flatten)]
    pub drawing: Gear,
    /// Two halves, mirror images of each other. The half towards +z has `helix_angle_deg`; `face_width` is that of both with the gap.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub double_helical: Option<DoubleHelical>,
}

/// The halves of a double-helical gear.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DoubleHelical {
    /// Width of the gap in the middle of the face, mm; 0: herringbone teeth.
    #[schemars(extend("minimum" = 0, "maximum" = 5000, "x-way-out" = "give the width of the gap in mm; 0 for herringbone teeth"))]
    pub gap: f64,
}
