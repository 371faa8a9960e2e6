//! `[grid_gear]`: a gear whose flanks are given by points, as hypoid gears and flanks of other programs are.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::pair_schema;
use schemars::{Schema, SchemaGenerator};

/// A gear about +z with external teeth whose flanks are surfaces through points; the space that they bound stands about +y. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GridGear {
    /// Number of teeth.
    #[schemars(extend("minimum" = 3, "maximum" = 2000, "x-way-out" = "give the number of teeth of the drawing"))]
    pub teeth: u32,
    /// Points of the left flank of the space.
    pub left: FlankPoints,
    /// Points of the right flank.
    pub right: FlankPoints,
    /// The body that the teeth stand on.
    pub root: BodyLine,
    /// The body that their tips lie on.
    pub tip: BodyLine,
}

/// A grid of points: rows along the tooth, the first where the active flank begins and the last at the tip; at least 4 x 4. All rows of
/// both flanks run from the same end of the face.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FlankPoints {
    /// Table (CSV) with the columns x_mm, y_mm, z_mm beside the job file, row after row.
    #[schemars(extend("minLength" = 1))]
    pub file: String,
    /// Number of rows, from root to tip.
    #[schemars(extend("minimum" = 4, "maximum" = 2000, "x-way-out" = "give the number of rows of the table, 4 or more"))]
    pub rows: usize,
    /// Number of points in a row.
    #[schemars(extend("minimum" = 4, "maximum" = 2000, "x-way-out" = "give the number of points in a row, 4 or more"))]
    pub columns: usize,
}

/// A cone or cylinder about +z by both of its ends, in the order of the points of a row.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BodyLine {
    /// Radii at both ends.
    #[schemars(schema_with = "radii_schema")]
    pub radii: [f64; 2],
    /// Positions of both ends.
    #[schemars(schema_with = "positions_schema")]
    pub positions: [f64; 2],
}

fn radii_schema(_: &mut SchemaGenerator) -> Schema {
    pair_schema(0.01, 10_000.0, "give the radii at both ends of the face in mm")
}

fn positions_schema(_: &mut SchemaGenerator) -> Schema {
    pair_schema(-10_000.0, 10_000.0, "give the positions of both ends in mm")
}

impl BodyLine {
    /// Its ends as (radius, position).
    pub fn ends(&self) -> [[f64; 2]; 2] {
        [0, 1].map(|k| [self.radii[k], self.positions[k]])
    }
}
