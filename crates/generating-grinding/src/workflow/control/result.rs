//! What the control leaves, with units in the key names.

use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// A line of a chart.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Trace {
    /// Tooth, from 0.
    pub tooth: usize,
    /// Deviations, um, normal, > 0 material left; at the places of the flank's `trace_w_mm` or `trace_z_mm`.
    pub f_um: Vec<f64>,
}

/// The angle's error over the stroke as it would stand on the flank, in stretches of time.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct ErrorTrace {
    /// z_V2 in the middle of each stretch, mm.
    pub feed_mm: Vec<f64>,
    /// Least and greatest setpoint error within it, um at the flank.
    pub setpoint_um: [Vec<f64>; 2],
    /// Least and greatest error of the workpiece within it, um at the flank.
    pub actual_um: [Vec<f64>; 2],
}

/// One flank of all teeth.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ControlFlankResult {
    /// Largest |deviation| by the control alone over all teeth, normal.
    pub largest_um: f64,
    /// Root mean square over all teeth.
    pub rms_um: f64,
    /// Deviation on the first tooth, normal, `[profile][helix]` on the grid of the job.
    pub topography_um: Vec<Vec<f64>>,
    /// Largest |simulated + control - target| over all teeth, normal.
    pub deviation_with_control_um: f64,
    /// Largest |simulated + control - target| over the tolerance at its place.
    pub tolerance_share: f64,
    /// Mean deviation of each tooth, normal: what a measurement of the pitch sees.
    pub tooth_means_um: Vec<f64>,
    /// Largest difference of the means of neighbouring teeth: single pitch deviation.
    pub single_pitch_um: f64,
    /// Greatest less least mean: total cumulative pitch deviation.
    pub cumulative_pitch_um: f64,
    /// Places of the profile traces, at mid face width.
    pub trace_w_mm: Vec<f64>,
    /// Places of the helix traces, at the middle of the roll.
    pub trace_z_mm: Vec<f64>,
    /// Profile traces of some teeth.
    pub profiles: Vec<Trace>,
    /// Helix traces of the same teeth.
    pub helices: Vec<Trace>,
    /// Largest difference of closed form and rays in time on a sample of places and teeth.
    pub model_difference_um: f64,
    /// Places of that sample.
    pub sample: usize,
    /// Error of the angle over the stroke.
    pub error: ErrorTrace,
    /// Mean error of the setpoint and of the workpiece, um at the flank; centring the tooth space removes it there.
    pub means_um: [f64; 2],
    /// Share of samples with the torque at its limit.
    pub torque_limited_share: f64,
    /// Greatest torque.
    pub greatest_torque_n_m: f64,
    /// Largest difference of the flanks that a stroke of either sense would leave by itself; absent where one sense grinds.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub senses_apart_um: Option<f64>,
}

/// The control and what it costs.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ControlResult {
    /// Speed of the worm.
    pub worm_speed_rpm: f64,
    /// Speed of the workpiece.
    pub work_speed_rpm: f64,
    /// Speed of the feed z_V2.
    pub feed_mm_per_min: f64,
    /// Distance of the lines of the feed's scale.
    pub scale_pitch_um: f64,
    /// Movement of the flank for one part of the setpoint, 1/P workpiece pulse.
    pub setpoint_step_um: f64,
    /// Movement of the flank for one count of the workpiece's encoder.
    pub encoder_step_um: f64,
    /// What the ratio of the additional rotation is off by, um at the flank per metre of feed.
    pub ratio_error_um_per_m: f64,
    /// Flank per torque at the frequency of the threads, um per Nm.
    pub compliance_at_threads_um_per_n_m: f64,
    /// That frequency.
    pub thread_frequency_hz: f64,
    /// Flanks that are ground.
    pub flanks: BTreeMap<&'static str, ControlFlankResult>,
}
