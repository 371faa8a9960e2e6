//! The whole description of a machine as a file has it.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{AxisEntry, BodyEntry, Controls};

/// A machine. Lengths in mm, angles in degrees, times in s.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MachineFile {
    /// Its name.
    #[schemars(extend("minLength" = 1, "maxLength" = 60))]
    pub name: String,
    /// What it is, in a sentence.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub about: Option<String>,
    /// Which axis does what; a machine for milling needs none.
    #[serde(default)]
    pub roles: Roles,
    /// All axes by their names.
    #[schemars(extend("minProperties" = 1, "maxProperties" = 12))]
    pub axes: BTreeMap<String, AxisEntry>,
    /// The limbs.
    pub chains: Chains,
    /// Spindles, head, table, tailstock as bodies of revolution, from which programs keep away; default none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("maxItems" = 20))]
    pub bodies: Vec<BodyEntry>,
    /// The controls for which programs are written; default none.
    #[serde(default)]
    pub controls: Controls,
}

/// Names of the axes by what they do.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Roles {
    /// Infeed between tool and workpiece.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub radial: Option<String>,
    /// Along the workpiece axis.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axial: Option<String>,
    /// Tilt of the tool head.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tilt: Option<String>,
    /// Shift of the tool along its axis, above the tilt.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shift: Option<String>,
    /// Tangential slide, below the tilt; instead of a shift.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tangential: Option<String>,
    /// Rotation of the tool.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub worm: Option<String>,
    /// Rotation of the workpiece.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub work: Option<String>,
    /// Swivel of the dresser.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub swivel: Option<String>,
    /// Rotation of the dresser.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dresser: Option<String>,
}

/// The limbs from the bed to the spindles.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Chains {
    /// To the tool.
    pub tool: ChainEntry,
    /// To the workpiece.
    pub work: ChainEntry,
    /// To the dresser, if there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dresser: Option<ChainEntry>,
}

/// A limb.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ChainEntry {
    /// Names of its axes, from the bed outwards.
    #[schemars(extend("maxItems" = 12))]
    pub axes: Vec<String>,
    /// The spindle, all axes at zero.
    pub frame: FrameEntry,
}

/// A spindle frame in the machine frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FrameEntry {
    /// Its origin; default that of the machine frame.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub origin_mm: Option<[f64; 3]>,
    /// Direction of its x, a unit vector.
    pub x: [f64; 3],
    /// Direction of its z, the spindle axis, a unit vector.
    pub z: [f64; 3],
}
