//! `[evaluation]`: what the tool is judged by, and which settings of the machine may be changed.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::Setting;

/// What the tool is judged by.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ToolEvaluation {
    /// D: width of the tolerance band of single teeth about the compensation curve, um.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10_000, "x-way-out" = "give the width of the band in micrometres, e.g. 10"))]
    pub band_um: f64,
    /// Mean material that may be missing on a track before the tool counts as worn, um.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10_000, "x-way-out" = "give the limit in micrometres, e.g. 10"))]
    pub wear_limit_um: f64,
    /// Degree of the compensation curve; there must be more tracks.
    #[schemars(extend("minimum" = 0, "maximum" = 10, "x-way-out" = "give the degree; 2 is the default"))]
    pub curve_degree: usize,
    /// r_eff: radius of the beam at which a flank that runs into it switches, mm, where calibration knows it; default without
    /// correction. A measurement in both senses needs none.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 5, "x-way-out" = "give the radius in mm, near `light_barrier.radius`, or leave it out"))]
    pub switching_radius: Option<f64>,
    /// Settings that the correction may change.
    #[schemars(extend("uniqueItems" = true, "minItems" = 1))]
    pub settings: Vec<MachineSetting>,
    /// How far it may change them.
    pub limits: SettingBounds,
}

/// A setting of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum MachineSetting {
    /// d.
    CentreDistance,
    /// gamma.
    CrossedAxesAngle,
    /// z_V1; for a helical tool nearly the same as a turn of it.
    ToolShift,
    /// phi_1: the tool turned against its coupling.
    ToolAngle,
}

/// How far settings may be changed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct SettingBounds {
    /// Of d, mm.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100, "x-way-out" = "give the limit in mm; 0.05 is the default"))]
    pub centre_distance: f64,
    /// Of gamma, degrees.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10, "x-way-out" = "give the limit in degrees; 0.1 is the default"))]
    pub crossed_axes_angle_deg: f64,
    /// Of z_V1, mm.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100, "x-way-out" = "give the limit in mm; 0.5 is the default"))]
    pub tool_shift: f64,
    /// Of phi_1, degrees.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10, "x-way-out" = "give the limit in degrees; 0.1 is the default"))]
    pub tool_angle_deg: f64,
}

impl Default for ToolEvaluation {
    fn default() -> Self {
        Self {
            band_um: 10.0,
            wear_limit_um: 10.0,
            curve_degree: 2,
            switching_radius: None,
            settings: vec![
                MachineSetting::CentreDistance,
                MachineSetting::CrossedAxesAngle,
                MachineSetting::ToolAngle,
            ],
            limits: SettingBounds::default(),
        }
    }
}

impl Default for SettingBounds {
    fn default() -> Self {
        Self { centre_distance: 0.05, crossed_axes_angle_deg: 0.1, tool_shift: 0.5, tool_angle_deg: 0.1 }
    }
}

impl MachineSetting {
    /// The setting as the process has it.
    pub fn setting(self) -> Setting {
        match self {
            Self::CentreDistance => Setting::CentreDistance,
            Self::CrossedAxesAngle => Setting::CrossedAxesAngle,
            Self::ToolShift => Setting::ToolShift,
            Self::ToolAngle => Setting::ToolAngle,
        }
    }
}
