//! `[measuring]`: tracks, poses, senses, revolutions, what the machine allows.

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Serialize};

use super::list_schema;
use crate::measuring::Sense;

/// How the tool is measured. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ToolMeasuring {
    /// Places of the tracks along the edge, -1 at the smaller and 1 at the larger length of roll of the workpiece, ascending.
    #[schemars(schema_with = "tracks_schema")]
    pub tracks: Vec<f64>,
    /// How the beam lies on the edge.
    pub poses: MeasuringPoses,
    /// Senses in which the spindle turns; only both remove the delay of the barrier.
    pub senses: Senses,
    /// Revolutions in each sense.
    #[schemars(extend("minimum" = 1, "maximum" = 10_000, "x-way-out" = "give the number of revolutions, e.g. 4"))]
    pub revolutions: usize,
    /// Speed of the tool spindle, 1/min.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100_000, "x-way-out" = "give the speed in 1/min, e.g. 120"))]
    pub speed_rpm: f64,
    /// Time from one pose to the next, s.
    #[schemars(extend("minimum" = 0, "maximum" = 3600, "x-way-out" = "give the time in seconds, e.g. 2"))]
    pub move_time_s: f64,
    /// Largest angle between the beam and the flank's helix, degrees.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 90, "x-way-out" = "give the angle in degrees; 15 is the default"))]
    pub most_off_flank_deg: f64,
    /// Depth of the clearance faces that may shade the beam.
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give the depth of the tool's body below the edge in mm, e.g. 5"))]
    pub body_depth: f64,
    /// Travel of the axes while they measure; default without ends.
    #[serde(skip_serializing_if = "Travel::is_free")]
    pub travel: Travel,
    /// How tooth 0 is clamped: its turn against its nominal angle, degrees, counter-clockwise > 0; known to half a pitch. By default
    /// tooth 0 is the one that stands nearest to its nominal angle: the light of all tracks tells the clamping up to whole pitches.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = -360, "maximum" = 360, "x-way-out" = "give the turn of tooth 0 in degrees, from -360 to 360, or leave it out"))]
    pub clocking_deg: Option<f64>,
    /// Start of the random numbers of a simulated measurement.
    pub seed: u64,
}

/// How the beam lies on the edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum MeasuringPoses {
    /// Tangential, the tool turned as it stands when it cuts there.
    #[default]
    Tangent,
    /// Along the flank's helix, or as near to it as two axes come.
    AlongFlank,
}

/// Senses of the spindle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Senses {
    /// Growing B, then falling B.
    #[default]
    Both,
    /// Growing B.
    Positive,
    /// Falling B.
    Negative,
}

/// Ends of travel, [least, greatest]; what is left out has none.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Travel {
    /// Swivel A, degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "angles_schema")]
    pub a_deg: Option<[f64; 2]>,
    /// X.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "lengths_schema")]
    pub x: Option<[f64; 2]>,
    /// Y.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "lengths_schema")]
    pub y: Option<[f64; 2]>,
    /// Z.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "lengths_schema")]
    pub z: Option<[f64; 2]>,
}

impl Default for ToolMeasuring {
    fn default() -> Self {
        Self {
            tracks: crate::default_track_places(),
            poses: MeasuringPoses::default(),
            senses: Senses::default(),
            revolutions: 4,
            speed_rpm: 120.0,
            move_time_s: 2.0,
            most_off_flank_deg: 15.0,
            body_depth: 5.0,
            travel: Travel::default(),
            clocking_deg: None,
            seed: 1,
        }
    }
}

impl Senses {
    /// The senses in their order.
    pub fn list(self) -> &'static [Sense] {
        match self {
            Self::Both => &Sense::BOTH,
            Self::Positive => &[Sense::Positive],
            Self::Negative => &[Sense::Negative],
        }
    }
}

impl Travel {
    fn is_free(&self) -> bool {
        *self == Self::default()
    }

    /// Key and ends of the axes that have any.
    pub(super) fn ends(&self) -> impl Iterator<Item = (&'static str, [f64; 2])> {
        let all = [("a_deg", self.a_deg), ("x", self.x), ("y", self.y), ("z", self.z)];
        all.into_iter().filter_map(|(key, ends)| ends.map(|ends| (key, ends)))
    }
}

fn tracks_schema(_: &mut SchemaGenerator) -> Schema {
    list_schema([1, 101], [-1.0, 1.0], "give places from -1 to 1, e.g. -0.8, -0.4, 0, 0.4, 0.8")
}

fn angles_schema(_: &mut SchemaGenerator) -> Schema {
    list_schema([2, 2], [-180.0, 180.0], "give the least and the greatest angle in degrees")
}

fn lengths_schema(_: &mut SchemaGenerator) -> Schema {
    list_schema([2, 2], [-100_000.0, 100_000.0], "give the least and the greatest position in mm")
}
