//! The field on which a flank is evaluated, as a file states it.

use serde::{Deserialize, Serialize};

/// The field on which a flank is evaluated; what is not stated is absent. Lengths in mm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FlankField {
    /// Diameter at the root end of the evaluated profile.
    pub start_diameter_mm: Option<f64>,
    /// Diameter at its tip end.
    pub end_diameter_mm: Option<f64>,
    /// Lower end along the face width, from its middle; absent: the face.
    pub z_start_mm: Option<f64>,
    /// Upper end along the face width; absent: the face.
    pub z_end_mm: Option<f64>,
}
