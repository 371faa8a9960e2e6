//! `[stock]`: what stands on the flanks before grinding.

use job::tables::{OneOrSides, one_or_sides_schema};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

/// Stock on the flanks before the first stroke, normal to the flank.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Stock {
    /// Over the finished flank, um; one value, or one for each flank.
    #[schemars(schema_with = "allowance")]
    pub allowance_um: OneOrSides<f64>,
    /// What is added to it by diameter, linear in the length of roll between the diameters, constant outside: protuberance and root step are
    /// negative.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("maxItems" = 50))]
    pub profile: Vec<StockPlace>,
    /// How the blank is off centre.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub run_out: Option<RunOut>,
}

fn allowance(_: &mut SchemaGenerator) -> Schema {
    one_or_sides_schema(json_schema!({
        "type": "number",
        "exclusiveMinimum": 0,
        "maximum": 5000,
        "x-way-out": "give the stock in um, e.g. 100"
    }))
}

/// Stock added at a diameter.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StockPlace {
    /// Diameter, mm.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10_000, "x-way-out" = "give a diameter of the profile in mm"))]
    pub diameter: f64,
    /// Added there, um.
    #[schemars(extend("minimum" = -5000, "maximum" = 5000, "x-way-out" = "give the amount in um, negative where material is missing"))]
    pub um: f64,
}

/// The axis of the blank beside that of the finished gear.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RunOut {
    /// Distance of both axes, um.
    #[schemars(extend("minimum" = 0, "maximum" = 2000, "x-way-out" = "give the eccentricity in um: half the run-out"))]
    pub eccentricity_um: f64,
    /// Direction in which the blank is moved, from the middle of space 0 about the axis, degrees; default 0.
    #[serde(default)]
    #[schemars(extend("minimum" = -360, "maximum" = 360, "x-way-out" = "give the angle in degrees"))]
    pub angle_deg: f64,
}
