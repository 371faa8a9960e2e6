//! The figures of a control, as the report takes them. Plain numbers with their units in the names.

use crate::charts::Topography;
use crate::data::Quantity;
use foundation::geometry::Sides;
use serde::Serialize;

/// Everything that a report shows of gearbox and servo.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ControlReport {
    /// Speeds, steps and stiffness.
    pub quantities: Vec<Quantity>,
    /// What they leave on each flank that is ground.
    pub flanks: Sides<Option<ControlFlankReport>>,
}

/// One flank of all teeth.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ControlFlankReport {
    /// Largest |deviation| by the control alone, um.
    pub largest_um: f64,
    /// Root mean square, um.
    pub rms_um: f64,
    /// Largest |deviation from the target| with it, um.
    pub with_control_um: f64,
    /// Single and total cumulative pitch deviation, um.
    pub pitch_um: [f64; 2],
    /// Closed form against rays in time, um, and on how many places.
    pub model_difference_um: (f64, usize),
    /// Greatest torque, Nm, and share of samples at its limit.
    pub torque_n_m: (f64, f64),
    /// Deviation on the first tooth by the control alone.
    pub first_tooth: Topography,
    /// Profile traces at mid face width.
    pub profiles: Vec<ToothTrace>,
    /// Helix traces at the middle of the roll.
    pub helices: Vec<ToothTrace>,
    /// Mean deviation of each tooth, um.
    pub tooth_means_um: Vec<f64>,
    /// z_V2 of stretches of the stroke, mm.
    pub feed_mm: Vec<f64>,
    /// Least and greatest error of the setpoint in each, um at the flank.
    pub setpoint_um: [Vec<f64>; 2],
    /// Least and greatest error of the workpiece in each, um at the flank.
    pub actual_um: [Vec<f64>; 2],
}

/// A trace of one tooth.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ToothTrace {
    /// Tooth, from 0.
    pub tooth: usize,
    /// Length of roll or axial position, mm.
    pub coordinate_mm: Vec<f64>,
    /// Deviation, um, normal.
    pub f_um: Vec<f64>,
}
