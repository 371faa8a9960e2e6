//! Axes as other systems choose them (spec 50 section 14), to be laid beside the column plane's: along the parameter lines of the
//! flank, or along lines that a patched surface has made wavy.

use super::LeadPoint;
use crate::geometry::SurfaceJet;
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// How the axis is found along a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AxisChoice {
    /// Along the lines of constant length parameter.
    ParameterLines,
    /// Along lines sheared by eps L sin(2 pi x), linear over the height, as irregular patches have them.
    ShearedLines {
        /// eps: share of the face.
        shear: f64,
        /// L: length of the face in the length parameter.
        face: f64,
        /// From root to tip in the height parameter, signed.
        height: f64,
    },
}

/// The unit axis of another system at a place that lies at the share `along` (0..1) of its row; towards the shank.
pub fn other_axis(choice: AxisChoice, jet: &SurfaceJet, lead: &LeadPoint, along: f64) -> Vector3<f64> {
    let line = match choice {
        AxisChoice::ParameterLines => jet.by_height,
        AxisChoice::ShearedLines { shear, face, height } => {
            jet.by_height + jet.by_length * (shear * face * (TAU * along).sin() / height)
        }
    };
    let axis = line.normalize();
    if axis.dot(&lead.base_normal) < 0.0 { -axis } else { axis }
}
