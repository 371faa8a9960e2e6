//! `[axes.<name>]`: one axis of a machine.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How an axis moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum AxisType {
    /// Along its direction.
    Linear,
    /// About its direction.
    Rotary,
}

/// An axis, all axes at zero. Directions and points in the machine frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AxisEntry {
    /// How it moves.
    #[serde(rename = "type")]
    pub kind: AxisType,
    /// Unit vector along or about which a positive value moves the body that the axis carries.
    pub direction: [f64; 3],
    /// A point of a rotary axis; default the origin.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub point_mm: Option<[f64; 3]>,
    /// Lower end of travel of a linear axis.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub min_mm: Option<f64>,
    /// Upper end of travel of a linear axis.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_mm: Option<f64>,
    /// Lower end of travel of a rotary axis.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub min_deg: Option<f64>,
    /// Upper end of travel of a rotary axis.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_deg: Option<f64>,
    /// Whether a rotary axis turns without end; it then has no ends of travel.
    #[serde(default)]
    pub endless: bool,
    /// 1 or -1: the control counts this times the value here; default 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("enum" = [1, -1], "x-way-out" = "write 1 or -1"))]
    pub nc_sign: Option<i8>,
    /// What programs call it unless a control says otherwise: a letter of X Y Z A B C U V W, a name such as "B1", or
    /// "spindle 0".
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minLength" = 1, "maxLength" = 10))]
    pub letter: Option<String>,
    /// Greatest speed, mm/s or deg/s; default without limit.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e9, "x-way-out" = "give the speed in mm/s or deg/s, or leave it out"))]
    pub max_velocity: Option<f64>,
    /// Greatest acceleration, mm/s^2 or deg/s^2; default without limit.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e12, "x-way-out" = "give the acceleration in mm/s^2 or deg/s^2, or leave it out"))]
    pub max_acceleration: Option<f64>,
    /// Greatest jerk, mm/s^3 or deg/s^3; default without limit.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e15, "x-way-out" = "give the jerk in mm/s^3 or deg/s^3, or leave it out"))]
    pub max_jerk: Option<f64>,
    /// Smallest step, mm or deg, if it is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1, "x-way-out" = "give the least increment in mm or deg, or leave it out"))]
    pub resolution: Option<f64>,
}
