//! The servo of the workpiece spindle: drive, gains and what disturbs it (`docs/mathematics/gearbox.md#position-loop`).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::disturbance::Disturbance;

/// The sampled position loop of the workpiece spindle and its drive. The gains follow from `bandwidth_hz` or are given.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Servo {
    /// Time from sample to sample, us.
    #[serde(default = "default_sample_time")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10_000,
        "x-way-out" = "give the sample time in microseconds, e.g. 125"))]
    pub sample_time_us: f64,
    /// Inertia of workpiece, clamping and spindle, kg m^2.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e6,
        "x-way-out" = "give the inertia about the workpiece axis in kg m^2, e.g. 0.12"))]
    pub inertia_kg_m2: f64,
    /// Viscous friction, N m s/rad.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 1e6, "x-way-out" = "give the viscous friction in N m s/rad, or leave it out"))]
    pub damping_n_m_s: f64,
    /// Coulomb friction, N m.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 1e6, "x-way-out" = "give the Coulomb friction in N m, or leave it out"))]
    pub friction_n_m: f64,
    /// Speed over which Coulomb friction changes its sign, rad/s: friction_n_m tanh(speed/friction_speed_rad_per_s).
    #[serde(default = "default_friction_speed")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e6,
        "x-way-out" = "give a speed in rad/s, or leave it out for 0.05"))]
    pub friction_speed_rad_per_s: f64,
    /// Greatest torque of the drive, N m.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e6, "x-way-out" = "give the greatest torque of the drive in N m"))]
    pub torque_limit_n_m: f64,
    /// Bandwidth from which the gains follow: three equal poles at this frequency, Hz.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e5, "x-way-out" = "give the bandwidth in Hz, e.g. 40"))]
    pub bandwidth_hz: Option<f64>,
    /// The gains themselves, in place of `bandwidth_hz`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gains: Option<ServoGains>,
    /// Share of the torque that setpoint and friction ask for and that is fed forward.
    #[serde(default = "default_feed_forward")]
    #[schemars(extend("minimum" = 0, "maximum" = 1, "x-way-out" = "give a share from 0 (none) to 1 (all)"))]
    pub feed_forward: f64,
    /// Whether the loop sees whole counts only, as an encoder gives them.
    #[serde(default = "default_quantised")]
    pub quantised: bool,
    /// Torques that disturb the workpiece spindle; they add up.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(max = 50))]
    pub disturbances: Vec<Disturbance>,
}

/// Gains of the loop.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ServoGains {
    /// Torque per error of the angle, N m/rad.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1e15, "x-way-out" = "give the proportional gain in N m/rad, more than 0"))]
    pub proportional_n_m_per_rad: f64,
    /// Growth of the torque per error of the angle, N m/(rad s).
    #[schemars(extend("minimum" = 0, "maximum" = 1e15, "x-way-out" = "give the integral gain in N m/(rad s); 0: none"))]
    pub integral_n_m_per_rad_s: f64,
    /// Torque per error of the speed, N m s/rad.
    #[schemars(extend("minimum" = -1e15, "maximum" = 1e15, "x-way-out" = "give the derivative gain in N m s/rad; 0: none"))]
    pub derivative_n_m_s_per_rad: f64,
}

fn default_sample_time() -> f64 {
    125.0
}

fn default_friction_speed() -> f64 {
    0.05
}

fn default_feed_forward() -> f64 {
    1.0
}

fn default_quantised() -> bool {
    true
}
