//! `[milling]`: rows, orientation of the cutter, contact, order and speeds.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::contact_height::ContactHeight;
use super::coolant::CutterCoolant;
use super::density::{Density, GridChoice};
use super::lead::Lead;
use super::root::MilledRoot;
use super::roughing::Roughing;
use job::tables::Flanks;

/// How the flanks are milled. The grid by `rows` and `columns`, or by one or more of `density`, `scallop_um`, `chord_um`. Rows count
/// from 0 at the root. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Milling {
    /// Flanks of a gear or bevel gear that are milled; default both. A blade has the side of its table.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flanks: Option<Flanks>,
    /// Number of rows, from root to tip.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 2, "maximum" = 20_000, "x-way-out" = "give the number of rows, 2 or more"))]
    pub rows: Option<usize>,
    /// Number of columns, along the tooth.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 2, "maximum" = 20_000, "x-way-out" = "give the number of columns, 2 or more"))]
    pub columns: Option<usize>,
    /// Limits of the distances between neighbouring points.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub density: Option<Density>,
    /// Greatest height of the scallops between rows, um.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the height in micrometres, e.g. 5.0"))]
    pub scallop_um: Option<f64>,
    /// Greatest deviation of straight blocks from a curved row, um.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the deviation in micrometres, e.g. 1.0"))]
    pub chord_um: Option<f64>,
    /// How rows lie between root and tip.
    #[serde(default)]
    pub row_spacing: RowDistances,
    /// Lean of the shank away from the flank, degrees.
    #[serde(default)]
    #[schemars(extend("exclusiveMinimum" = -90, "exclusiveMaximum" = 90, "x-way-out" = "give the lean in degrees, or leave it out"))]
    pub tilt_deg: f64,
    /// Lean in the last row, at the tip, where rows lean differently: from `tilt_deg` in the first one linear in the row's number. It
    /// spreads the wear over the edge of a ball, a barrel or a rounded corner.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = -90, "exclusiveMaximum" = 90, "x-way-out" = "give the lean in degrees, or leave it out"))]
    pub tilt_at_tip_deg: Option<f64>,
    /// Turn of the axis about the flank's normal, degrees; with it the axis leaves the column plane.
    #[serde(default)]
    #[schemars(extend("exclusiveMinimum" = -90, "exclusiveMaximum" = 90, "x-way-out" = "give the angle in degrees, or leave it out"))]
    pub lead_angle_deg: f64,
    /// Turn of the column planes about the base body's normal, degrees.
    #[serde(default)]
    #[schemars(extend("exclusiveMinimum" = -90, "exclusiveMaximum" = 90, "x-way-out" = "give the angle in degrees, or leave it out"))]
    pub skew_deg: f64,
    /// Row of a cylindrical gear whose normals lie in the column planes: the guide curve is laid on the cylinder with which they do;
    /// default the guide curve lies on the root cylinder.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0, "maximum" = 19_999, "x-way-out" = "give the number of a row, 0 at the root"))]
    pub lead_through_row: Option<usize>,
    /// How far the guide curve goes on beyond the range of the face at both ends; default so far that the cutter leaves the face, its
    /// radius and 1 mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give the overrun in mm, or leave it out"))]
    pub overrun: Option<f64>,
    /// Height above the tip at which the straight side of an end mill, torus or cone touches; a number, `{ from, to }` from root to tip, or
    /// a list with one for each row.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contact_height: Option<ContactHeight>,
    /// What the cutter keeps from everything that it does not finish.
    #[serde(default = "default_safety_distance")]
    #[schemars(extend("minimum" = 0, "maximum" = 100, "x-way-out" = "give the distance in mm; 0.2 is the default"))]
    pub safety_distance: f64,
    /// With or against the feed; of a zigzag the first row.
    #[serde(default)]
    pub direction: CutSense,
    /// How rows follow each other.
    #[serde(default)]
    pub traverse: Traversal,
    /// Which row comes first.
    #[serde(default)]
    pub order: RowSequence,
    /// Radius of a quarter circle on which the cutter comes to and leaves a row, in place of both `lead_in` and `lead_out`; default it comes in over the overrun.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the radius in mm, or leave it out"))]
    pub approach_radius: Option<f64>,
    /// How the cutter comes to a row, behind the overrun; default over the overrun alone.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lead_in: Option<Lead>,
    /// How the cutter leaves a row, behind the overrun; default over the overrun alone.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lead_out: Option<Lead>,
    /// Spaces that are milled.
    #[serde(default)]
    pub teeth: Spaces,
    /// Speed of the contact along the row, mm/min.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e5, "x-way-out" = "give the feed in mm/min, e.g. 1200"))]
    pub feed_mm_per_min: f64,
    /// Speed towards the row, mm/min; default the feed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e5, "x-way-out" = "give the feed in mm/min, or leave it out"))]
    pub plunge_feed_mm_per_min: Option<f64>,
    /// Speed of the spindle, 1/min.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 200_000, "x-way-out" = "give the speed in 1/min, e.g. 8000"))]
    pub spindle_rpm: f64,
    /// Coolant of cutters that say nothing else.
    #[serde(default)]
    pub coolant: CutterCoolant,
    /// The root of the space; without it nothing is milled below the active flank.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub root: Option<MilledRoot>,
    /// Clearing the space before; without it the space is taken to be cleared.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub roughing: Option<Roughing>,
}

impl Milling {
    /// Whether the axis leans in any row.
    pub fn leans(&self) -> bool {
        self.tilts_deg().into_iter().any(|tilt| tilt != 0.0)
    }

    /// Leans of the first and of the last row, degrees.
    pub fn tilts_deg(&self) -> [f64; 2] {
        [self.tilt_deg, self.tilt_at_tip_deg.unwrap_or(self.tilt_deg)]
    }

    /// How many rows and columns there are. A checked job has both numbers or none.
    pub fn grid(&self) -> GridChoice {
        match (self.rows, self.columns) {
            (Some(rows), Some(columns)) => GridChoice::Counts { rows, columns },
            _ => GridChoice::Limits {
                density: self.density.unwrap_or_default(),
                scallop_um: self.scallop_um,
                chord_um: self.chord_um,
            },
        }
    }
}

/// The law by which rows lie between root and tip.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum RowDistances {
    /// Equal arcs of the column.
    #[default]
    Arc,
    /// Equal steps of the flank's height parameter.
    Parameter,
    /// Scallops of equal height.
    Scallop,
}

/// With or against the feed, the spindle turning clockwise seen from the shank.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum CutSense {
    /// Chips begin thick.
    #[default]
    Climb,
    /// Chips begin thin.
    Conventional,
}

/// How rows follow each other.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Traversal {
    /// All in one sense.
    #[default]
    OneWay,
    /// To and fro.
    Zigzag,
}

/// Which row comes first.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RowSequence {
    /// From the tip down, so that the material below supports.
    #[default]
    TipToRoot,
    /// From the root up.
    RootToTip,
}

/// Spaces that are milled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Spaces {
    /// One after the other, all around.
    #[default]
    All,
    /// The one about +y.
    One,
}

fn default_safety_distance() -> f64 {
    0.2
}
