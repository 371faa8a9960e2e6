//! Bodies of a machine that the tool could run into, or that could run into the workpiece: spindles, head, table, tailstock.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use foundation::geometry::TurnedBody;
use nalgebra::Vector3;

/// A cylinder or a frustum of a cone that an axis carries, in the machine frame with all axes at zero. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BodyEntry {
    /// Its name.
    #[schemars(extend("minLength" = 1, "maxLength" = 60))]
    pub name: String,
    /// Name of the axis that carries it; without one it stands on the bed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axis: Option<String>,
    /// Middle of its one end.
    pub from_mm: [f64; 3],
    /// Middle of its other end.
    pub to_mm: [f64; 3],
    /// Diameter, of a cone that of its first end.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10_000, "x-way-out" = "give the diameter in mm"))]
    pub diameter_mm: f64,
    /// Diameter of the other end of a cone; default that of a cylinder.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0, "maximum" = 10_000, "x-way-out" = "give the diameter in mm, or leave it out for a cylinder"))]
    pub end_diameter_mm: Option<f64>,
}

impl BodyEntry {
    /// The body with all axes at zero; `None` for one without length.
    pub fn body(&self) -> Option<TurnedBody> {
        let ends = [self.from_mm, self.to_mm].map(Vector3::from);
        let end = self.end_diameter_mm.unwrap_or(self.diameter_mm);
        TurnedBody::new(ends, [0.5 * self.diameter_mm, 0.5 * end])
    }
}
