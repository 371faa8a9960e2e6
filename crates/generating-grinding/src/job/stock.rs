//! `[stock]`: what stands on the flanks before grinding.

use foundation::geometry::Flank;
use job::tables::{OneOrSides, one_or_sides_schema};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

/// Stock on the flanks before the first stroke, normal to the flank.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Stock {
    /// Over the finished flank, um; one value, or one for each flank. Default 0 beside `map`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "allowance")]
    pub allowance_um: Option<OneOrSides<f64>>,
    /// A table that is added to it: columns flank, w_mm, z_mm, um and, for a table of each tooth, space (0 to teeth - 1). Bilinear between its
    /// places, beyond its rim as on it. `flankwright inspect BLANK --job JOB --blank` writes it of a measured blank (stock.csv).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub map: Option<String>,
    /// What is added to it by diameter, linear in the length of roll between the diameters, constant outside: protuberance and root step are
    /// negative.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("maxItems" = 50))]
    pub profile: Vec<StockPlace>,
    /// What is added to it over the flank as um u^i y^j, u from -1 at the form diameter to 1 at the tip, y from -1 to 1 over the face width.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("maxItems" = 50))]
    pub terms: Vec<StockTerm>,
    /// What is added to it in each tooth space by pitch deviations of the blank, um: a value for every space.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pitch_um: Option<PitchStock>,
    /// How the blank is off centre.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub run_out: Option<RunOut>,
    /// Feed marks of the hob.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hob: Option<HobMarks>,
}

/// Stock added over the flank.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StockTerm {
    /// Power of u along the profile; default 0.
    #[serde(default)]
    #[schemars(extend("maximum" = 8, "x-way-out" = "give a small whole number, e.g. 1"))]
    pub i: u32,
    /// Power of y along the face width; default 0.
    #[serde(default)]
    #[schemars(extend("maximum" = 8, "x-way-out" = "give a small whole number, e.g. 2"))]
    pub j: u32,
    /// Amount, um.
    #[schemars(extend("minimum" = -5000, "maximum" = 5000, "x-way-out" = "give the amount in um"))]
    pub um: f64,
    /// The flank that has it; default both.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flank: Option<Flank>,
}

/// Values for each tooth space, space 0 first, in the sense of rising angle about the gear's axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PitchStock {
    /// Left flanks, um.
    #[schemars(extend("maxItems" = 2000), inner(range(min = -5000, max = 5000)))]
    pub left: Vec<f64>,
    /// Right flanks, um.
    #[schemars(extend("maxItems" = 2000), inner(range(min = -5000, max = 5000)))]
    pub right: Vec<f64>,
}

/// Feed marks of a hob: parabolas along the face width.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HobMarks {
    /// Axial feed of the hob per revolution of the workpiece, mm.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100, "x-way-out" = "give the feed in mm, e.g. 2.5"))]
    pub feed: f64,
    /// Height of the marks above their bottom, um; given by this, or by `tip_diameter` and `threads` of the hob.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give the height in um, e.g. 8"))]
    pub height_um: Option<f64>,
    /// Tip diameter of the hob, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the tip diameter in mm, e.g. 80"))]
    pub tip_diameter: Option<f64>,
    /// Threads of the hob.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 1, "maximum" = 50, "x-way-out" = "give the number of threads, e.g. 2"))]
    pub threads: Option<u32>,
    /// Where along the face width a mark has its bottom at the base circle, mm; default 0.
    #[serde(default)]
    #[schemars(extend("minimum" = -1000, "maximum" = 1000, "x-way-out" = "give the place in mm, or leave it out"))]
    pub origin: f64,
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
