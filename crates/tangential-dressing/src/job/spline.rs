//! Splines that add to a channel what powers follow badly.

use schemars::{JsonSchema, Schema, json_schema};
use serde::{Deserialize, Serialize};

use super::channel::{Channel, spline_schema};

/// A channel that has a spline beside its powers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SplineChoice {
    /// The channel; every one but `kap`.
    #[schemars(schema_with = "spline_schema")]
    pub channel: Channel,
    /// Intervals of equal length.
    #[schemars(extend("minimum" = 1, "maximum" = 64, "x-way-out" = "give the number of intervals, e.g. 6"))]
    pub intervals: usize,
}

/// A spline with its values.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SplineValues {
    /// The channel; every one but `kap`.
    #[schemars(schema_with = "spline_schema")]
    pub channel: Channel,
    /// Intervals of equal length.
    #[schemars(extend("minimum" = 1, "maximum" = 64, "x-way-out" = "give the number of intervals, as in the plan"))]
    pub intervals: usize,
    /// Coefficients of the basis functions, mm; of `gA` rad.
    #[schemars(schema_with = "coefficients_schema")]
    pub coefficients: Vec<f64>,
}

fn coefficients_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({ "type": "array", "items": coefficient_schema(), "minItems": 1, "maxItems": 100 })
}

/// The coefficient of a variable or a spline: beyond its range no machine follows.
pub(super) fn coefficient_schema() -> Schema {
    json_schema!({
        "type": "number", "minimum": -1000, "maximum": 1000,
        "x-way-out": "give the coefficient in mm (of `gA` in rad)"
    })
}
