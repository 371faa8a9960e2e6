//! What is measured tooth by tooth: pitch, run-out, sizes over teeth and balls, tip and root circle.

use serde::{Deserialize, Serialize};

use super::conditions::CountingDirection;
use super::undefined;
use foundation::geometry::{Flank, Sides};

/// Pitch deviations of one flank side, tooth 1 first.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FlankPitch {
    /// Single pitch deviations f_p, um; NaN = not measured.
    #[serde(with = "undefined")]
    pub fp_um: Vec<f64>,
    /// Cumulative pitch deviations F_p as the file has them, um.
    #[serde(rename = "Fp_um", with = "undefined")]
    pub cumulative_um: Vec<f64>,
}

/// Pitches of a gear.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pitch {
    /// Deviations; `None` for a side that was not measured.
    pub flanks: Sides<Option<FlankPitch>>,
    /// Diameter on which they were measured, mm.
    pub diameter_mm: Option<f64>,
    /// The sense in which the teeth are numbered.
    pub counting: Option<CountingDirection>,
    /// Probe positions they came from, where the file has them.
    pub positions: Vec<super::ProbePosition>,
}

/// Run-out.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RunOut {
    /// Radial deviations F_r of the spaces, first space first, um.
    #[serde(rename = "Fr_um", with = "undefined")]
    pub fr_um: Vec<f64>,
    /// Diameter of the ball, mm.
    pub ball_diameter_mm: Option<f64>,
}

/// A size with its spread over the gear, mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Size {
    /// Mean.
    pub mean_mm: Option<f64>,
    /// Smallest.
    pub least_mm: Option<f64>,
    /// Largest.
    pub largest_mm: Option<f64>,
}

/// Measures of the tooth thickness.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Thickness {
    /// Span W_k.
    pub span: Option<Size>,
    /// Teeth spanned.
    pub span_teeth: Option<u32>,
    /// Measure over balls M_dK.
    pub over_balls: Option<Size>,
    /// Diameter of the balls, mm.
    pub ball_diameter_mm: Option<f64>,
}

/// Diameters of a circle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Circle {
    /// Height z at which it was measured, from the middle of the face width, mm.
    pub z_mm: f64,
    /// Diameters, mm.
    #[serde(with = "undefined")]
    pub diameters_mm: Vec<f64>,
}

/// Root and tip circle.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Circles {
    /// Root circle.
    pub root: Option<Circle>,
    /// Tip circle.
    pub tip: Option<Circle>,
}

/// A position of the probe while it touched a flank.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ProbePosition {
    /// Number of the tooth in the list.
    pub number: u32,
    /// The flank.
    pub flank: Flank,
    /// Angle of the table, degree.
    pub angle_deg: f64,
    /// Centre of the ball, mm.
    pub centre_mm: [f64; 3],
}
