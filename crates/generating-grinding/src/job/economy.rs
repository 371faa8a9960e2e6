//! `[grinding] prefer` and `[grinding.axis_limits]`: which of the ratios that are good enough is taken, and what a plan may ask of the
//! correcting axes.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What decides among diagonal ratios that keep to half the tolerance and half the limits of the axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Prefer {
    /// The smallest corrections and the smallest deviation.
    Accuracy,
    /// The smallest used width of the worm.
    Worm,
    /// The shortest feed travel.
    Time,
}

/// The largest corrections that a plan may ask of the axes on its own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AxisLimits {
    /// Rotation of the worm while it is dressed, deg; default 10.
    #[serde(default, rename = "d_phi_S_deg", skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 360, "x-way-out" = "give the largest correction in degrees, e.g. 10"))]
    pub d_phi_s_deg: Option<f64>,
    /// Swivel of the dresser, deg; default 3.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 45, "x-way-out" = "give the largest correction in degrees, e.g. 3"))]
    pub d_gamma_deg: Option<f64>,
    /// Radial infeed of the dresser, mm; default 5.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100, "x-way-out" = "give the largest correction in mm, e.g. 5"))]
    pub d_d_mm: Option<f64>,
    /// Tangential offset of the dresser, mm; default 10.
    #[serde(default, rename = "d_v_yA_mm", skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100, "x-way-out" = "give the largest correction in mm, e.g. 10"))]
    pub d_v_ya_mm: Option<f64>,
    /// Radial motion while the gear is ground, mm; default 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100, "x-way-out" = "give the largest correction in mm, e.g. 1"))]
    pub delta_d_mm: Option<f64>,
}
