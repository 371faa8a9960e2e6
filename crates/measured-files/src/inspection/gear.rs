//! The gear that was measured, as the header of its file describes it.

use serde::{Deserialize, Serialize};

use super::InspectionError;
use foundation::geometry::{Gear, GearData, GeometryError, Sides};

/// Drawing data of a measured gear.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct InspectedGear {
    /// Number of teeth, < 0 internal.
    pub teeth: i32,
    /// Normal module, mm.
    pub normal_module_mm: f64,
    /// Normal pressure angle, degree.
    pub normal_pressure_angle_deg: f64,
    /// Helix angle, degree, > 0 right-handed.
    pub helix_angle_deg: f64,
    /// Profile shift coefficient of the header. It need not describe the thickness of the tooth: that comes from span or balls.
    pub profile_shift: Option<f64>,
    /// Face width, mm.
    pub face_width_mm: Option<f64>,
    /// Tip diameter, mm.
    pub tip_diameter_mm: Option<f64>,
    /// Root diameter, mm.
    pub root_diameter_mm: Option<f64>,
}

impl InspectedGear {
    /// The body with a profile shift of the caller's choice; base circles and lengths of roll do not depend on it.
    ///
    /// # Errors
    /// Those of [`Gear::new`].
    pub fn gear(&self, profile_shift: f64) -> Result<Gear, GeometryError> {
        Gear::new(GearData {
            teeth: self.teeth,
            normal_module: self.normal_module_mm,
            pressure_angle: Sides::both(self.normal_pressure_angle_deg.to_radians()),
            helix_angle: self.helix_angle_deg.to_radians(),
            profile_shift,
            cone_angle: 0.0,
        })
    }

    /// The body without profile shift, checked.
    ///
    /// # Errors
    /// [`InspectionError::BadInput`] naming what makes no gear.
    pub fn checked(&self) -> Result<Gear, InspectionError> {
        let bad = |what: &str, value: f64, allowed| {
            Err(InspectionError::BadInput { what: what.into(), value, allowed })
        };
        if self.teeth == 0 {
            return bad("number of teeth", 0.0, "an integer other than 0");
        }
        if !(self.normal_module_mm.is_finite() && self.normal_module_mm > 0.0) {
            return bad("normal module", self.normal_module_mm, "> 0 mm");
        }
        if let Some(b) = self.face_width_mm
            && !(b.is_finite() && b > 0.0)
        {
            return bad("face width", b, "> 0 mm");
        }
        self.gear(0.0).or_else(|error| match error {
            GeometryError::InvalidNumber { field, value, allowed } => bad(field, value, allowed),
            _ => bad("normal pressure angle", self.normal_pressure_angle_deg, "one that makes an involute"),
        })
    }
}
