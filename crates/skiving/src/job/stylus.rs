//! `[stylus]`: a stylus of cylindrical shape that scans the edges.

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Serialize};

use super::light_barrier::point_schema;

/// The stylus, in machine coordinates. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Stylus {
    /// A point of its axis, at whose height contacts are laid.
    #[schemars(schema_with = "point_schema")]
    pub point: [f64; 3],
    /// Tilt in the X-Z plane, degrees.
    #[serde(default)]
    #[schemars(extend("exclusiveMinimum" = -90, "exclusiveMaximum" = 90, "x-way-out" = "give the tilt in degrees, 0 for an upright stylus"))]
    pub tilt_x_deg: f64,
    /// Tilt in the Y-Z plane, degrees.
    #[serde(default)]
    #[schemars(extend("exclusiveMinimum" = -90, "exclusiveMaximum" = 90, "x-way-out" = "give the tilt in degrees, 0 for an upright stylus"))]
    pub tilt_y_deg: f64,
    /// r_T: its radius.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 50, "x-way-out" = "give the radius of the stylus in mm"))]
    pub radius: f64,
    /// Axes that follow the edge.
    #[serde(default)]
    pub axes: ScanMotion,
    /// Teeth that are scanned, from 0; three or more.
    #[schemars(schema_with = "teeth_schema")]
    pub teeth: Vec<usize>,
    /// Places of each scan.
    #[serde(default = "default_places")]
    #[schemars(extend("minimum" = 2, "maximum" = 10_000, "x-way-out" = "give the number of places; 41 is the default"))]
    pub places: usize,
    /// Speed of the contact along the edge, mm/min.
    #[serde(default = "default_speed")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10_000, "x-way-out" = "give the speed in mm/min; 30 is the default"))]
    pub speed_mm_per_min: f64,
}

/// Axes that follow the edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ScanMotion {
    /// A, B, X, Y; and Z where the stylus is tilted.
    #[default]
    All,
    /// A, B, X: Y stays where it is at the middle of the edge.
    WithoutY,
}

fn default_places() -> usize {
    41
}

fn default_speed() -> f64 {
    30.0
}

fn teeth_schema(_: &mut SchemaGenerator) -> Schema {
    schemars::json_schema!({
        "type": "array",
        "items": { "type": "integer", "minimum": 0, "maximum": 999, "x-way-out": "give numbers of teeth, from 0" },
        "minItems": 3,
        "maxItems": 1000,
        "uniqueItems": true
    })
}
