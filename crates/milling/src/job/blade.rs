//! `[blade]`: one side of the blades of an impeller, ruled or through points (`docs/mathematics/milling.md#flanks-as-patches`).

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Serialize};

use super::naca::NacaBlade;
use super::pair_schema;
use foundation::geometry::Flank;

/// Blades on a hub about +z: exactly one of `ruled`, `points` and `naca`. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Blade {
    /// Number of blades.
    #[schemars(extend("minimum" = 1, "maximum" = 1000, "x-way-out" = "give the number of blades"))]
    pub count: u32,
    /// Radius of the hub where the blade begins and where it ends along the axis.
    #[schemars(schema_with = "radii_schema")]
    pub hub_radius: [f64; 2],
    /// The part of the height that is milled, from 0 at the hub to 1 at the tip.
    #[serde(default = "whole_height")]
    #[schemars(schema_with = "height_schema")]
    pub active_height: [f64; 2],
    /// Thickness of the blade at hub and tip, along the normal of the side that is milled and linear over the height: its back, which
    /// the cutter keeps away from. Without it the back of the blade across the passage is not judged.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "thickness_schema")]
    pub thickness: Option<[f64; 2]>,
    /// Straight lines between a curve on the hub and one on a cylinder.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ruled: Option<RuledBlade>,
    /// A surface through points.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub points: Option<BladePoints>,
    /// Sections by four digits.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub naca: Option<NacaBlade>,
}

/// Lines from the hub's curve, azimuth th = th_0 + (th_1 - th_0) u^2 at the share u of the length, to the curve at the tip, which
/// is ahead by an angle linear in u.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RuledBlade {
    /// Radius of the cylinder on which the lines end, mm.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10_000, "x-way-out" = "give the radius at the blade's tip in mm"))]
    pub tip_radius: f64,
    /// Length along the axis, mm, from z = 0.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 5000, "x-way-out" = "give the length along the axis in mm"))]
    pub length: f64,
    /// th_0, th_1: azimuth on the hub at both ends, counter-clockwise from +y, degrees.
    #[schemars(schema_with = "azimuth_schema")]
    pub azimuth_deg: [f64; 2],
    /// How far the tip is ahead of the hub at both ends, degrees.
    #[schemars(schema_with = "lead_schema")]
    pub tip_lead_deg: [f64; 2],
    /// The side that is milled.
    pub side: BladeSide,
}

/// A grid of points: rows along the blade, the first at the hub; at least 4 x 4.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BladePoints {
    /// Table (CSV) with the columns x_mm, y_mm, z_mm beside the job file, row after row.
    #[schemars(extend("minLength" = 1))]
    pub file: String,
    /// Number of rows, from hub to tip.
    #[schemars(extend("minimum" = 4, "maximum" = 2000, "x-way-out" = "give the number of rows of the table, 4 or more"))]
    pub rows: usize,
    /// Number of points in a row.
    #[schemars(extend("minimum" = 4, "maximum" = 2000, "x-way-out" = "give the number of points in a row, 4 or more"))]
    pub columns: usize,
    /// The side that is milled.
    pub side: BladeSide,
}

/// Side of a blade: left where the normal out of the material is that of (towards the tip) x (along the row).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum BladeSide {
    /// Sign +1.
    Left,
    /// Sign -1.
    Right,
}

impl BladeSide {
    /// +1 for left, -1 for right.
    pub fn sign(self) -> f64 {
        match self {
            Self::Left => 1.0,
            Self::Right => -1.0,
        }
    }

    /// The flank under whose name results stand.
    pub fn flank(self) -> Flank {
        match self {
            Self::Left => Flank::Left,
            Self::Right => Flank::Right,
        }
    }
}

impl Blade {
    /// The side that is milled; `None` only for a table that was built in code without a surface.
    pub fn side(&self) -> Option<BladeSide> {
        let drawn = self.ruled.map(|ruled| ruled.side).or(self.points.as_ref().map(|points| points.side));
        drawn.or(self.naca.as_ref().map(|naca| naca.side.side()))
    }
}

fn whole_height() -> [f64; 2] {
    [0.0, 1.0]
}

fn radii_schema(_: &mut SchemaGenerator) -> Schema {
    pair_schema(1e-3, 10_000.0, "give the radius of the hub in mm")
}

fn height_schema(_: &mut SchemaGenerator) -> Schema {
    pair_schema(0.0, 1.0, "give a share of the height, 0 at the hub and 1 at the tip")
}

fn thickness_schema(_: &mut SchemaGenerator) -> Schema {
    pair_schema(1e-3, 1000.0, "give the thickness at hub and tip in mm, e.g. [4.0, 2.0], or leave it out")
}

fn azimuth_schema(_: &mut SchemaGenerator) -> Schema {
    pair_schema(-720.0, 720.0, "give the azimuth in degrees")
}

fn lead_schema(_: &mut SchemaGenerator) -> Schema {
    pair_schema(-180.0, 180.0, "give the angle in degrees")
}
