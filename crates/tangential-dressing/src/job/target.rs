//! `[target]` of tangential dressing: the wanted flank.

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Serialize};

use job::tables::{Modification, OneOrSides, default_tolerance, one_or_sides_schema};

/// The wanted flank: exactly one of `modifications` and `edge_amounts`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TangentialTarget {
    /// Largest deviation allowed between target and simulated flank, in um, normal to the flank.
    #[serde(default = "default_tolerance")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000,
        "x-way-out" = "give the tolerance in micrometres, e.g. 1.0"))]
    pub tolerance_um: f64,
    /// Modifications that add up; amounts are transverse, positive = material removed. An empty list asks for
    /// the pure involute.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub modifications: Option<Vec<Modification>>,
    /// Amounts at the edge of the evaluated field, one set for both flanks or one for each.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "edge_amounts_schema")]
    pub edge_amounts: Option<OneOrSides<EdgeAmounts>>,
}

/// Material removed at the edge of the evaluated field, um, normal to the flank: of
/// xi = (R - r_m)/(r_e - r_m) over the radius and eta = 2 Z/b_g over the face width.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct EdgeAmounts {
    /// Of xi: at the tip end; as much is left at the root end.
    #[schemars(extend("minimum" = -1000, "maximum" = 1000, "x-way-out" = "give the amount in micrometres"))]
    pub pressure_angle_um: f64,
    /// Of xi^2: at both ends of the profile.
    #[schemars(extend("minimum" = -1000, "maximum" = 1000, "x-way-out" = "give the amount in micrometres"))]
    pub profile_crowning_um: f64,
    /// Of eta: at the face at +z; as much is left at the other.
    #[schemars(extend("minimum" = -1000, "maximum" = 1000, "x-way-out" = "give the amount in micrometres"))]
    pub lead_conical_um: f64,
    /// Of eta^2: at both faces.
    #[schemars(extend("minimum" = -1000, "maximum" = 1000, "x-way-out" = "give the amount in micrometres"))]
    pub lead_crowning_um: f64,
}

fn edge_amounts_schema(generator: &mut SchemaGenerator) -> Schema {
    one_or_sides_schema(generator.subschema_for::<EdgeAmounts>())
}
