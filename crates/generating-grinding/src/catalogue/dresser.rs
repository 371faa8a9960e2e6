//! `[[dresser]]`: a disc dresser of a catalogue.

use schemars::{JsonSchema, Schema, json_schema};
use serde::{Deserialize, Serialize};

use crate::job::DesignedFor;
use job::tables::{OneOrSides, one_or_sides_schema};

/// A disc dresser that is there. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DresserEntry {
    /// What the shop calls it; each name once.
    #[schemars(extend("minLength" = 1, "maxLength" = 100))]
    pub name: String,
    /// Tip diameter.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the tip diameter of the dresser in mm"))]
    pub tip_diameter: f64,
    /// Pitch diameter; with it the dressing centre distance is the sum of the pitch radii, without it the disc tip touches the
    /// worm root.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000,
        "x-way-out" = "give the pitch diameter of the dresser in mm, or leave it out"))]
    pub pitch_diameter: Option<f64>,
    /// Width of the cylindrical land at the tip.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give the width of the tip land in mm, or leave it out"))]
    pub tip_land: Option<f64>,
    /// Diameters between which its flanks are profiled; default up to the tip, as far down as needed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flank_diameters: Option<FlankDiameters>,
    /// Profile crowning in um that it makes on the gear from form to tip diameter with the worm it was made for; transverse,
    /// positive = convex.
    #[serde(default = "no_crowning")]
    #[schemars(schema_with = "crowning_schema")]
    pub profile_crowning_um: OneOrSides<f64>,
    /// The worm for which it was made.
    pub designed_for: DesignedFor,
}

/// From where to where a dresser has a profile. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FlankDiameters {
    /// Smallest diameter.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the diameter where the profile begins in mm"))]
    pub from: f64,
    /// Largest diameter.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the diameter where the profile ends in mm"))]
    pub to: f64,
}

fn no_crowning() -> OneOrSides<f64> {
    OneOrSides::Both(0.0)
}

fn crowning_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    one_or_sides_schema(json_schema!({
        "type": "number", "minimum": -1000, "maximum": 1000,
        "x-way-out": "give the profile crowning that the dresser carries in micrometres, 0 for a plain one"
    }))
}
