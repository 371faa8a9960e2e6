//! `[gear]` of five-axis milling: the table that every process has, and halves of opposite hand.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use job::tables::Gear;

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
    /// z_0: where the halves would meet, mm from the middle of the face; the middle of the gap.
    #[serde(default)]
    #[schemars(extend("minimum" = -5000, "maximum" = 5000, "x-way-out" = "give the position in mm; 0, the middle of the face, is the default"))]
    pub apex: f64,
    /// Width of the gap between the halves, mm; 0: herringbone teeth.
    #[schemars(extend("minimum" = 0, "maximum" = 5000, "x-way-out" = "give the width of the gap in mm; 0 for herringbone teeth"))]
    pub gap: f64,
}

impl DoubleHelical {
    /// Ends of the teeth of a gear of this face width, mm: of the half towards +z, then of that towards -z.
    pub fn faces(&self, face_width: f64) -> [[f64; 2]; 2] {
        let (end, gap) = (0.5 * face_width, 0.5 * self.gap);
        [[self.apex + gap, end], [-end, self.apex - gap]]
    }
}
