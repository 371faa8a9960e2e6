//! `[tool_errors]`: a tool with errors, whose measurement is simulated.

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Serialize};

use super::list_schema;
use job::tables::{OneOrSides, one_or_sides_schema};

/// Errors of the whole tool, and of single teeth besides.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ToolErrors {
    /// Eccentricity in x and y of the spindle, um.
    #[schemars(schema_with = "eccentricity_schema")]
    pub eccentricity_um: [f64; 2],
    /// Wobble about x and y of the spindle, urad.
    #[schemars(schema_with = "wobble_schema")]
    pub wobble_urad: [f64; 2],
    /// Pitch deviation of every tooth from tooth 0 on at the pitch circle, um, > 0 counter-clockwise seen from the rake face; default none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(schema_with = "pitch_schema")]
    pub pitch_um: Vec<f64>,
    /// Material beyond the nominal edge of every tooth, um: coefficients of 1, x, x^2, ... over the edge from -1 to 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "sides_of_coefficients_schema")]
    pub profile_um: Option<OneOrSides<Vec<f64>>>,
    /// Growth of the rounding of every tooth, um: wear; coefficients as above.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "sides_of_coefficients_schema")]
    pub edge_growth_um: Option<OneOrSides<Vec<f64>>>,
    /// Standard deviations of errors that differ from tooth to tooth.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub random: Option<RandomErrors>,
    /// Single teeth, in addition to the above.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("maxItems" = 1000))]
    pub teeth: Vec<ToothErrors>,
}

/// Standard deviations of random errors.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct RandomErrors {
    /// Of the pitch at the pitch circle, um.
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give the standard deviation in micrometres"))]
    pub pitch_um: f64,
    /// Of the coefficients of 1, x and x^2 of every edge's profile, um.
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give the standard deviation in micrometres"))]
    pub profile_um: f64,
    /// Of the growth of every edge's rounding, um.
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give the standard deviation in micrometres"))]
    pub edge_growth_um: f64,
    /// Start of the random numbers.
    pub seed: u64,
}

/// Errors of one tooth.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToothErrors {
    /// Its number, from 0.
    #[schemars(extend("minimum" = 0, "maximum" = 999, "x-way-out" = "give the number of the tooth, from 0"))]
    pub tooth: usize,
    /// Whether it is broken off.
    #[serde(default)]
    pub broken: bool,
    /// Its pitch deviation, um.
    #[serde(default)]
    #[schemars(extend("minimum" = -1000, "maximum" = 1000, "x-way-out" = "give the error in micrometres"))]
    pub pitch_um: f64,
    /// Of its left edge.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub left: Option<EdgeErrorsUm>,
    /// Of its right edge.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub right: Option<EdgeErrorsUm>,
}

/// Errors of one edge, um: coefficients of 1, x, x^2, ...
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct EdgeErrorsUm {
    /// Material beyond the nominal edge.
    #[schemars(schema_with = "coefficients_schema")]
    pub profile_um: Vec<f64>,
    /// Growth of the rounding.
    #[schemars(schema_with = "coefficients_schema")]
    pub edge_growth_um: Vec<f64>,
}

const UM: [f64; 2] = [-1000.0, 1000.0];

fn eccentricity_schema(_: &mut SchemaGenerator) -> Schema {
    list_schema([2, 2], UM, "give the eccentricity in x and y in micrometres")
}

fn wobble_schema(_: &mut SchemaGenerator) -> Schema {
    list_schema([2, 2], [-10_000.0, 10_000.0], "give the wobble about x and y in microradians")
}

fn pitch_schema(_: &mut SchemaGenerator) -> Schema {
    list_schema([1, 1000], UM, "give the error of every tooth in micrometres")
}

fn coefficients_schema(_: &mut SchemaGenerator) -> Schema {
    list_schema([0, 8], UM, "give coefficients of 1, x, x^2, ... in micrometres")
}

fn sides_of_coefficients_schema(generator: &mut SchemaGenerator) -> Schema {
    one_or_sides_schema(coefficients_schema(generator))
}
