//! `[correction]` of the electronic gearbox: rotation that is added over the place of the feed or the angle of the worm
//! (`docs/mathematics/gearbox.md#added-rotation`).

use schemars::{JsonSchema, Schema, json_schema};
use serde::{Deserialize, Serialize};

/// Rotation of the workpiece that is added to that of worm and lead.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GearboxCorrection {
    /// What is added; several add up.
    #[schemars(length(min = 1, max = 20))]
    pub curves: Vec<AddedRotation>,
}

impl GearboxCorrection {
    /// The curves of a job, with their places.
    pub fn curves(given: Option<&Self>) -> &[AddedRotation] {
        given.map_or(&[], |correction| &correction.curves)
    }
}

/// Rotation of the workpiece that is added, as movement of the flank in um, normal; positive turns the workpiece forward.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum AddedRotation {
    /// A polynomial of the place of the feed in mm.
    Polynomial {
        /// Coefficients from that of degree 0 on, um, um/mm, um/mm^2 ..
        #[schemars(schema_with = "coefficients_schema")]
        coefficients_um: Vec<f64>,
    },
    /// A cubic spline through values at equal distances.
    Table {
        /// The axis that it depends on.
        axis: CorrectionAxis,
        /// Position of the first value, mm of the feed or degrees of the worm.
        #[serde(default)]
        #[schemars(extend("minimum" = -1e6, "maximum" = 1e6,
            "x-way-out" = "give the position of the first value in mm or degrees, or leave it out"))]
        start: f64,
        /// Distance of the values, mm of the feed or degrees of the worm.
        #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e6,
            "x-way-out" = "give the distance of the values in mm or degrees, more than 0"))]
        spacing: f64,
        /// The values.
        #[schemars(schema_with = "values_schema")]
        values_um: Vec<f64>,
        /// What is beyond the first and the last value.
        #[serde(default)]
        ends: TableEnds,
    },
}

/// Axis of a correction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CorrectionAxis {
    /// The feed slide.
    Feed,
    /// The worm, over as many turns as it makes.
    Worm,
}

/// Ends of a table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum TableEnds {
    /// The end values are held.
    #[default]
    Natural,
    /// The table repeats; its last value is its first.
    Periodic,
}

fn coefficients_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({
        "type": "array", "minItems": 1, "maxItems": 8,
        "items": {
            "type": "number", "minimum": -1e9, "maximum": 1e9,
            "x-way-out": "give the coefficient in micrometres a power of mm"
        }
    })
}

fn values_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({
        "type": "array", "minItems": 2, "maxItems": 10_000,
        "items": {
            "type": "number", "minimum": -1e5, "maximum": 1e5,
            "x-way-out": "give the value in micrometres at the flank"
        }
    })
}
